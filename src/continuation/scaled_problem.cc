#include "continuation/scaled_problem.h"

#include <stdexcept>

namespace vibroimpact::continuation {

ScaledProblem::ScaledProblem(Problem &problem, const Point &sample)
    : problem_{problem}, states_{sample.state.size()}, scales_{problem.scales()} {
  if (scales_.size() != states_ + sample.keys.size() || sample.keys.size() == 0)
    throw std::logic_error("a problem has one scale for each state and key");
  if (!(scales_.array() > 0).all() || !scales_.allFinite())
    throw std::logic_error("scales of unknowns are positive");
}

Vector ScaledProblem::scaled(const Point &point) const {
  Vector u(unknowns());
  u << point.state, point.keys;
  return u.cwiseQuotient(scales_);
}

Point ScaledProblem::point(const Vector &u, double chart) const {
  const Vector physical = u.cwiseProduct(scales_);
  return {physical.head(states_), physical.tail(unknowns() - states_), chart};
}

Linearisation ScaledProblem::scaled(Evaluation evaluation) const {
  const auto rows = scales_.head(states_).cwiseInverse().asDiagonal();
  Linearisation result{rows * evaluation.residual, Matrix(states_, unknowns()),
                       std::move(evaluation.pattern), evaluation.chart_margin};
  result.slope << evaluation.by_state, evaluation.by_keys;
  result.slope = rows * result.slope * scales_.asDiagonal();
  if (!result.residual.allFinite() || !result.slope.allFinite())
    throw NumericalError("the equations have no finite value here");
  return result;
}

Linearisation ScaledProblem::evaluate(const Vector &u, double chart) const {
  return scaled(problem_.evaluate(point(u, chart)));
}

LinearisedExtension ScaledProblem::extend(const Vector &u, double chart, const Graze &graze) const {
  Extension extension = problem_.extend(point(u, chart), graze);
  LinearisedExtension result;
  result.smooth = scaled(std::move(extension.smooth));
  result.value = extension.value;
  result.gradient.resize(unknowns());
  result.gradient << extension.by_state, extension.by_keys;
  result.gradient = result.gradient * scales_.asDiagonal();
  result.touch = extension.touch;
  result.kind = extension.kind;
  result.jump = extension.jump.size() == 0
                    ? extension.jump
                    : Vector(extension.jump.cwiseQuotient(scales_.head(states_)));
  if (!std::isfinite(result.value) || !result.gradient.allFinite() || result.gradient.isZero(0))
    throw NumericalError("a guard's least value has no slope here");
  return result;
}

Vector ScaledProblem::transfer(const Vector &u, double from, double to, Matrix &tangents) const {
  const Transfer moved = problem_.transfer(point(u, from), to);
  Matrix physical = scales_.asDiagonal() * tangents;
  physical.topRows(states_) = (moved.by_state * physical.topRows(states_) +
                               moved.by_keys * physical.bottomRows(unknowns() - states_))
                                  .eval();
  tangents = scales_.cwiseInverse().asDiagonal() * physical;
  return scaled(moved.point);
}

std::pair<double, int> ScaledProblem::nearest_return(const Vector &u, double chart) const {
  std::pair<double, int> nearest{std::numeric_limits<double>::infinity(), 0};
  for (const ShorterReturn &back : problem_.shorter_returns(point(u, chart))) {
    const double distance = back.displacement.cwiseQuotient(scales_.head(states_)).norm();
    nearest = std::min(nearest, {distance, back.multiple});
  }
  return nearest;
}

} // namespace vibroimpact::continuation
