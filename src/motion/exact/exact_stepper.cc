#include "motion/exact/exact_stepper.h"

#include "common/signals.h"
#include "motion/system/tolerances.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace vibroimpact::motion {

ExactStepper::ExactStepper(const Equations &equations, const Settings &settings)
    : equations_(equations),
      maximum_step_(settings.maximum_step > 0 ? settings.maximum_step
                                              : std::numeric_limits<double>::infinity()),
      tolerance_{.relative = settings.relative_tolerance,
                 .absolute = absolute_tolerances(equations, settings.negligible_length())},
      work_(equations) {}

ExactStepper::CachedPhase &ExactStepper::cached_phase() {
  for (CachedPhase &cached : phases_)
    if (cached.modes == equations_.modes())
      return cached;
  CachedPhase &cached =
      phases_.emplace_back(CachedPhase{.modes = equations_.modes(), .phase = nullptr});
  if (LinearSystem::holds(equations_))
    cached.phase = std::make_unique<LinearPhase>(equations_, tolerance_);
  return cached;
}

bool ExactStepper::handles(double time) {
  if (!cached_phase().phase)
    return false;
  sources_.clear();
  for (const model::Source &source : equations_.model().sources()) {
    std::optional<model::ExponentialForm> form = source.function->exponential_form(time);
    if (!form)
      return false;
    sources_.push_back(*std::move(form));
  }
  return true;
}

void ExactStepper::restart(double time, const Vector &x) {
  place(time, x);
  start_.time = time;
  start_.state = x;
  motion_ = nullptr;
}

void ExactStepper::begin() {
  physical_ = end_.state.head(equations_.layout().physical_size());
  phase_ = cached_phase().phase.get();
  motion_ = &phase_->begin(physical_, sources_);
  motion_->initial_derivatives(rows_);
  fill(end_);
}

// Everything but the state from the rows.
void ExactStepper::fill(EndPoint &point) const {
  const Index size = equations_.layout().physical_size();
  point.rates.resize(equations_.layout().size());
  point.rates.head(size) = rows_.col(1).head(size);
  point.higher = rows_.block(0, 2, size, 2);
  point.sources.resize(sources_.size());
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    const Index row = size + 3 * static_cast<Index>(k);
    point.sources[k] = {rows_(row, 0), rows_(row, 1), rows_(row, 2), rows_(row, 3),
                        rows_(row + 2, 2)};
  }
}

void ExactStepper::take(double end) {
  const Index size = equations_.layout().physical_size();
  motion_->derivatives(end - start_.time, rows_);
  end_.state = start_.state;
  end_.state.head(size) = rows_.col(0).head(size);
  if (!end_.state.allFinite())
    throw NumericalError("the state is no longer finite at t = " + std::to_string(end) + " s");
  end_.time = end;
  fill(end_);
  pending_ = true;
}

void ExactStepper::step(double limit) {
  if (!motion_)
    begin();
  std::swap(start_, end_);
  const double wanted = std::min(motion_->natural_step(), maximum_step_);
  const double rest = limit - start_.time;
  if (!(start_.time + wanted > start_.time))
    throw NumericalError(
        "the motion is too large for any step, at t = " + std::to_string(start_.time) + " s");
  // Two halves rather than a step and a sliver.
  if (rest <= wanted * (1 + 1e-9))
    take(limit);
  else
    take(start_.time + (rest < 2 * wanted ? 0.5 * rest : wanted));
}

void ExactStepper::shorten(double time) { take(time); }

const GuardCurves *ExactStepper::guard_curves() {
  return &motion_->guards(end_.time - start_.time);
}

void ExactStepper::undo() {
  end_ = start_;
  pending_ = false;
}

void ExactStepper::accept(bool keep_work) {
  if (!pending_)
    return;
  pending_ = false;
  const double h = end_.time - start_.time;
  double part = 0;
  for (double from = 0; keep_work && from < h; from += part) {
    leave_if_stopped();
    part = motion_->quadrature_length(from, h - from);
    if (!(from + part > from))
      throw NumericalError("the energies of the motion can no longer be followed, at t = " +
                           std::to_string(start_.time) + " s");
    motion_->values(WorkQuadrature::instants(from, part), nodes_);
    work_.add(part, nodes_, phase_->system().constraint_forces(), end_.state);
  }
  motion_->move(h);
}

void ExactStepper::place(double time, const Vector &x) {
  end_.time = time;
  end_.state = x;
  pending_ = false;
}

} // namespace vibroimpact::motion
