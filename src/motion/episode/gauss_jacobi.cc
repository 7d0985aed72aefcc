#include "motion/episode/gauss_jacobi.h"

#include "common/decompositions.h"

#include <cmath>
#include <stdexcept>

namespace vibroimpact::motion {

using Long = long double;

// Of the weight (1 - t)^beta (1 + t)^alpha on [-1, 1] (Gautschi 2004, table 1.1), t = 2 x - 1.
JacobiPolynomials::JacobiPolynomials(double alpha, double beta, int count)
    : diagonal_(count), beside_(count) {
  if (!(alpha > -1 && beta > -1) || count < 1)
    throw std::invalid_argument("a Jacobi weight needs exponents above -1 and a node");
  const Long a = beta;
  const Long b = alpha;
  for (int k = 0; k < count; ++k) {
    const Long s = 2 * k + a + b;
    diagonal_[k] = 0.5L + 0.5L * (k == 0 ? (b - a) / (s + 2) : (b * b - a * a) / (s * (s + 2)));
    const Long n = k + 1;
    const Long t = 2 * n + a + b;
    // For n = 1 the factor n + a + b cancels against t - 1.
    const Long square = n == 1
                            ? 4 * (1 + a) * (1 + b) / (t * t * (t + 1))
                            : 4 * n * (n + a) * (n + b) * (n + a + b) / (t * t * (t + 1) * (t - 1));
    beside_[k] = 0.5L * std::sqrt(square);
  }
  const Long logarithm = std::lgamma(a + 1) + std::lgamma(b + 1) - std::lgamma(a + b + 2);
  first_ = std::exp(-0.5L * logarithm);
}

// Stieltjes' procedure (Gautschi 2004, section 2.2.3).
JacobiPolynomials::JacobiPolynomials(const GaussRule &weight, int count)
    : diagonal_(count), beside_(count), first_(1 / std::sqrt(weight.weights.sum())) {
  LongArray before = LongArray::Zero(weight.nodes.size());
  LongArray present = LongArray::Constant(weight.nodes.size(), first_);
  for (int k = 0; k < count; ++k) {
    const LongArray weighted = present.cwiseProduct(weight.weights);
    diagonal_[k] = weighted.cwiseProduct(present).dot(weight.nodes);
    LongArray next = (weight.nodes.array() - diagonal_[k]).matrix().cwiseProduct(present);
    if (k > 0)
      next -= beside_[k - 1] * before;
    beside_[k] = std::sqrt(next.cwiseProduct(next).dot(weight.weights));
    before = present;
    present = next / beside_[k];
  }
}

LongArray JacobiPolynomials::at(long double x) const {
  LongArray values(diagonal_.size());
  values[0] = first_;
  for (Eigen::Index k = 0; k + 1 < values.size(); ++k)
    values[k + 1] =
        ((x - diagonal_[k]) * values[k] - (k > 0 ? beside_[k - 1] * values[k - 1] : 0)) /
        beside_[k];
  return values;
}

// Newton's for the next polynomial, whose zeros the nodes are.
long double JacobiPolynomials::correction(long double x) const {
  Long before = 0;
  Long value = first_;
  Long slope_before = 0;
  Long slope = 0;
  for (Eigen::Index k = 0; k < diagonal_.size(); ++k) {
    const Long last = k > 0 ? beside_[k - 1] : 0;
    const Long next = ((x - diagonal_[k]) * value - last * before) / beside_[k];
    const Long next_slope = (value + (x - diagonal_[k]) * slope - last * slope_before) / beside_[k];
    before = value;
    slope_before = slope;
    value = next;
    slope = next_slope;
  }
  return value / slope;
}

GaussRule JacobiPolynomials::rule() const {
  const Eigen::Index n = diagonal_.size();
  GaussRule rule{.nodes = extended::tridiagonal_eigenvalues(diagonal_, beside_.head(n - 1)),
                 .rest = LongArray(n),
                 .weights = LongArray(n)};
  for (Eigen::Index j = 0; j < n; ++j) {
    rule.nodes[j] -= correction(rule.nodes[j]);
    rule.rest[j] = 1 - rule.nodes[j];
    rule.weights[j] = 1 / at(rule.nodes[j]).squaredNorm();
  }
  return rule;
}

} // namespace vibroimpact::motion
