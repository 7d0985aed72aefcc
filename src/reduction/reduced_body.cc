#include "reduction/reduced_body.h"

#include <stdexcept>

namespace vibroimpact {

Vector ReducedBody::damping_ratio() const {
  const Vector frequency = omega();
  Vector ratio = Vector::Zero(size());
  for (Index j = 0; j < size(); ++j)
    if (frequency[j] > 0)
      ratio[j] = damping(j, j) / (2 * mass[j] * frequency[j]);
  return ratio;
}

Vector ReducedBody::flexibility_share(const BodyPoint &point) const {
  if (point.flexibility.size() == 0)
    return {};
  const Vector carried =
      point.rows.topRows(3).cwiseAbs2() * stiffness.cwiseInverse(); // sum of row^2 / k
  Vector share = Vector::Ones(3); // of what cannot move, all is carried
  for (Index axis = 0; axis < 3; ++axis)
    if (point.flexibility[axis] > 0)
      share[axis] = carried[axis] / point.flexibility[axis];
  return share;
}

Matrix ReducedBody::effective_mass() const {
  return mass.cwiseInverse().asDiagonal() * base_participation.cwiseAbs2();
}

const BodyPoint &ReducedBody::point(const std::string &point_name) const {
  for (const BodyPoint &candidate : points)
    if (candidate.name == point_name)
      return candidate;
  throw std::logic_error("body " + name + " has no point " + point_name);
}

} // namespace vibroimpact
