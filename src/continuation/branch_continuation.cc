#include "continuation/branch_continuation.h"

#include "common/signals.h"
#include "continuation/stored_steps.h"

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

double angle(const Node &a, const Node &b) {
  return std::acos(std::clamp(a.tangent.dot(b.tangent), -1.0, 1.0));
}

std::string text(double number) {
  std::ostringstream out;
  out << number;
  return out.str();
}

} // namespace

BranchContinuation::BranchContinuation(Problem &problem, const Start &start,
                                       const Settings &settings, const Listener &listener,
                                       StepRecord *record)
    : problem_{problem, start.point}, settings_{settings}, listener_{listener}, record_{record},
      step_{std::min(settings.first_step, settings.longest_step)} {
  if (problem_.unknowns() != problem_.states() + 1)
    throw std::logic_error("a branch has one key");
  const Vector direction = first_direction(problem_, start);
  here_ = recorded(record_, "first point", [&] {
    Corrected corrected = correct(problem_, problem_.scaled(start.point), start.point.chart,
                                  direction, settings_.longest_step, settings_);
    return make_node(problem_, corrected.u, start.point.chart, std::move(corrected.at), direction);
  });
  move_chart(settings_.least_margin);
  first_ = here_;
  add(branch_point(problem_, here_), {});
}

Branch BranchContinuation::run() {
  if (const auto bound = bound_passed(here_.u))
    end(bound->end, "the start lies outside the bounds of the key");
  while (!ended_) {
    leave_if_stopped();
    if (static_cast<int>(branch_.points.size()) >= settings_.most_points)
      end(End::most_points,
          "the limit of " + std::to_string(settings_.most_points) + " points is reached");
    else
      step();
  }
  return std::move(branch_);
}

void BranchContinuation::step() {
  Node next;
  std::vector<SpecialPoint> special;
  try {
    take_chart_of_start();
    next = next_node();
    if (move_for_pattern(next))
      return;
    special = examine(next);
  } catch (const NumericalError &error) {
    shorten(error.what());
    return;
  }
  choose_step(next);
  accept(std::move(next), std::move(special));
}

void BranchContinuation::shorten(const std::string &why) {
  if (step_ < settings_.graze_step && cross())
    return;
  step_ /= 2;
  if (step_ < settings_.least_step)
    end(End::least_step, "steps fall below " + text(settings_.least_step) + ": " + why);
}

bool BranchContinuation::cross() {
  constexpr double same = 1e-7;
  constexpr int most_returns = 3;
  std::optional<Behind> behind = recorded(record_, "graze", [&] { return behind_graze(); });
  if (!behind)
    return false;
  const Vector &at = behind->graze;
  const auto returns = std::count_if(crossed_.begin(), crossed_.end(),
                                     [&](const Vector &u) { return (u - at).norm() < same; });
  if (returns >= most_returns) {
    end(End::graze, "the branch returns to the graze of " + behind->guard + " again and again");
    return true;
  }
  if (!behind->special)
    return false;
  crossed_.push_back(at);
  step_ = behind->step;
  bound_ = std::nullopt;
  closes_ = false;
  accept(std::move(behind->node), std::move(*behind->special));
  return true;
}

std::optional<BranchContinuation::Behind> BranchContinuation::behind_graze() const {
  const auto crossing = cross_graze(problem_, here_, settings_);
  if (!crossing)
    return std::nullopt;
  Behind behind{.graze = crossing->graze.u,
                .guard = crossing->graze.graze.name,
                .node = crossing->beyond,
                .step = crossing->step,
                .special = {}};
  try {
    behind.special =
        special_points_across(problem_, here_, crossing->graze, crossing->beyond, settings_);
  } catch (const NumericalError &) {
    // The step goes on being halved.
  }
  return behind;
}

// Beyond a bound there may be no solutions at all: a step that fails there ends at the bound.
Node BranchContinuation::next_node() {
  Node next;
  Vector beyond = here_.u + step_ * here_.tangent;
  closes_ = false;
  try {
    next = recorded(record_, "point", [&] { return attempt(beyond); });
    beyond = next.u;
    closes_ = passes_start(next);
  } catch (const NumericalError &) {
    if (!bound_passed(beyond))
      throw;
  }
  bound_ = bound_passed(beyond);
  if (closes_)
    next = first_;
  else if (bound_)
    next = recorded(record_, "point at a bound", [&] { return at_bound(beyond, *bound_); });
  next.arclength = here_.arclength + (next.u - here_.u).norm();
  return next;
}

Node BranchContinuation::attempt(const Vector &ahead) const {
  Corrected corrected = correct(problem_, ahead, here_.chart, here_.tangent,
                                settings_.largest_correction * step_, settings_);
  Node next = make_node(problem_, corrected.u, here_.chart, std::move(corrected.at), here_.tangent);
  next.iterations = corrected.iterations;
  if (angle(here_, next) > settings_.largest_angle)
    throw NumericalError("the tangent turns too far");
  return next;
}

Node BranchContinuation::at_bound(const Vector &beyond, const Bound &bound) const {
  const Index key = problem_.states();
  const double share = (bound.value - here_.u(key)) / (beyond(key) - here_.u(key));
  Vector guess = here_.u + share * (beyond - here_.u);
  guess(key) = bound.value;
  Corrected corrected = correct(problem_, guess, here_.chart, Vector::Unit(key + 1, key),
                                settings_.largest_correction * step_, settings_);
  return make_node(problem_, corrected.u, here_.chart, std::move(corrected.at), here_.tangent);
}

std::vector<SpecialPoint> BranchContinuation::examine(Node &next) {
  const Piece piece(problem_, settings_, here_, next);
  check_pairs(piece);
  auto [special, arclength] = recorded(record_, "special points", [&] {
    auto found = special_up_to(next, piece);
    return std::pair(std::move(found), next.arclength);
  });
  next.arclength = arclength;
  return std::move(special);
}

std::vector<SpecialPoint> BranchContinuation::special_up_to(Node &next, const Piece &piece) const {
  if (next.at.pattern == here_.at.pattern)
    return special_points(problem_, piece, settings_);
  return special_points_and_changes(problem_, here_, next, settings_);
}

// Of the key the slopes are known, so that a cubic shows its turns; of other tests the parabola
// through the last three points does.
void BranchContinuation::check_pairs(const Piece &piece) {
  const Node &next = piece.end();
  if (halvings_ >= settings_.halvings ||
      !(piece.key_turns_twice() || pair_suspected(next, &Tests::flip) ||
        pair_suspected(next, &Tests::pair)))
    return;
  ++halvings_;
  throw NumericalError("two special points may lie within a step");
}

bool BranchContinuation::pair_suspected(const Node &next, double Tests::*test) const {
  if (!before_ || next.at.pattern != here_.at.pattern)
    return false;
  const double a = before_->tests.*test, b = here_.tests.*test, c = next.tests.*test;
  const double ahead = next.arclength - here_.arclength;
  const double behind = here_.arclength - before_->arclength;
  // b + slope s + curvature s^2 on [0, ahead], least at s = -slope / (2 curvature)
  const double curvature = ((c - b) / ahead - (b - a) / behind) / (ahead + behind);
  const double slope = (c - b) / ahead - curvature * ahead;
  const double least = -slope / (2 * curvature);
  return b * c > 0 && least > 0 && least < ahead && b * (b + slope * least / 2) < 0;
}

void BranchContinuation::accept(Node next, std::vector<SpecialPoint> special) {
  if (ends_at_shorter(special, next))
    return;
  before_ = std::nullopt;
  if (next.at.pattern == here_.at.pattern)
    before_ = std::move(here_);
  here_ = std::move(next);
  add(branch_point(problem_, here_), std::move(special));
  halvings_ = 0;
  moved_ = false;
  const Index key = problem_.states();
  turned_back_ = turned_back_ || here_.tangent(key) * first_.tangent(key) <= 0;
  if (closes_)
    end(End::closed, "the branch closes on itself");
  else if (bound_)
    end(bound_->end, bound_->end == End::upper_bound ? "the key reaches its upper bound"
                                                     : "the key reaches its lower bound");
  else if (here_.u.head(key).norm() > settings_.largest_state)
    end(End::far, "the state exceeds " + text(settings_.largest_state) + " times its scale");
  else
    move_chart(settings_.least_margin);
}

// A branch of a power of the map ends where it crosses solutions of a lower multiple, at a flip of
// theirs: its other half is the same solutions begun elsewhere.
bool BranchContinuation::ends_at_shorter(std::vector<SpecialPoint> special, const Node &next) {
  constexpr double at_crossing = 1e-6; // which is located to rounding
  for (auto point = special.begin(); point != special.end(); ++point) {
    if (point->kind != Special::branch_point)
      continue;
    const Point &at = point->at.point;
    const auto [distance, multiple] = nearest_return(problem_.scaled(at), at.chart);
    if (distance > at_crossing)
      continue;
    const BranchPoint last = point->at;
    special.erase(point, special.end());
    add(last, std::move(special));
    end(End::shorter_return, "the branch ends on solutions of multiple " +
                                 std::to_string(multiple) + ", where these have a flip");
    return true;
  }
  const auto [distance, multiple] = nearest_return(next.u, next.chart);
  if (distance >= settings_.shorter_return)
    return false;
  end(End::shorter_return, "the next point is a solution of multiple " + std::to_string(multiple));
  return true;
}

void BranchContinuation::end(End end, const std::string &reason) {
  ended_ = true;
  branch_.end = end;
  branch_.reason = reason;
}

void BranchContinuation::choose_step(const Node &next) {
  const double turn = angle(here_, next);
  const double factor = turn > 0 ? std::clamp(settings_.wanted_angle / turn, 0.5, 2.0) : 2.0;
  step_ *= factor * (next.iterations > settings_.many_iterations ? 0.7 : 1.0);
  step_ = std::min(step_, settings_.longest_step);
}

void BranchContinuation::add(BranchPoint point, std::vector<SpecialPoint> special) {
  for (SpecialPoint &found : special) {
    found.after = branch_.points.size() - 1;
    if (listener_.special)
      listener_.special(found);
    branch_.special.push_back(std::move(found));
  }
  if (listener_.point)
    listener_.point(point);
  branch_.points.push_back(std::move(point));
}

std::optional<BranchContinuation::Bound> BranchContinuation::bound_passed(const Vector &u) const {
  const Index key = problem_.states();
  const double scale = problem_.scales()(key);
  if (u(key) < settings_.first_key.lower / scale)
    return Bound{End::lower_bound, settings_.first_key.lower / scale};
  if (u(key) > settings_.first_key.upper / scale)
    return Bound{End::upper_bound, settings_.first_key.upper / scale};
  return std::nullopt;
}

// On a closed curve the key comes back, so that its slope changes sign somewhere.
bool BranchContinuation::passes_start(const Node &next) const {
  constexpr double agreement = 0.8; // cosine of the largest angle between the tangents
  if (!turned_back_ || next.chart != first_.chart)
    return false;
  const auto ahead = [&](const Node &node) { return (node.u - first_.u).dot(first_.tangent); };
  return ahead(here_) < 0 && ahead(next) >= 0 && (next.u - first_.u).norm() < 1.5 * step_ &&
         next.tangent.dot(first_.tangent) > agreement;
}

// Close to the start the walk must be in its chart to see it.
void BranchContinuation::take_chart_of_start() {
  const Index key = problem_.states();
  if (!turned_back_ || here_.chart == first_.chart ||
      std::abs(here_.u(key) - first_.u(key)) > 2 * step_)
    return;
  const Node moved = recorded(record_, "chart of the start",
                              [&] { return in_chart(problem_, here_, first_.chart, settings_); });
  if ((moved.u - first_.u).norm() < 2 * step_)
    here_ = moved;
}

bool BranchContinuation::move_for_pattern(const Node &next) {
  if (moved_ || next.at.pattern == here_.at.pattern ||
      next.at.chart_margin >= settings_.margin_at_changes)
    return false;
  moved_ = true;
  return move_chart(settings_.margin_at_changes);
}

bool BranchContinuation::move_chart(double least_margin) {
  if (here_.at.chart_margin >= least_margin)
    return false;
  const double chart = recorded(record_, "best chart", [&] {
    return problem_.problem().best_chart(problem_.point(here_.u, here_.chart));
  });
  if (chart == here_.chart)
    return false;
  here_ = recorded(record_, "another chart",
                   [&] { return in_chart(problem_, here_, chart, settings_); });
  return true;
}

std::pair<double, int> BranchContinuation::nearest_return(const Vector &u, double chart) const {
  return recorded(record_, "shorter returns", [&] { return problem_.nearest_return(u, chart); });
}

} // namespace vibroimpact::continuation
