#include "continuation/locus_continuation.h"

#include "common/decompositions.h"
#include "common/signals.h"
#include "continuation/locus_end.h"
#include "continuation/node.h"
#include "continuation/piece.h"
#include "continuation/stored_steps.h"

#include <boost/math/tools/toms748_solve.hpp>

namespace vibroimpact::continuation {

namespace {

constexpr double agreement = 0.97; // cosine of the largest angle between tangents

Matrix slope_of(const Augmented &at) {
  Matrix slope(at.at.slope.rows() + 1, at.at.slope.cols());
  slope << at.at.slope, at.gradient;
  return slope;
}

} // namespace

// A problem that learns from failures as well learns the same from those that are kept.
template <class Compute>
auto LocusContinuation::recorded_step(const char *kind, const Compute &compute) const {
  using Value = decltype(compute());
  Problem &problem = problem_.problem();
  auto [outcome, remembered] = recorded(record_, kind, [&] {
    std::pair<std::optional<Value>, std::string> result;
    try {
      result.first = compute();
    } catch (const NumericalError &error) {
      result.second = error.what();
    }
    return std::pair(std::move(result), problem.remembered());
  });
  problem.remember(remembered);
  if (!outcome.first)
    throw NumericalError(outcome.second);
  return *std::move(outcome.first);
}

LocusContinuation::LocusContinuation(Problem &problem, const LocusStart &start,
                                     const Settings &settings,
                                     const std::function<void(const LocusPoint &)> &listener,
                                     StepRecord *record)
    : problem_{problem, start.point}, settings_{settings}, kind_{start.kind}, listener_{listener},
      record_{record}, step_{std::min(settings.first_step, settings.longest_step)} {
  if (problem_.unknowns() != problem_.states() + 2)
    throw std::logic_error("a locus has two keys");
  // Close to a graze the differences are coarse, and convergence is not quadratic.
  settings_.quadratic = 0;
  find_first(start);
  move_chart();
  first_ = here_;
  add(here_);
}

void LocusContinuation::find_first(const LocusStart &start) {
  here_.u = problem_.scaled(start.point);
  here_.chart = start.point.chart;
  equation_ = make_equation(problem_, start,
                            kind_ == LocusKind::graze ? Linearisation{}
                                                      : linearisation(here_.u, here_.chart));
  here_.at =
      recorded_step("first equation", [&] { return equation_->evaluate(here_.u, here_.chart); });
  here_ = solve(here_.u, first_tangent(start.forward), settings_.longest_step, Until::tolerance);
  here_.arclength = 0;
  hold_at_bounds();
  equation_->renew(here_.at.at, here_.chart);
}

// The last correction of a start at the end of a range may lead beyond it by rounding.
void LocusContinuation::hold_at_bounds() {
  const double rounding = 10 * settings_.tolerance;
  for (int key = 0; key < 2; ++key)
    if (const auto bound = bound_passed(here_.u);
        bound && std::abs(here_.u(bound->unknown) - bound->value) <= rounding)
      here_.u(bound->unknown) = bound->value;
}

Linearisation LocusContinuation::linearisation(const Vector &u, double chart) const {
  return recorded_step("linearisation", [&] { return problem_.evaluate(u, chart); });
}

Vector LocusContinuation::first_tangent(bool forward) const {
  const Matrix kernel = null_space(slope_of(here_.at));
  const Vector tangent = kernel.col(0).normalized();
  return (tangent(tangent.size() - 1) < 0) == forward ? Vector(-tangent) : tangent;
}

Locus LocusContinuation::run() {
  if (bound_passed(here_.u))
    end(LocusEnd::bounds, "the start lies outside the bounds of a key");
  while (!ended_) {
    leave_if_stopped();
    if (static_cast<int>(locus_.points.size()) >= settings_.most_points)
      end(LocusEnd::most_points,
          "the limit of " + std::to_string(settings_.most_points) + " points is reached");
    else
      step();
  }
  return std::move(locus_);
}

void LocusContinuation::step() {
  try {
    LocusNode next = next_node();
    if (const auto cusp = cusp_before(next))
      locus_.special.push_back({LocusSpecial::cusp, locus_point(*cusp), locus_.points.size() - 1});
    accept(std::move(next));
  } catch (const NumericalError &error) {
    step_ /= 2;
    if (step_ < settings_.least_step)
      end_at_steps(error.what());
  }
}

LocusNode LocusContinuation::next_node() {
  const double largest = settings_.largest_correction * step_;
  const Vector ahead = here_.u + step_ * here_.tangent;
  auto bound = bound_passed(ahead);
  LocusNode next =
      bound ? at_bound(ahead, *bound, largest)
            : solve(path_ ? path_->beyond(step_) : ahead, here_.tangent, largest, Until::tolerance);
  if (next.tangent.dot(here_.tangent) < agreement)
    throw NumericalError("the tangent turns too far");
  closes_ = passes_start(next);
  if (closes_) {
    next = first_;
    next.arclength = here_.arclength + (next.u - here_.u).norm();
  } else if (!bound && (bound = bound_passed(next.u))) {
    next = at_bound(next.u, *bound, largest);
  }
  bounded_ = bound && !closes_;
  return next;
}

// Before a prediction or a point that is beyond the bound: there may be no solutions there at all.
LocusNode LocusContinuation::at_bound(const Vector &beyond, const Bound &bound,
                                      double largest) const {
  const Index key = bound.unknown;
  Vector guess =
      here_.u + (bound.value - here_.u(key)) / (beyond(key) - here_.u(key)) * (beyond - here_.u);
  guess(key) = bound.value;
  return solve(guess, Vector::Unit(guess.size(), key), largest, Until::tolerance);
}

LocusNode LocusContinuation::solve(const Vector &guess, const Vector &normal, double largest,
                                   Until until) const {
  return recorded_step("point", [&] { return compute(guess, normal, largest, until); });
}

// On the hyperplane through the guess.
LocusNode LocusContinuation::compute(const Vector &guess, const Vector &normal, double largest,
                                     Until until) const {
  LocusNode node;
  node.chart = here_.chart;
  const auto system = [&](const Vector &u) {
    node.at = equation_->evaluate(u, node.chart);
    SquareSystem at{Vector(u.size()), Matrix(u.size(), u.size())};
    at.residual << node.at.at.residual, node.at.value, normal.dot(u - guess);
    at.slope << slope_of(node.at), normal.transpose();
    return at;
  };
  const Converged converged = newton(system, guess, largest, settings_, until);
  node.u = converged.u;
  node.iterations = converged.iterations;
  node.arclength = here_.arclength + (node.u - here_.u).norm();
  node.tangent = tangent_of(slope_of(node.at), here_.tangent.size() > 0 ? here_.tangent : normal);
  return node;
}

std::optional<LocusNode> LocusContinuation::cusp_before(const LocusNode &next) const {
  // Borders renewed at `here_` kept their directions, and with them the sign of its test.
  const double first = here_.at.cusp, last = next.at.cusp;
  if (closes_ || (first < 0) == (last < 0))
    return std::nullopt;
  const Hermite path(here_.u, here_.tangent, next.u, next.tangent);
  LocusNode best;
  double least = std::numeric_limits<double>::infinity();
  const auto test = [&](double way) {
    const LocusNode node =
        solve(path.at(way), path.chord(), settings_.largest_correction * step_, Until::rounding);
    if (std::abs(node.at.cusp) < least) {
      least = std::abs(node.at.cusp);
      best = node;
    }
    return node.at.cusp;
  };
  std::uintmax_t most = 60;
  const double begin = test(0), end = test(1);
  boost::math::tools::toms748_solve(
      test, 0.0, 1.0, begin, end,
      [](double a, double b) { return b - a <= 4 * std::numeric_limits<double>::epsilon(); }, most);
  return best;
}

void LocusContinuation::accept(LocusNode next) {
  const double factor = next.iterations <= 3 ? 1.5 : 1;
  path_.emplace(here_.u, here_.tangent, next.u, next.tangent);
  here_ = std::move(next);
  equation_->renew(here_.at.at, here_.chart);
  add(here_);
  step_ = std::min(factor * step_, settings_.longest_step);
  turned_back_ = turned_back_ || here_.tangent.dot(first_.tangent) < 0;
  if (closes_)
    end(LocusEnd::closed, "the curve closes on itself");
  else if (bounded_)
    end(LocusEnd::bounds, "a key reaches its bound");
  else if (here_.u.head(problem_.states()).norm() > settings_.largest_state)
    end(LocusEnd::far, "the state grows beyond all bounds");
  else
    move_chart();
}

void LocusContinuation::end_at_steps(const std::string &why) {
  constexpr double resonant =
      0.05; // [rad]: there the pair is so close to real that it turns at once
  const double angle = here_.at.angle;
  if (kind_ == LocusKind::neimark_sacker && std::min(angle, M_PI - angle) < resonant) {
    end(LocusEnd::real_pair, angle < resonant
                                 ? "the pair of multipliers becomes 1, 1: strong resonance 1:1"
                                 : "the pair of multipliers becomes -1, -1: strong resonance 1:2");
    return;
  }
  const auto graze = recorded_step("end at a graze",
                                   [&] { return end_at_graze(problem_, kind_, here_, settings_); });
  if (!graze) {
    end(LocusEnd::least_step, "steps fall below the least one: " + why);
    return;
  }
  LocusNode last = here_;
  last.arclength += (graze->u - last.u).norm();
  last.u = graze->u;
  last.at.at = graze->at;
  add(last);
  locus_.special.push_back(
      {LocusSpecial::ends_at_graze, locus_.points.back(), locus_.points.size() - 2});
  end(LocusEnd::graze, "the curve ends on the grazing curve of " + graze->graze.name);
}

void LocusContinuation::end(LocusEnd end, const std::string &reason) {
  ended_ = true;
  locus_.end = end;
  locus_.reason = reason;
}

std::optional<LocusContinuation::Bound> LocusContinuation::bound_passed(const Vector &u) const {
  const Range ranges[] = {settings_.first_key, settings_.second_key};
  for (Index key = 0; key < 2; ++key) {
    const Index unknown = problem_.states() + key;
    const double scale = problem_.scales()(unknown);
    const Range &range = ranges[key];
    if (u(unknown) < range.lower / scale)
      return Bound{unknown, range.lower / scale};
    if (u(unknown) > range.upper / scale)
      return Bound{unknown, range.upper / scale};
  }
  return std::nullopt;
}

bool LocusContinuation::passes_start(const LocusNode &next) const {
  constexpr double same_way = 0.8;
  if (!turned_back_ || next.chart != first_.chart)
    return false;
  const auto ahead = [&](const LocusNode &node) { return (node.u - first_.u).dot(first_.tangent); };
  return ahead(here_) < 0 && ahead(next) >= 0 && (next.u - first_.u).norm() < 1.5 * step_ &&
         next.tangent.dot(first_.tangent) > same_way;
}

void LocusContinuation::move_chart() {
  if (here_.at.at.chart_margin >= settings_.least_margin)
    return;
  const double chart = recorded_step("best chart", [&] {
    return problem_.problem().best_chart(problem_.point(here_.u, here_.chart));
  });
  if (chart == here_.chart)
    return;
  const auto [u, tangent] = recorded_step("another chart", [&] {
    Matrix tangents = here_.tangent;
    Vector moved = problem_.transfer(here_.u, here_.chart, chart, tangents);
    return std::pair(std::move(moved), std::move(tangents));
  });
  const double arclength = here_.arclength;
  path_.reset();
  here_.chart = chart;
  here_.tangent = tangent.col(0).normalized();
  if (kind_ != LocusKind::graze)
    equation_->renew(linearisation(u, chart), chart);
  here_ = solve(u, here_.tangent, settings_.longest_step, Until::tolerance);
  here_.arclength = arclength;
}

void LocusContinuation::add(const LocusNode &node) {
  locus_.points.push_back(locus_point(node));
  if (listener_)
    listener_(locus_.points.back());
}

LocusPoint LocusContinuation::locus_point(const LocusNode &node) const {
  Vector residual(problem_.states() + 1);
  residual << node.at.at.residual, node.at.value;
  const Vector scales = problem_.scales().head(problem_.states());
  const Matrix scaled = node.at.at.slope.leftCols(problem_.states());
  return {.point = problem_.point(node.u, node.chart),
          .tangent = node.tangent,
          .residual = residual.norm(),
          .defect = scales.cwiseProduct(node.at.at.residual),
          .by_state = scales.asDiagonal() * scaled * scales.cwiseInverse().asDiagonal(),
          .pattern = node.at.at.pattern,
          .angle = node.at.angle,
          .side = node.at.side,
          .arclength = node.arclength};
}

Locus follow_locus(Problem &problem, const LocusStart &start, const Settings &settings,
                   const std::function<void(const LocusPoint &)> &listener, StepRecord *record) {
  if (start.graze)
    if (const std::unique_ptr<Problem> extended = problem.extended(*start.graze))
      return LocusContinuation(*extended, start, settings, listener, record).run();
  return LocusContinuation(problem, start, settings, listener, record).run();
}

} // namespace vibroimpact::continuation
