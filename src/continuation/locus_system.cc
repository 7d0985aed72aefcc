#include "continuation/locus_system.h"

#include "common/decompositions.h"
#include "continuation/curve_continuation.h"
#include "continuation/locus_end.h"
#include "continuation/node.h"
#include "continuation/stored_steps.h"

#include <boost/math/tools/toms748_solve.hpp>

namespace vibroimpact::continuation {

namespace {

Matrix slope_of(const Augmented &at) {
  Matrix slope(at.slope.rows() + 1, at.slope.cols());
  slope << at.slope, at.gradient;
  return slope;
}

Vector first_tangent(const Augmented &at, bool forward) {
  const Vector tangent = null_space(slope_of(at)).col(0).normalized();
  return (tangent(tangent.size() - 1) < 0) == forward ? Vector(-tangent) : tangent;
}

} // namespace

LocusSystem::LocusSystem(Problem &problem, const LocusStart &start, const Settings &settings)
    : problem_{problem, start.point}, start_{start}, settings_{settings} {
  if (problem_.unknowns() != problem_.states() + 2)
    throw std::logic_error("a locus has two keys");
  // Close to a graze the differences are coarse, and convergence is not quadratic.
  settings_.quadratic = 0;
}

LocusNode LocusSystem::first() const {
  LocusNode start{.u = problem_.scaled(start_.point), .chart = start_.point.chart};
  const auto equation = make_equation(
      problem_, start_,
      start_.kind == LocusKind::graze ? Linearisation{} : problem_.evaluate(start.u, start.chart));
  const Vector normal = first_tangent(equation->evaluate(start.u, start.chart), start_.forward);
  start.tangent = normal;
  LocusNode node =
      solve(*equation, start, start.u, normal, settings_.longest_step, Until::tolerance);
  hold_at_bounds(node);
  return node;
}

// The last correction of a start at the end of a range may lead beyond it by rounding.
void LocusSystem::hold_at_bounds(LocusNode &node) const {
  const double rounding = 10 * settings_.tolerance;
  for (int key = 0; key < 2; ++key)
    if (const auto bound = bound_passed(problem_, settings_, node.u);
        bound && std::abs(node.u(bound->unknown) - bound->value) <= rounding)
      node.u(bound->unknown) = bound->value;
}

LocusNode LocusSystem::correct(const LocusNode &from, const Vector &guess, const Vector &normal,
                               double largest) const {
  return solve(*equation_, from, guess, normal, largest, Until::tolerance);
}

// On the hyperplane through the guess.
LocusNode LocusSystem::solve(const LocusEquation &equation, const LocusNode &from,
                             const Vector &guess, const Vector &normal, double largest,
                             Until until) const {
  LocusNode node{.chart = from.chart};
  const auto system = [&](const Vector &u) {
    node.at = equation.evaluate(u, node.chart);
    SquareSystem at{Vector(u.size()), Matrix(u.size(), u.size())};
    at.residual << node.at.residual, node.at.value, normal.dot(u - guess);
    at.slope << slope_of(node.at), normal.transpose();
    return at;
  };
  const Converged converged = newton(system, guess, largest, settings_, until);
  node.u = converged.u;
  node.iterations = converged.iterations;
  node.tangent = tangent_of(slope_of(node.at), from.tangent);
  return node;
}

LocusNode LocusSystem::in_chart(const LocusNode &node, double chart) const {
  LocusNode moved{.chart = chart, .arclength = node.arclength};
  Matrix tangents = node.tangent;
  moved.u = problem_.transfer(node.u, node.chart, chart, tangents);
  moved.tangent = tangents.col(0).normalized();
  const auto equation = equation_->clone();
  if (start_.kind != LocusKind::graze)
    equation->renew(problem_.evaluate(moved.u, chart), chart);
  LocusNode solved =
      solve(*equation, moved, moved.u, moved.tangent, settings_.longest_step, Until::tolerance);
  solved.arclength = node.arclength;
  return solved;
}

double LocusSystem::best_chart(const LocusNode &node) const {
  return problem_.problem().best_chart(problem_.point(node.u, node.chart));
}

// Borders renewed at `from` kept their directions, and with them the sign of the test for cusps.
std::vector<SpecialLocusPoint> LocusSystem::special_points(const LocusNode &from, LocusNode &next,
                                                           bool closes) const {
  if (closes || (from.at.cusp < 0) == (next.at.cusp < 0))
    return {};
  return {{.kind = LocusSpecial::cusp, .at = curve_point(cusp_between(from, next))}};
}

LocusNode LocusSystem::cusp_between(const LocusNode &from, const LocusNode &next) const {
  const Hermite path(from.u, from.tangent, next.u, next.tangent);
  const double largest = settings_.largest_correction * path.length();
  LocusNode best;
  double least = std::numeric_limits<double>::infinity();
  const auto test = [&](double way) {
    LocusNode node = solve(*equation_, from, path.at(way), path.chord(), largest, Until::rounding);
    node.arclength = from.arclength + (node.u - from.u).norm();
    const double cusp = node.at.cusp;
    if (std::abs(cusp) < least) {
      least = std::abs(cusp);
      best = std::move(node);
    }
    return cusp;
  };
  std::uintmax_t most = 60;
  const double begin = test(0), end = test(1);
  boost::math::tools::toms748_solve(
      test, 0.0, 1.0, begin, end,
      [](double a, double b) { return b - a <= 4 * std::numeric_limits<double>::epsilon(); }, most);
  return best;
}

Ending<Locus> LocusSystem::end_at_steps(const LocusNode &last, const std::string &why) const {
  constexpr double resonant =
      0.05; // [rad]: there the pair is so close to real that it turns at once
  const double angle = last.at.angle;
  if (start_.kind == LocusKind::neimark_sacker && std::min(angle, M_PI - angle) < resonant)
    return {End::real_pair, angle < resonant
                                ? "the pair of multipliers becomes 1, 1: strong resonance 1:1"
                                : "the pair of multipliers becomes -1, -1: strong resonance 1:2"};
  const auto graze = end_at_graze(problem_, start_.kind, last, settings_);
  if (!graze)
    return {End::least_step, "steps fall below the least one: " + why};
  LocusNode end = last;
  end.arclength += (graze->u - last.u).norm();
  end.u = graze->u;
  static_cast<Linearisation &>(end.at) = graze->at;
  const LocusPoint point = curve_point(end);
  return {End::graze,
          "the curve ends on the grazing curve of " + graze->graze.name,
          point,
          {{.kind = LocusSpecial::ends_at_graze, .at = point}}};
}

Vector LocusSystem::predicted(const LocusNode &from, double step) const {
  return path_ ? path_->beyond(step) : Vector(from.u + step * from.tangent);
}

void LocusSystem::check(const LocusNode &from, const LocusNode &next) const {
  if (angle_between(from.tangent, next.tangent) > settings_.largest_angle)
    throw NumericalError("the tangent turns too far");
}

void LocusSystem::accept(const LocusNode &from, const LocusNode &next) {
  path_.emplace(from.u, from.tangent, next.u, next.tangent);
  equation_->renew(next.at, next.chart);
}

void LocusSystem::take_chart(const LocusNode &moved) {
  path_.reset();
  if (equation_)
    equation_->renew(moved.at, moved.chart);
  else
    equation_ = make_equation(problem_, start_, moved.at);
}

LocusPoint LocusSystem::curve_point(const LocusNode &node) const {
  const Index n = problem_.states();
  Vector residual(n + 1);
  residual << node.at.residual, node.at.value;
  const Vector scales = problem_.scales().head(n);
  return {.point = problem_.point(node.u, node.chart),
          .tangent = node.tangent,
          .residual = residual.norm(),
          .defect = scales.cwiseProduct(node.at.residual),
          .by_state =
              scales.asDiagonal() * node.at.slope.leftCols(n) * scales.cwiseInverse().asDiagonal(),
          .pattern = node.at.pattern,
          .angle = node.at.angle,
          .side = node.at.side,
          .arclength = node.arclength};
}

Locus follow_locus(Problem &problem, const LocusStart &start, const Settings &settings,
                   const CurveListener<Locus> &listener, StepRecord *record) {
  std::unique_ptr<Problem> extended;
  if (start.graze)
    extended = problem.extended(*start.graze);
  RecordedSystem<LocusSystem> system(record, extended ? *extended : problem, start, settings);
  return CurveContinuation(system, settings, listener).run();
}

} // namespace vibroimpact::continuation
