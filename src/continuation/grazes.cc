#include "continuation/grazes.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::continuation {

namespace {

double slope_along(const LocatedGraze &graze, const Vector &direction) {
  return graze.at.gradient.dot(direction);
}

bool is_open_at(const LocatedGraze &graze, const Node &node) {
  return slope_along(graze, node.u - graze.u) > 0;
}

// Derivatives on the side where the guard is open, or has just closed: there they jump by a matrix
// of rank one at corners, and have no limit at square roots.
std::optional<Linearisation> one_sided(const LocatedGraze &graze, bool open) {
  Linearisation at = graze.at.smooth;
  if (open || graze.at.touch == Touch::smooth)
    return at;
  if (graze.at.touch == Touch::corner && graze.at.jump.size() > 0) {
    at.slope += graze.at.jump * graze.at.gradient;
    return at;
  }
  return std::nullopt;
}

// A point of the branch so close to the graze that the signs of its tests are those of the limit.
Node close_to(const ScaledProblem &problem, const LocatedGraze &graze, const Node &other,
              const Vector &ahead, const Settings &settings) {
  const Vector chord = other.u - graze.u;
  for (const double share : {1e-8, 1e-6, 1e-4}) {
    try {
      Corrected corrected = correct(problem, graze.u + share * chord, graze.chart,
                                    chord.normalized(), share * chord.norm(), settings);
      return make_node(problem, corrected.u, graze.chart, std::move(corrected.at), ahead);
    } catch (const NumericalError &) {
    }
  }
  throw NumericalError("no solution is found close to the graze of " + graze.graze.name);
}

// The node at the graze for the part of the branch that leads to `other`.
Node node_towards(const ScaledProblem &problem, const LocatedGraze &graze, const Node &other,
                  const Vector &ahead, const Settings &settings) {
  auto at = one_sided(graze, is_open_at(graze, other));
  if (!at)
    return close_to(problem, graze, other, ahead, settings);
  return make_node(problem, graze.u, graze.chart, std::move(*at), ahead);
}

// Lengths of trials behind a graze: within the smallest ones even stiff contacts are smooth.
std::vector<double> trial_lengths() {
  std::vector<double> lengths;
  constexpr int count = 12; // down to 2e-10
  for (int i = 0; i < count; ++i)
    lengths.push_back(std::ldexp(1e-3, -2 * i));
  return lengths;
}

// Tangent on the contact side: of J at a point that is a little in contact, with the guard falling.
Vector tangent_in_contact(const ScaledProblem &problem, const LocatedGraze &graze,
                          const Vector &open_tangent, double depth) {
  const Vector inside = graze.u - depth * open_tangent;
  const Index n = problem.states();
  Matrix bordered(n + 1, n + 1);
  bordered << problem.evaluate(inside, graze.chart).slope, graze.at.gradient;
  return -solve_dense(bordered, Vector::Unit(n + 1, n)).normalized();
}

std::optional<Node> enter(const ScaledProblem &problem, const LocatedGraze &graze,
                          const Vector &tangent, double length, const Pattern &left,
                          const Settings &settings) {
  constexpr double agreement = 0.9; // cosine of the largest angle between both tangents
  Corrected corrected = correct(problem, graze.u + length * tangent, graze.chart, tangent,
                                settings.largest_correction * length, settings);
  if (corrected.at.pattern == left)
    return std::nullopt;
  Node node = make_node(problem, corrected.u, graze.chart, std::move(corrected.at), tangent);
  if (node.tangent.dot(tangent) < agreement)
    return std::nullopt;
  return node;
}

std::optional<Crossing> go_beyond(const ScaledProblem &problem, const LocatedGraze &graze,
                                  const Node &begin, const Settings &settings) {
  const bool gains = is_open_at(graze, begin);
  Vector open_tangent = tangent_of(graze.at.smooth.slope, begin.tangent);
  if (slope_along(graze, open_tangent) < 0)
    open_tangent = -open_tangent;
  for (const double length : trial_lengths())
    for (const double share : {1e-2, 1e-4}) {
      try {
        const Vector tangent =
            gains ? tangent_in_contact(problem, graze, open_tangent, share * length) : open_tangent;
        auto node = enter(problem, graze, tangent, length, begin.at.pattern, settings);
        if (node) {
          node->arclength = begin.arclength + (graze.u - begin.u).norm() + length;
          return Crossing{graze, std::move(*node), length};
        }
      } catch (const NumericalError &) {
      }
    }
  return std::nullopt;
}

bool is_known(const std::vector<LocatedGraze> &found, const LocatedGraze &graze) {
  constexpr double same = 1e-7;
  return std::any_of(found.begin(), found.end(),
                     [&](const LocatedGraze &other) { return (other.u - graze.u).norm() < same; });
}

} // namespace

std::optional<LocatedGraze> locate_graze(const ScaledProblem &problem, const Vector &guess,
                                         double chart, const Graze &graze, double furthest,
                                         const Settings &settings) {
  LocatedGraze located{graze, guess, chart, {}};
  const Index n = problem.states();
  try {
    const auto system = [&](const Vector &u) {
      located.at = problem.extend(u, chart, graze);
      SquareSystem at{Vector(n + 1), Matrix(n + 1, n + 1)};
      at.residual << located.at.smooth.residual, located.at.value;
      at.slope << located.at.smooth.slope, located.at.gradient;
      return at;
    };
    located.u = newton(system, guess, furthest, settings, Until::rounding).u;
  } catch (const NumericalError &) {
    return std::nullopt;
  }
  if ((located.u - guess).norm() > furthest)
    return std::nullopt;
  return located;
}

std::vector<LocatedGraze> grazes_between(const ScaledProblem &problem, const Node &begin,
                                         const Node &end, const Settings &settings) {
  const Vector chord = end.u - begin.u;
  const double length = chord.norm();
  std::vector<LocatedGraze> found;
  for (const Node *node : {&begin, &end})
    for (const Graze &graze : problem.problem().grazes_near(problem.point(node->u, node->chart))) {
      auto located = locate_graze(problem, node->u, node->chart, graze, length, settings);
      if (!located || is_known(found, *located))
        continue;
      const double way = chord.dot(located->u - begin.u) / (length * length);
      if (way >= 0 && way <= 1)
        found.push_back(std::move(*located));
    }
  std::sort(found.begin(), found.end(), [&](const LocatedGraze &a, const LocatedGraze &b) {
    return chord.dot(a.u) < chord.dot(b.u);
  });
  return found;
}

std::optional<Crossing> cross_graze(const ScaledProblem &problem, const Node &begin,
                                    const Settings &settings) {
  std::vector<LocatedGraze> ahead;
  for (const Graze &graze : problem.problem().grazes_near(problem.point(begin.u, begin.chart))) {
    auto located =
        locate_graze(problem, begin.u, begin.chart, graze, 10 * settings.graze_step, settings);
    if (located && begin.tangent.dot(located->u - begin.u) > 0)
      ahead.push_back(std::move(*located));
  }
  std::sort(ahead.begin(), ahead.end(), [&](const LocatedGraze &a, const LocatedGraze &b) {
    return (a.u - begin.u).norm() < (b.u - begin.u).norm();
  });
  for (const LocatedGraze &graze : ahead)
    if (auto crossing = go_beyond(problem, graze, begin, settings))
      return crossing;
  return std::nullopt;
}

std::vector<SpecialPoint> special_points_across(const ScaledProblem &problem, const Node &begin,
                                                const LocatedGraze &graze, const Node &end,
                                                const Settings &settings) {
  Node before = node_towards(problem, graze, begin, begin.tangent, settings);
  Node after = node_towards(problem, graze, end, end.tangent, settings);
  before.arclength = after.arclength = begin.arclength + (graze.u - begin.u).norm();
  const auto root = [&](const Node &node, Root there) {
    return is_open_at(graze, node) ? Root::none : there;
  };
  auto found = special_points(
      problem, Piece(problem, settings, begin, before, root(begin, Root::at_end)), settings);
  const bool turns = (before.tests.fold < 0) != (after.tests.fold < 0);
  const Special kind = turns ? Special::grazing_fold : Special::graze;
  // The solution is that of the graze, whichever side its derivatives are of.
  Node at = is_open_at(graze, begin) ? before : after;
  found.push_back(make_special(problem, kind, at, before, after));
  found.back().graze = graze.graze;
  const auto behind = special_points(
      problem, Piece(problem, settings, after, end, root(end, Root::at_begin)), settings);
  found.insert(found.end(), behind.begin(), behind.end());
  return found;
}

} // namespace vibroimpact::continuation
