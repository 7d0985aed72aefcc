// Differences of models by a key: weights, and what must hold for them to mean something.
#pragma once

#include "contact/contact_set.h"
#include "model/model.h"

#include <vector>

namespace vibroimpact::motion {

/// Weights w of f(p + d_i) - f(p) for df/dp, exact for polynomials of as high a degree as there are
/// offsets d, which differ from each other and from zero.
Vector derivative_weights(const std::vector<double> &offsets);

/// Numbers that models must share to be compared: sizes, modes and guards of laws.
std::vector<std::size_t> structure_of(const model::Model &model,
                                      const contact::ContactSet &contacts);

/// The numbers that a model and its contacts are made of, one kind of quantity after the other;
/// sources by their loads alone.
struct ModelData {
  std::vector<double> numbers;
  std::vector<std::size_t> ends; ///< of each kind, in `numbers`

  bool operator==(const ModelData &) const = default;
};
ModelData data_of(const model::Model &model, const contact::ContactSet &contacts);

/// True when the derivative from all neighbours is that from the two nearest ones up to 3e-5 of the
/// largest entry of a kind: since the latter leaves c d^2, the former then leaves about (c d^2)^2 <
/// 1e-9.
bool is_smooth(const std::vector<double> &offsets, const ModelData &present,
               const std::vector<ModelData> &neighbours);

} // namespace vibroimpact::motion
