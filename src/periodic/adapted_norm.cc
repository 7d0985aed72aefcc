#include "periodic/adapted_norm.h"

#include "common/decompositions.h"
#include "common/error.h"

#include <stdexcept>

namespace vibroimpact::periodic {

namespace {
constexpr int most_doublings = 60;
} // namespace

double spectral_radius(const Matrix &a) {
  return a.size() > 0 ? eigenvalues(a).cwiseAbs().maxCoeff() : 0;
}

Matrix discrete_lyapunov(const Matrix &a) {
  Matrix sum = Matrix::Identity(a.rows(), a.cols());
  Matrix power = a;
  // The sum of the first 2^k terms; what is left is below the square of the last power.
  for (int k = 0; k < most_doublings && power.norm() > 1e-20; ++k) {
    sum += (power.transpose() * sum * power).eval();
    power = (power * power).eval();
  }
  return sum;
}

AdaptedNorm::AdaptedNorm(const Matrix &by_state, double multiplier) : multiplier_(multiplier) {
  if (!(multiplier_ < 1))
    throw std::logic_error("only about a stable fixed point does a map contract");
  const auto root = cholesky(discrete_lyapunov(by_state / contraction()));
  if (!root)
    throw NumericalError("the norm in which the map contracts is lost to rounding");
  root_ = *root;
}

} // namespace vibroimpact::periodic
