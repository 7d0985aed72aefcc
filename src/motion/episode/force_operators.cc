#include "motion/episode/force_operators.h"

#include <cmath>

namespace vibroimpact::motion {

namespace {

// The distance of the other end's singularity makes the Gauss rule converge like rho^(-2 points),
// rho > 1.2 for the last of 20 nodes and 1.1 for that of 32.
int points_for(const ForceFamily &family) { return family.size() > 20 ? 192 : 96; }

} // namespace

ForceOperators::ForceOperators(const ForceFamily &family, std::vector<long double> targets)
    : family_(family), targets_(std::move(targets)) {
  const int points = points_for(family);
  const GaussRule inside = JacobiPolynomials(family.begin_power(), 0, points).rule();
  const GaussRule whole =
      JacobiPolynomials(family.begin_power(), family.end_power(), points).rule();
  for (const long double target : targets_)
    integrands_.push_back(target == 1 ? integrand(1, 0, whole)
                                      : integrand(target, family.end_power(), inside));
}

std::vector<long double> ForceOperators::nodes_and_end(const ForceFamily &family) {
  std::vector<long double> targets(family.rule().nodes.begin(), family.rule().nodes.end());
  targets.push_back(1);
  return targets;
}

// With xi = Xi s: w dy is Xi^(power + 1) times the weight of the rule, times what is smooth.
ForceOperators::Integrand ForceOperators::integrand(long double target, double end,
                                                    const GaussRule &rule) const {
  const auto points = static_cast<int>(rule.nodes.size());
  Integrand made{.distance = LongArray(points), .factors = LongMatrix(points, family_.size())};
  const long double scale = std::pow(target, static_cast<long double>(family_.begin_power()) + 1);
  const long double behind = family_.stretch().at(target, 1 - target).rest;
  for (int q = 0; q < points; ++q) {
    const long double xi = target * rule.nodes[q];
    const long double left = target == 1 ? rule.rest[q] : 1 - xi;
    const long double fading =
        std::pow(left, static_cast<long double>(end)) * family_.smooth_weight(xi, left);
    made.distance[q] = family_.stretch().at(xi, left).rest - behind;
    made.factors.row(q) = scale * rule.weights[q] * fading * family_.quotients(xi).transpose();
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
    LongArray power = LongArray::Ones(of.distance.size());
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
