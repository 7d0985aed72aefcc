#include "continuation/piece.h"

#include <boost/math/tools/toms748_solve.hpp>

namespace vibroimpact::continuation {

Hermite::Hermite(const Vector &begin, const Vector &begin_tangent, const Vector &end,
                 const Vector &end_tangent)
    : begin_{begin}, end_{end}, chord_{(end - begin).normalized()}, length_{(end - begin).norm()},
      begin_slope_{begin_tangent / begin_tangent.dot(chord_) * length_},
      end_slope_{end_tangent / end_tangent.dot(chord_) * length_} {}

Vector Hermite::at(double share) const {
  const double x = share, rest = 1 - share;
  return (1 + 2 * x) * rest * rest * begin_ + x * rest * rest * begin_slope_ +
         x * x * (3 - 2 * x) * end_ - x * x * rest * end_slope_;
}

// Both lie in the same hyperplane, so that Newton's method comes to the same point from each, from
// the cubic with fewer iterations. Where the two are far apart a graze may lie between.
Vector Hermite::beyond(double step) const {
  constexpr double far = 0.2; // over the step
  const Vector tangent = end_slope_.normalized();
  const Vector ahead = end_ + step * tangent;
  Vector cubic = at(1 + step / length_);
  cubic += tangent.dot(ahead - cubic) * tangent;
  return (cubic - ahead).norm() <= far * step ? cubic : ahead;
}

bool Hermite::turns_twice(Index unknown) const {
  const double rise = end_(unknown) - begin_(unknown);
  const double a = begin_slope_(unknown), b = end_slope_(unknown);
  // The slope is a + 2 (3 rise - 2 a - b) x + 3 (a + b - 2 rise) x^2 on [0, 1].
  const double linear = 3 * rise - 2 * a - b, quadratic = 3 * (a + b - 2 * rise);
  if (a * b <= 0 || quadratic == 0)
    return false;
  const double vertex = -linear / quadratic;
  return vertex > 0 && vertex < 1 && a * (a - linear * linear / quadratic) < 0;
}

Piece::Piece(const ScaledProblem &problem, const Settings &settings, Node begin, Node end)
    : problem_{problem}, settings_{settings}, begin_{std::move(begin)}, end_{std::move(end)},
      path_{begin_.u, begin_.tangent, end_.u, end_.tangent} {
  if (begin_.chart != end_.chart)
    throw std::logic_error("the ends of a segment have different charts");
}

Piece::Piece(const ScaledProblem &problem, const Settings &settings, Node begin, Node end,
             const ContactPath &contact)
    : Piece(problem, settings, std::move(begin), std::move(end)) {
  contact_.emplace(contact);
}

Node Piece::on_chord(double way) const {
  Corrected corrected =
      correct(problem_, path_.at(way), begin_.chart, path_.chord(),
              settings_.largest_correction * length(), settings_, Until::rounding);
  return make_node(problem_, corrected.u, begin_.chart, std::move(corrected.at), begin_.tangent);
}

Node Piece::in_contact(double way) const {
  const double from = contact_->first_share();
  const double share = contact_->depth() == Depth::grows ? way : 1 - way;
  return contact_->at(from + share * (1 - from));
}

Node Piece::at(double way) const {
  Node node = contact_ ? in_contact(way) : on_chord(way);
  node.arclength = begin_.arclength + (node.u - begin_.u).norm();
  return node;
}

bool Piece::key_turns_twice() const { return path_.turns_twice(problem_.states()); }

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
  const double closest = std::numeric_limits<double>::epsilon() * std::max(1.0, 1 / length());
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
