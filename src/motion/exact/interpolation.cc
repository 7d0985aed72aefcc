#include "motion/exact/interpolation.h"

#include <Eigen/LU>

#include <cmath>

namespace vibroimpact::motion {

namespace {

using Matrix8 = Eigen::Matrix<long double, 8, 8>;

long double binomial(int n, int k) {
  long double value = 1;
  for (int i = 1; i <= k; ++i)
    value = value * (n - k + i) / i;
  return value;
}

InterpolationMatrix make() {
  Matrix8 powers = Matrix8::Zero();
  powers.topLeftCorner<3, 3>().setIdentity();
  for (int i = 0; i < 5; ++i)
    for (int k = 0; k < 8; ++k)
      powers(3 + i, k) = std::pow(static_cast<long double>(interpolation_nodes[i]), k);
  Matrix8 to_bernstein = Matrix8::Zero(); // b_i = sum over k <= i of C(i, k) / C(7, k) a_k
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k <= i; ++k)
      to_bernstein(i, k) = binomial(i, k) / binomial(7, k);
  const Matrix8 both = to_bernstein * powers.inverse();
  InterpolationMatrix result{};
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k < 8; ++k)
      result[i][k] = static_cast<double>(both(i, k));
  return result;
}

} // namespace

const InterpolationMatrix &interpolation_matrix() {
  static const InterpolationMatrix matrix = make();
  return matrix;
}

} // namespace vibroimpact::motion
