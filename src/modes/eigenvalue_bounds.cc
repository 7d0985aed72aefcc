#include "modes/eigenvalue_bounds.h"

#include "common/scalar.h"

namespace vibroimpact::modes {

Vector quadratic_bounds(const Vector &values, double shift, double gap,
                        const Matrix &residual_products) {
  const Vector t = (values.array() - shift).inverse();
  const double g = 1 / (gap - shift);
  if (!(t[t.size() - 1] > g))
    return Vector::Constant(t.size(), infinity);
  // T^(-1/2) E^T E T^(-1/2). The Frobenius norm is no smaller than that of the operator.
  const Matrix relative = t.asDiagonal() * residual_products * t.asDiagonal();
  const Vector scale = (t.array() / (t.array() - g)).sqrt();
  const double b = g + (scale.asDiagonal() * relative * scale.asDiagonal()).norm();
  Vector bounds(t.size());
  for (Index j = 0; j < t.size(); ++j) {
    const Index behind = t.size() - j;
    bounds[j] =
        t[j] > b ? relative.bottomRightCorner(behind, behind).norm() / (t[j] - b) : infinity;
  }
  return bounds;
}

} // namespace vibroimpact::modes
