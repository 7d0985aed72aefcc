#include "motion/exact/exact_phases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace vibroimpact::motion {

namespace {

// Beyond the slowest vibration of the bodies alone no piece is worth trying; where nothing vibrates
// only the excitation asks for pieces at all.
double longest_piece(const model::Model &model) {
  double slowest = std::numeric_limits<double>::infinity();
  const Matrix stiffness = model.stiffness().dense();
  for (Index j = 0; j < stiffness.rows(); ++j)
    if (stiffness(j, j) > 0)
      slowest = std::min(slowest, std::sqrt(stiffness(j, j) / model.mass()[j]));
  constexpr double whole = 1e3; // [s]
  return std::isfinite(slowest) ? 8 / slowest : whole;
}

} // namespace

LinearPhase::LinearPhase(const Equations &equations, const Settings &settings, double longest_piece)
    : system_(equations), forms_(equations),
      phase_(system_.matrix(), system_.constant(), system_.loads(), forms_.guard_forms(),
             longest_piece),
      tolerance_(settings.relative_tolerance),
      longest_step_(settings.maximum_step > 0 ? settings.maximum_step
                                              : std::numeric_limits<double>::infinity()) {}

const PowerForms &LinearPhase::powers(const Equations &equations) {
  if (!powers_)
    powers_ = std::make_unique<PowerForms>(equations);
  return *powers_;
}

WorkIntegrals &LinearPhase::work(const Equations &equations) {
  if (!work_)
    work_ = std::make_unique<WorkIntegrals>(powers(equations), phase_, equations.layout());
  else if (work_excitation_ != phase_.generation())
    work_->renew();
  work_excitation_ = phase_.generation();
  return *work_;
}

ExactSegment &LinearPhase::segment(const Equations &equations) {
  if (!segment_)
    segment_ = std::make_unique<ExactSegment>(equations, phase_, tolerance_, longest_step_);
  else if (segment_excitation_ != phase_.generation())
    segment_->renew();
  segment_excitation_ = phase_.generation();
  return *segment_;
}

ExactPhases::ExactPhases(const Equations &equations, const Settings &settings)
    : equations_(equations), settings_(settings), longest_piece_(longest_piece(equations.model())) {
}

bool ExactPhases::take_sources(double time) {
  sources_.clear();
  for (const model::Source &source : equations_.model().sources()) {
    std::optional<model::ExponentialForm> form = source.function->exponential_form(time);
    if (!form)
      return false;
    sources_.push_back(*std::move(form));
  }
  excitation_.take(sources_);
  return true;
}

LinearPhase *ExactPhases::find() {
  const auto known = phases_.find(equations_.modes());
  if (known != phases_.end())
    return known->second.get();
  std::unique_ptr<LinearPhase> &made = phases_[equations_.modes()];
  if (LinearSystem::holds(equations_))
    made = std::make_unique<LinearPhase>(equations_, settings_, longest_piece_);
  return made.get();
}

bool ExactPhases::linear() { return find() != nullptr; }

LinearPhase *ExactPhases::present() {
  LinearPhase *const found = find();
  if (found)
    found->phase().take(excitation_);
  return found;
}

void ExactPhases::forget() {
  for (const auto &[modes, known] : phases_)
    if (known)
      known->phase().forget();
}

} // namespace vibroimpact::motion
