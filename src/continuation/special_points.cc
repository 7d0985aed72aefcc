#include "continuation/special_points.h"

#include "continuation/crossing_branches.h"

#include <algorithm>

namespace vibroimpact::continuation {

namespace {

using Test = double Tests::*;

// The conjugate pair nearest to the unit circle; its eigenvalue of positive imaginary part.
std::complex<double> critical_pair(const Node &node) {
  std::complex<double> best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto mu : node.multipliers)
    if (mu.imag() > 0 && std::abs(std::abs(mu) - 1) < least) {
      least = std::abs(std::abs(mu) - 1);
      best = mu;
    }
  return best;
}

// d(mu)/d(arclength) = w^T dJ v / (w^T v), with dJ by central differences along the tangent: the
// points are h^2 away from the branch, which changes J by as little as the formula leaves out.
std::complex<double> multiplier_rate(const ScaledProblem &problem, const Node &node,
                                     const Mode &mode) {
  constexpr double h = 1e-5;
  const auto jacobian = [&](double step) {
    return map_jacobian(problem.evaluate(node.u + step * node.tangent, node.chart));
  };
  const Matrix change = (jacobian(h) - jacobian(-h)) / (2 * h);
  const auto product = [&](const auto &a, const auto &b) { return (a.transpose() * b).value(); };
  return product(mode.left, Eigen::VectorXcd(change * mode.right)) / product(mode.left, mode.right);
}

// Real vector of length 1 of an eigenvector that is real up to a factor.
Vector real_part(const Eigen::VectorXcd &vector) {
  Index largest = 0;
  vector.cwiseAbs().maxCoeff(&largest);
  return (vector / vector(largest)).real().normalized();
}

void add_mode(const ScaledProblem &problem, const Node &node, SpecialPoint &special) {
  const bool pair = special.kind == Special::neimark_sacker;
  const Mode mode = nearest_mode(map_jacobian(node.at), pair ? critical_pair(node) : -1.0);
  const std::complex<double> rate = multiplier_rate(problem, node, mode);
  // d|mu| = Re(conj(mu) dmu) / |mu|
  const double rise =
      pair ? (std::conj(mode.value) * rate).real() / std::abs(mode.value) : rate.real();
  const Index key = problem.states();
  special.slope = rise / (node.tangent(key) * problem.scales()(key));
  if (pair) {
    special.angle = std::arg(mode.value);
    special.vector.resize(key, 2);
    special.vector << mode.right.real(), mode.right.imag();
  } else {
    special.vector = real_part(mode.right);
  }
}

bool changes_sign(const Piece &piece, Test test) {
  const double before = piece.begin().tests.*test, after = piece.end().tests.*test;
  return (before < 0) != (after < 0);
}

// Multipliers of a motion without losses keep mu_i mu_j = 1: the sign of a test that is zero for
// ever is that of rounding.
bool is_rounding(const Piece &piece) {
  constexpr double rounding = 1e-8;
  return std::abs(piece.begin().tests.pair) < rounding &&
         std::abs(piece.end().tests.pair) < rounding;
}

// On a branch that turns where another one crosses it, the turn is no fold: there F_x has two null
// vectors, and the hyperplanes of the location are singular. It is looked for beside the crossing
// only.
std::optional<Node> fold_beside(const ScaledProblem &problem, const Settings &settings,
                                const Piece &piece, const Vector &crossing) {
  constexpr double beside = 0.1; // of the piece
  const Vector chord = piece.end().u - piece.begin().u;
  const double way = chord.dot(crossing - piece.begin().u) / chord.squaredNorm();
  const auto fold = [](const Node &at) { return at.tests.fold; };
  const auto look = [&](const Node &begin, const Node &end) -> std::optional<Node> {
    const Piece part(problem, settings, begin, end);
    return changes_sign(part, &Tests::fold) ? part.zero_of(fold) : std::nullopt;
  };
  if (way > beside)
    if (auto found = look(piece.begin(), piece.at(way - beside)))
      return found;
  return way < 1 - beside ? look(piece.at(way + beside), piece.end()) : std::nullopt;
}

SpecialPoint crossing_point(const ScaledProblem &problem, const Piece &piece, Corrected crossing) {
  Node node = piece.begin();
  node.arclength += (crossing.u - node.u).norm();
  node.u = std::move(crossing.u);
  node.at = std::move(crossing.at);
  return make_special(problem, Special::branch_point, node, piece.begin(), piece.end());
}

} // namespace

SpecialPoint make_special(const ScaledProblem &problem, Special kind, const Node &node,
                          const Node &before, const Node &after) {
  SpecialPoint special;
  special.kind = kind;
  special.at = branch_point(problem, node);
  special.unstable_before = before.unstable;
  special.unstable_after = after.unstable;
  if (kind == Special::fold)
    special.vector = node.tangent.head(problem.states()).normalized();
  if (kind == Special::branch_point)
    special.vector = real_part(nearest_mode(map_jacobian(node.at), 1.0).right);
  if (kind == Special::flip || kind == Special::neimark_sacker)
    add_mode(problem, node, special);
  return special;
}

std::vector<SpecialPoint> special_points(const ScaledProblem &problem, const Piece &piece,
                                         const Settings &settings) {
  std::vector<SpecialPoint> found;
  const auto add = [&](Special kind, const std::optional<Node> &node) {
    if (node)
      found.push_back(make_special(problem, kind, *node, piece.begin(), piece.end()));
  };
  const auto zero = [&](Test test) {
    return piece.zero_of([test](const Node &at) { return at.tests.*test; });
  };
  std::optional<Corrected> crossing;
  if (changes_sign(piece, &Tests::branch))
    crossing = crossing_between(problem, piece, settings);
  if (crossing)
    found.push_back(crossing_point(problem, piece, *crossing));
  if (changes_sign(piece, &Tests::fold))
    add(Special::fold,
        crossing ? fold_beside(problem, settings, piece, crossing->u) : zero(&Tests::fold));
  if (changes_sign(piece, &Tests::flip))
    add(Special::flip, zero(&Tests::flip));
  if (changes_sign(piece, &Tests::pair) && !is_rounding(piece))
    if (const auto node = zero(&Tests::pair); node && node->tests.complex_pair)
      add(Special::neimark_sacker, node);
  std::stable_sort(found.begin(), found.end(),
                   [](const auto &a, const auto &b) { return a.at.arclength < b.at.arclength; });
  return found;
}

} // namespace vibroimpact::continuation
