#include "continuation/branch_system.h"

#include <algorithm>
#include <sstream>

namespace vibroimpact::continuation {

namespace {

Vector first_direction(const ScaledProblem &problem, const Start &start) {
  if (start.direction.size() > 0)
    return start.direction.normalized();
  const Index m = problem.unknowns();
  return (start.forward ? 1.0 : -1.0) * Vector::Unit(m, m - 1);
}

} // namespace

BranchSystem::BranchSystem(Problem &problem, const Start &start, const Settings &settings)
    : problem_{problem, start.point}, start_{start}, settings_{settings} {
  if (problem_.unknowns() != problem_.states() + 1)
    throw std::logic_error("a branch has one key");
}

Node BranchSystem::first() const {
  Node start;
  start.chart = start_.point.chart;
  start.tangent = first_direction(problem_, start_);
  return correct(start, problem_.scaled(start_.point), start.tangent, settings_.longest_step);
}

Node BranchSystem::correct(const Node &from, const Vector &guess, const Vector &normal,
                           double largest) const {
  Corrected corrected =
      continuation::correct(problem_, guess, from.chart, normal, largest, settings_);
  Node node = make_node(problem_, corrected.u, from.chart, std::move(corrected.at), from.tangent);
  node.iterations = corrected.iterations;
  return node;
}

Node BranchSystem::in_chart(const Node &node, double chart) const {
  return continuation::in_chart(problem_, node, chart, settings_);
}

double BranchSystem::best_chart(const Node &node) const {
  return problem_.problem().best_chart(problem_.point(node.u, node.chart));
}

std::vector<SpecialPoint> BranchSystem::special_points(const Node &from, Node &next,
                                                       bool /*closes*/) const {
  if (next.at.pattern == from.at.pattern)
    return continuation::special_points(problem_, Piece(problem_, settings_, from, next),
                                        settings_);
  return special_points_and_changes(problem_, from, next, settings_);
}

std::optional<Behind<Node, SpecialPoint>> BranchSystem::behind_graze(const Node &from) const {
  const auto crossing = cross_graze(problem_, from, settings_);
  if (!crossing)
    return std::nullopt;
  Behind<Node, SpecialPoint> behind{.graze = crossing->graze.u,
                                    .guard = crossing->graze.graze.name,
                                    .node = crossing->beyond,
                                    .step = crossing->step,
                                    .special = {}};
  try {
    behind.special =
        special_points_across(problem_, from, crossing->graze, crossing->beyond, settings_);
  } catch (const NumericalError &) {
    // The step goes on being halved.
  }
  return behind;
}

// A branch of a power of the map ends where it crosses solutions of a lower multiple, at a flip of
// theirs: its other half is the same solutions begun elsewhere.
std::optional<Ending<Branch>>
BranchSystem::end_before(const Node &next, const std::vector<SpecialPoint> &special) const {
  constexpr double at_crossing = 1e-6; // which is located to rounding
  for (auto point = special.begin(); point != special.end(); ++point) {
    if (point->kind != Special::branch_point)
      continue;
    const Point &at = point->at.point;
    const auto [distance, multiple] = problem_.nearest_return(problem_.scaled(at), at.chart);
    if (distance <= at_crossing)
      return Ending<Branch>{End::shorter_return,
                            "the branch ends on solutions of multiple " + std::to_string(multiple) +
                                ", where these have a flip",
                            point->at, std::vector(special.begin(), point)};
  }
  const auto [distance, multiple] = problem_.nearest_return(next.u, next.chart);
  if (distance >= settings_.shorter_return)
    return std::nullopt;
  return Ending<Branch>{End::shorter_return,
                        "the next point is a solution of multiple " + std::to_string(multiple)};
}

Ending<Branch> BranchSystem::end_at_steps(const Node &last, const std::string &why) const {
  if (const auto graze = graze_that_ends(problem_, last, settings_))
    return {End::one_sided,
            "beyond the grazing contact of " + graze->graze->name +
                " there are no solutions close by",
            graze->at,
            {*graze}};
  std::ostringstream reason;
  reason << "steps fall below " << settings_.least_step << ": " << why;
  return {End::least_step, reason.str()};
}

double BranchSystem::step_factor(const Node &from, const Node &next) const {
  const double turn = angle_between(from.tangent, next.tangent);
  const double factor = turn > 0 ? std::clamp(settings_.wanted_angle / turn, 0.5, 2.0) : 2.0;
  return factor * (next.iterations > settings_.many_iterations ? 0.7 : 1.0);
}

double BranchSystem::least_margin(const Node &from, const Node &next) const {
  return next.at.pattern == from.at.pattern ? 0 : settings_.margin_at_changes;
}

// Of the key the slopes are known, so that a cubic shows its turns; of other tests the parabola
// through the last three points does.
void BranchSystem::check(const Node &from, const Node &next) {
  const Piece piece(problem_, settings_, from, next);
  if (halvings_ >= settings_.halvings ||
      !(piece.key_turns_twice() || pair_suspected(from, next, &Tests::flip) ||
        pair_suspected(from, next, &Tests::pair)))
    return;
  ++halvings_;
  throw NumericalError("two special points may lie within a step");
}

bool BranchSystem::pair_suspected(const Node &from, const Node &next, double Tests::*test) const {
  if (!before_ || next.at.pattern != from.at.pattern)
    return false;
  const double a = before_->tests.*test, b = from.tests.*test, c = next.tests.*test;
  const double ahead = next.arclength - from.arclength;
  const double behind = from.arclength - before_->arclength;
  // b + slope s + curvature s^2 on [0, ahead], least at s = -slope / (2 curvature)
  const double curvature = ((c - b) / ahead - (b - a) / behind) / (ahead + behind);
  const double slope = (c - b) / ahead - curvature * ahead;
  const double least = -slope / (2 * curvature);
  return b * c > 0 && least > 0 && least < ahead && b * (b + slope * least / 2) < 0;
}

void BranchSystem::accept(const Node &from, const Node &next) {
  before_ = std::nullopt;
  if (next.at.pattern == from.at.pattern)
    before_ = from;
  halvings_ = 0;
}

} // namespace vibroimpact::continuation
