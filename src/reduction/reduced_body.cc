#include "reduction/reduced_body.h"

#include "reduction/known_flexibility.h"

#include <stdexcept>

namespace vibroimpact::reduction {

double squared_von_mises(const double *stress, Index components) {
  const auto square = [](double x) { return x * x; };
  if (components == 3)
    return stress[0] * stress[0] - stress[0] * stress[1] + stress[1] * stress[1] +
           3 * stress[2] * stress[2];
  return (square(stress[0] - stress[1]) + square(stress[1] - stress[2]) +
          square(stress[2] - stress[0])) /
             2 +
         3 * (square(stress[3]) + square(stress[4]) + square(stress[5]));
}

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
