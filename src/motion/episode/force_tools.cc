#include "motion/episode/force_tools.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

namespace {

// The inner points are those of the Gauss rule of x (1 - x); a weight of that rule is the Lobatto
// weight times x (1 - x), and the ends have 1 / (n (n - 1)) of n points (Davis and Rabinowitz 1984,
// section 2.7).
GaussRule lobatto_rule(int inner) {
  const GaussRule gauss = JacobiPolynomials(1, 1, inner).rule();
  const int count = inner + 2;
  GaussRule rule{.nodes = LongArray(count), .rest = LongArray(count), .weights = LongArray(count)};
  rule.nodes << 0, gauss.nodes, 1;
  rule.rest << 1, gauss.rest, 0;
  const long double end = 1.0L / (static_cast<long double>(count) * (count - 1));
  rule.weights << end, gauss.weights.cwiseQuotient(gauss.nodes.cwiseProduct(gauss.rest)), end;
  return rule;
}

// Points next to an end, from there on, as parts of the step: where a force goes like x^n the
// velocity goes like x^(n + 1), of which a polynomial of degree 7 misses 1e-2 h^(n + 1) in a first
// step of length h. Forces that are smooth there need no more than others.
LongArray points_next_to(double power, int root) {
  constexpr double last = 0.0145;
  constexpr double longest = 0.0045;
  constexpr double missed = 1.4e-8;
  const bool smooth = root == 1 && power == std::floor(power);
  const double first =
      smooth ? longest : std::min(longest, std::pow(100 * missed, 1 / (power + 1)));
  const auto count = static_cast<Eigen::Index>(std::ceil(std::log(last / first) / std::log(4.0)));
  LongArray points(count + 1);
  for (Eigen::Index i = 0; i <= count; ++i)
    points[i] = static_cast<long double>(
        first * std::pow(last / first, static_cast<double>(i) / static_cast<double>(count)));
  return points;
}

GaussRule shown_rule(const ForceShape &shape, int lobatto_points) {
  const LongArray added = points_next_to(shape.begin, shape.begin_root);
  const LongArray from_end = points_next_to(shape.end, shape.end_root).reverse();
  const GaussRule lobatto = lobatto_rule(lobatto_points);
  const Eigen::Index last = lobatto.nodes.size() - 1;
  const auto with_added = [&](const LongArray &list, const LongArray &first,
                              const LongArray &second) {
    LongArray longer(list.size() + first.size() + second.size());
    longer << list[0], first, list.segment(1, last - 1), second, list[last];
    return longer;
  };
  const auto beside = [](const LongArray &parts) { return LongArray(1 - parts.array()); };
  return {.nodes = with_added(lobatto.nodes, added, beside(from_end)),
          .rest = with_added(lobatto.rest, beside(added), from_end),
          .weights = with_added(lobatto.weights, LongArray::Zero(added.size()),
                                LongArray::Zero(from_end.size()))};
}

/// Of the points of a rule in x but `skipped` at each end.
std::vector<long double> targets_of(const GaussRule &rule, const EpisodeTime &stretch,
                                    Eigen::Index skipped) {
  std::vector<long double> targets;
  for (Eigen::Index i = skipped; i + skipped < rule.nodes.size(); ++i)
    targets.push_back(stretch.inverse(rule.nodes[i], rule.rest[i]));
  return targets;
}

} // namespace

ShownPoints::ShownPoints(const ForceFamily &family, int inner_lobatto_points)
    : rule(shown_rule(family.shape(), inner_lobatto_points)),
      between(family, targets_of(rule, family.stretch(), 1)) {}

QuadraturePoints::QuadraturePoints(const ForceFamily &family, int count)
    : rule(JacobiPolynomials(0, 0, count).rule()),
      at_nodes(family, targets_of(rule, family.stretch(), 0)) {}

ForceTools::ForceTools(const ForceShape &shape)
    : family(shape), at_nodes(family, ForceOperators::nodes_and_end(family)) {}

ShownPoints &ForceTools::shown(int inner) {
  std::unique_ptr<ShownPoints> &made = shown_[inner];
  if (!made)
    made = std::make_unique<ShownPoints>(family, inner);
  return *made;
}

QuadraturePoints &ForceTools::quadrature(int points) {
  std::unique_ptr<QuadraturePoints> &made = quadratures_[points];
  if (!made)
    made = std::make_unique<QuadraturePoints>(family, points);
  return *made;
}

ForceTools &force_tools(const ForceShape &shape) {
  static std::map<ForceShape, std::unique_ptr<ForceTools>> made;
  std::unique_ptr<ForceTools> &tools = made[shape];
  if (!tools)
    tools = std::make_unique<ForceTools>(shape);
  return *tools;
}

} // namespace vibroimpact::motion
