#include "motion/collocation/force_operators.h"

#include <cmath>

namespace vibroimpact::motion {

namespace {

// The distance of the other end's singularity makes the Gauss rule converge like rho^(-2 points),
// rho > 1.2 for the last of 20 nodes.
constexpr int points = 96;

} // namespace

ForceOperators::ForceOperators(const ForceFamily &family, std::vector<long double> targets)
    : family_(family), targets_(std::move(targets)) {
  const ForceShape &shape = family.shape();
  const GaussRule inside = JacobiPolynomials(shape.begin, 0, points).rule();
  const GaussRule whole = JacobiPolynomials(shape.begin, shape.end, points).rule();
  for (const long double target : targets_)
    integrands_.push_back(target == 1 ? integrand(1, 0, whole)
                                      : integrand(target, shape.end, inside));
}

std::vector<long double> ForceOperators::nodes_and_end(const ForceFamily &family) {
  std::vector<long double> targets(family.rule().nodes.begin(), family.rule().nodes.end());
  targets.push_back(1);
  return targets;
}

// With y = X s: dy = X ds, and y^alpha = X^alpha times the weight of the rule.
ForceOperators::Integrand ForceOperators::integrand(long double target, double end,
                                                    const GaussRule &rule) const {
  Integrand made{.distance = target * rule.rest, .factors = LongMatrix(points, family_.size())};
  const long double scale = std::pow(target, static_cast<long double>(family_.shape().begin) + 1);
  for (int q = 0; q < points; ++q) {
    const long double y = target * rule.nodes[q];
    const long double fading = std::pow(1 - y, static_cast<long double>(end));
    made.factors.row(q) = scale * rule.weights[q] * fading * family_.quotients(y).transpose();
  }
  return made;
}

void ForceOperators::require(int count) {
  if (count <= n_terms_)
    return;
  const Index nodes = family_.size();
  terms_.conservativeResize(n_targets(), nodes * count);
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const Integrand &of = integrands_[i];
    LongArray power = LongArray::Ones(points);
    for (int k = 0; k < count; ++k) {
      if (k > 0)
        power = power.cwiseProduct(of.distance) / static_cast<long double>(k);
      if (k >= n_terms_)
        terms_.block(static_cast<Index>(i), k * nodes, 1, nodes) =
            (power.transpose() * of.factors).cast<double>();
    }
  }
  n_terms_ = count;
}

} // namespace vibroimpact::motion
