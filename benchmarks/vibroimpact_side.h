// The program's own time integration as one side of a comparison.
#pragma once

#include "contact/contact_set.h"
#include "measurement.h"
#include "model/model.h"

namespace vibroimpact::benchmarks {

struct Problem {
  model::Model model;
  contact::ContactSet contacts;
  model::Projection recorded;
  double end = 0; ///< [s]
};

/// A body with one coordinate per entry, whose only point "head" moves along x by `row` . q.
std::shared_ptr<const reduction::ReducedBody>
body_along_x(const std::string &name, const Vector &mass, const Vector &stiffness,
             const Vector &damping, const Vector &row);

/// Contact of two heads, or of one and a fixed stop when `other` is empty; `sense` 1 or -1 along x.
contact::ContactPair contact_of_heads(const model::Model &model, const std::string &body,
                                      const std::string &other, double sense, double clearance,
                                      std::shared_ptr<const contact::ContactLaw> law);

/// q, v and the contacts' internal states after `periods` of length `period` from rest.
Vector settled(const Problem &problem, double period, long periods);

/// `method` as in the section Integration.
Side vibroimpact_side(const std::string &name, const std::string &method, const Problem &problem,
                      const Vector &start);

} // namespace vibroimpact::benchmarks
