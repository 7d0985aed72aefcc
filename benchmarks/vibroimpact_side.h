// The program's own time integration as one side of a comparison.
#pragma once

#include "contact/contact_set.h"
#include "measurement.h"
#include "model/model.h"

namespace vibroimpact::benchmarks {

struct Problem {
  Model model;
  ContactSet contacts;
  Vector displacement; ///< at t = 0
  Vector velocity;
  double end = 0;             ///< [s]
  double event_tolerance = 0; ///< [s]
};

/// A body with one coordinate per entry, whose only point "head" moves along x by `row` . q.
std::shared_ptr<const ReducedBody> body_along_x(const std::string &name, const Vector &mass,
                                                const Vector &stiffness, const Vector &damping,
                                                const Vector &row);

/// Contact of two heads, or of one and a fixed stop when `other` is empty.
ContactPair contact_of_heads(const Model &model, const std::string &body, const std::string &other,
                             double clearance, std::shared_ptr<const ContactLaw> law);

Side vibroimpact_side(const Problem &problem);

} // namespace vibroimpact::benchmarks
