#include "motion/variation/exponential_action.h"

#include "common/error.h"

#include <cmath>

namespace vibroimpact::motion {

namespace {

constexpr int terms = 40;
constexpr double largest_part = 3;
constexpr double most_parts = 1e7;

long parts(double radius, double h) {
  const double count = std::ceil(radius * std::abs(h) / largest_part);
  if (!(count <= most_parts))
    throw NumericalError("the variation of the motion has rates too large for a step of " +
                         std::to_string(h) + " s");
  return std::max(1L, static_cast<long>(count));
}

// Terms that no longer change any entry of the sum.
bool negligible(const Matrix &term, const Matrix &sum) {
  return (term.array().abs() <= 1e-18 * sum.array().abs()).all();
}

} // namespace

Matrix exponential_action(const Matrix &matrix, double radius, double h, const Matrix &columns) {
  const long count = parts(radius, h);
  const double part = h / static_cast<double>(count);
  Matrix sum = columns;
  Matrix term;
  for (long i = 0; i < count; ++i) {
    term = sum;
    for (int m = 1; m <= terms; ++m) {
      term = (part / m) * (matrix * term).eval();
      sum += term;
      if (negligible(term, sum))
        break;
    }
  }
  return sum;
}

// [z, dz] obeys dz' = M dz + dM z.
Matrix exponential_tangent(const Matrix &matrix, const std::vector<Matrix> &changes, double radius,
                           double h, const Vector &z, const Matrix &start) {
  const long count = parts(radius, h);
  const double part = h / static_cast<double>(count);
  Matrix sum(z.size(), start.cols() + 1);
  sum << z, start;
  Matrix term;
  Matrix next(sum.rows(), sum.cols());
  for (long i = 0; i < count; ++i) {
    term = sum;
    for (int m = 1; m <= terms; ++m) {
      next.noalias() = matrix * term;
      for (std::size_t k = 0; k < changes.size(); ++k)
        next.col(static_cast<Index>(k) + 1) += changes[k] * term.col(0);
      term = (part / m) * next;
      sum += term;
      if (negligible(term, sum))
        break;
    }
  }
  return sum.rightCols(start.cols());
}

} // namespace vibroimpact::motion
