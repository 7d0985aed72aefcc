#include "motion/collocation/force_tools.h"

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

// With two more points next to each end, where the motion is least like a polynomial.
GaussRule shown_rule(int lobatto_points) {
  const LongArray added = (LongArray(2) << 0.0045L, 0.0145L).finished(); // parts of the contact
  const LongArray from_end = added.reverse();
  const GaussRule lobatto = lobatto_rule(lobatto_points);
  const Eigen::Index last = lobatto.nodes.size() - 1;
  const auto with_added = [&](const LongArray &list, const LongArray &first,
                              const LongArray &second) {
    LongArray longer(list.size() + first.size() + second.size());
    longer << list[0], first, list.segment(1, last - 1), second, list[last];
    return longer;
  };
  const LongArray one = LongArray::Ones(added.size());
  const LongArray none = LongArray::Zero(added.size());
  return {.nodes = with_added(lobatto.nodes, added, one - from_end),
          .rest = with_added(lobatto.rest, one - added, from_end),
          .weights = with_added(lobatto.weights, none, none)};
}

std::vector<long double> inner_nodes(const GaussRule &rule) {
  return {rule.nodes.begin() + 1, rule.nodes.end() - 1};
}

} // namespace

ShownPoints::ShownPoints(const ForceFamily &family, int inner_lobatto_points)
    : rule(shown_rule(inner_lobatto_points)), between(family, inner_nodes(rule)) {}

QuadraturePoints::QuadraturePoints(const ForceFamily &family, int count)
    : rule(JacobiPolynomials(0, 0, count).rule()),
      at_nodes(family, {rule.nodes.begin(), rule.nodes.end()}) {}

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
