#include "reduction/reduced_body.h"

#include "reduction/known_flexibility.h"

#include <stdexcept>

namespace vibroimpact::reduction {

Vector ReducedBody::damping_ratio() const {
  const Vector frequency = omega();
  Vector ratio = Vector::Zero(size());
  for (Index j = 0; j < size(); ++j)
    if (frequency[j] > 0)
      ratio[j] = damping(j, j) / (2 * mass[j] * frequency[j]);
  return ratio;
}

double ReducedBody::flexibility_share(const BodyPoint &point, const Vector3 &direction) const {
  const double whole = flexibility_along(point, direction);
  const RowVector along = direction.transpose() * point.rows.topRows(3);
  return whole > 0 ? kept_flexibility(*this, along) / whole : 1;
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

} // namespace vibroimpact::reduction
