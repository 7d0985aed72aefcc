#include "continuation/piece.h"

#include <boost/math/tools/toms748_solve.hpp>

namespace vibroimpact::continuation {

Piece::Piece(const ScaledProblem &problem, const Settings &settings, Node begin, Node end,
             Root root)
    : problem_{problem}, settings_{settings}, begin_{std::move(begin)}, end_{std::move(end)},
      root_{root}, chord_{(end_.u - begin_.u).normalized()}, length_{(end_.u - begin_.u).norm()} {
  if (begin_.chart != end_.chart)
    throw std::logic_error("the ends of a piece have different charts");
}

double Piece::distance(double way) const {
  if (root_ == Root::at_begin)
    return length_ * way * way;
  if (root_ == Root::at_end)
    return length_ * (1 - (1 - way) * (1 - way));
  return length_ * way;
}

// Cubic Hermite polynomial in the distance along the chord; du/ds = t / (t . chord).
Vector Piece::guess(double distance) const {
  const double x = distance / length_, rest = 1 - x;
  const Vector begin_slope = begin_.tangent / begin_.tangent.dot(chord_) * length_;
  const Vector end_slope = end_.tangent / end_.tangent.dot(chord_) * length_;
  return (1 + 2 * x) * rest * rest * begin_.u + x * rest * rest * begin_slope +
         x * x * (3 - 2 * x) * end_.u - x * x * rest * end_slope;
}

Node Piece::at(double way) const {
  const double along = distance(way);
  Corrected corrected = correct(problem_, guess(along), begin_.chart, chord_, 0.5 * length_,
                                settings_, Until::rounding);
  Node node =
      make_node(problem_, corrected.u, begin_.chart, std::move(corrected.at), begin_.tangent);
  node.arclength = begin_.arclength + along;
  return node;
}

bool Piece::key_turns_twice() const {
  const Index last = begin_.u.size() - 1;
  const double rise = end_.u(last) - begin_.u(last);
  const double a = length_ * begin_.tangent(last) / begin_.tangent.dot(chord_);
  const double b = length_ * end_.tangent(last) / end_.tangent.dot(chord_);
  // p'(x) = a + 2 (3 rise - 2 a - b) x + 3 (a + b - 2 rise) x^2 on [0, 1].
  const double linear = 3 * rise - 2 * a - b, quadratic = 3 * (a + b - 2 * rise);
  if (a * b <= 0 || quadratic == 0)
    return false;
  const double vertex = -linear / quadratic;
  return vertex > 0 && vertex < 1 && a * (a - linear * linear / quadratic) < 0;
}

std::optional<Node> Piece::zero_of(const std::function<double(const Node &)> &test) const {
  const double first = test(begin_), last = test(end_);
  std::optional<Node> best;
  double least = std::numeric_limits<double>::infinity();
  const auto value = [&](double way) {
    Node node = at(way);
    const double tested = test(node);
    if (std::abs(tested) < least) {
      least = std::abs(tested);
      best = std::move(node);
    }
    return tested;
  };
  // Neither unknowns of size one nor ways differ by less than rounding.
  const double closest = std::numeric_limits<double>::epsilon() * std::max(1.0, 1 / length_);
  std::uintmax_t most = 60;
  boost::math::tools::toms748_solve(
      value, 0.0, 1.0, first, last, [&](double a, double b) { return b - a <= closest; }, most);
  // A zero is found to rounding of the test; across a jump the test stays as large as it is.
  constexpr double jump = 1e-4;
  if (least > jump * std::max(std::abs(first), std::abs(last)))
    return std::nullopt;
  return best;
}

} // namespace vibroimpact::continuation
