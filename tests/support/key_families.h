// Systems as functions of a key, for tests of derivatives by it.
#pragma once

#include "motion/variation/key_tangent.h"

#include <functional>
#include <utility>
#include <vector>

namespace vibroimpact::testing {

struct Parts {
  model::Model model;
  contact::ContactSet contacts{};
};

/// By a key of this value; `parts`: the system there.
inline motion::KeyTangent tangent_by_key(const std::function<Parts(double)> &make, double value,
                                         const Parts &parts) {
  std::vector<motion::KeyNeighbour> neighbours;
  for (const double place : {-2e-3, -1e-3, 1e-3, 2e-3}) {
    Parts near = make(value * (1 + place));
    neighbours.push_back(
        motion::KeyNeighbour::of(place * value, std::move(near.model), std::move(near.contacts)));
  }
  return {"key", parts.model, parts.contacts, std::move(neighbours)};
}

} // namespace vibroimpact::testing
