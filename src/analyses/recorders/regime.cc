#include "analyses/recorders/regime.h"

#include "analyses/results/fields.h"
#include "analyses/sweeps/steadiness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {

namespace {

constexpr const char *regime_section = "Regime";
/// Components that move less than this part of the largest of their kind count by that instead.
constexpr double smallest_relative_scale = 1e-3;

const LyapunovSettings exponent_settings;

// Logarithm of the growth of deviations that go with the square of the time.
double algebraic_growth() { return -2 * std::log(exponent_settings.discarded_share); }

} // namespace

RegimeRecorder::RegimeRecorder(const System &system, RegimeSettings settings)
    : system_(system), settings_(std::move(settings)), impacts_(system.contacts.size(), 0) {
  if (settings_.exponent)
    exponents_.emplace(exponent_settings);
}

void RegimeRecorder::declare(parameters::Section &analysis) {
  using namespace parameters;
  analysis
      .subsection(regime_section, "Regime (kT, n, m): the repetition of the motion and the impacts "
                                  "in it.")
      .integer("Longest repetition", "16", Range{.lower = 1, .upper = 1e6}, "k",
               "Longest repetition looked for, in forcing periods; only those that fit twice into "
               "the recorded window are.")
      .quantity("Repetition tolerance", "1e-7", dimension::none,
                Range{.lower = 0, .upper = 1, .lower_open = true}, "",
                "Largest difference between states a repetition apart, relative to the scales.")
      .quantities("Scales", "", dimension::any, range::positive, "s_j",
                  "Sizes in SI that count as one, one number for each coordinate, then each "
                  "velocity, then each internal state of contacts and torque; empty: half the "
                  "peak-to-peak range of each during the window.",
                  0, 1000000)
      .boolean("Exponent", "true",
               "Compute the largest Lyapunov exponent, which distinguishes quasi-periodic from "
               "chaotic motions.")
      .quantity("Exponent threshold", "0.02", dimension::none, range::positive, "",
                "Exponent times forcing period above which a motion counts as chaotic.");
}

RecorderFactory RegimeRecorder::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(regime_section);
  const RegimeSettings settings{.longest = values.integer("Longest repetition"),
                                .tolerance = values.quantity("Repetition tolerance"),
                                .scales = values.quantities("Scales"),
                                .exponent = values.boolean("Exponent"),
                                .exponent_threshold = values.quantity("Exponent threshold")};
  return [settings, values](const System &system) -> std::unique_ptr<Recorder> {
    const auto size =
        2 * system.model.size() + system.contacts.n_internal() + system.model.n_drive();
    if (!settings.scales.empty() && static_cast<Index>(settings.scales.size()) != size)
      values.reject("Scales",
                    "must have " + std::to_string(size) + " numbers, one for each state, or none");
    return std::make_unique<RegimeRecorder>(system, settings);
  };
}

void RegimeRecorder::begin(const Window &window, const motion::Trajectory &trajectory) {
  period_ = window.period;
  layout_ = trajectory.layout();
  const double forcing = period_ > 0 ? 2 * std::numbers::pi / period_ : 1;
  const Vector reach = state_scale(trajectory.equations(), forcing);
  reach_ = (reach.array() > 0).select(reach, 1);
  states_ = {trajectory.motion_state().physical};
  std::fill(impacts_.begin(), impacts_.end(), 0);
  smallest_ = largest_ = states_.front();
  if (exponents_)
    exponents_->begin(window, trajectory);
}

void RegimeRecorder::step(const motion::StepView &view) {
  const auto physical = view.end_state().head(layout_.physical_size());
  smallest_ = smallest_.cwiseMin(physical);
  largest_ = largest_.cwiseMax(physical);
  if (exponents_)
    exponents_->step(view);
}

void RegimeRecorder::event(const motion::ContactEvent &event) {
  if (event.onset)
    ++impacts_[event.contact];
  if (exponents_)
    exponents_->event(event);
}

void RegimeRecorder::period_end(long /*cycle*/, const motion::Trajectory &trajectory) {
  states_.push_back(trajectory.motion_state().physical);
  if (exponents_)
    exponents_->period_end(trajectory.time());
}

// A component at rest has no range of its own; what it does is then judged by the largest range of
// its kind.
Vector RegimeRecorder::scales() const {
  if (!settings_.scales.empty())
    return ConstVectorView(settings_.scales.data(), static_cast<Index>(settings_.scales.size()));
  Vector half = 0.5 * (largest_ - smallest_).cwiseProduct(reach_);
  const auto raise = [&half](Index first, Index count) {
    if (count == 0)
      return;
    const double largest = half.segment(first, count).maxCoeff();
    const double floor = largest > 0 ? smallest_relative_scale * largest : 1;
    half.segment(first, count) = half.segment(first, count).cwiseMax(floor);
  };
  raise(0, layout_.n);
  raise(layout_.velocity(), layout_.n);
  raise(layout_.internal(), layout_.n_internal);
  raise(layout_.drive(), layout_.n_drive);
  return half.cwiseQuotient(reach_);
}

StroboscopicPoints RegimeRecorder::points() const {
  std::vector<Index> angles;
  for (const model::Rotor &rotor : system_.model.rotors().list())
    angles.push_back(rotor.angle);
  return {states_, scales(), angles};
}

// Of the exponent.
double RegimeRecorder::counted_periods() const {
  const auto cycles = static_cast<double>(states_.size() - 1);
  return cycles - std::floor(exponent_settings.discarded_share * cycles);
}

// `growth`: per period.
bool RegimeRecorder::grows_exponentially(double growth) const {
  return growth > settings_.exponent_threshold && growth * counted_periods() > algebraic_growth();
}

// Periods of a window that tells chaotic from quasi-periodic motions: growth at the threshold shows
// as exponential, and the standard error has two intervals in each block.
double RegimeRecorder::deciding_cycles() const {
  const double counted = std::max(algebraic_growth() / settings_.exponent_threshold,
                                  2.0 * static_cast<double>(exponent_settings.blocks));
  return std::ceil(counted / (1 - exponent_settings.discarded_share));
}

Regime RegimeRecorder::classify(const Repetition &repetition, const Approach &approach) const {
  if (repetition.multiple > 0)
    return Regime::periodic;
  const double growth = exponents_ ? exponents_->exponents().front() * period_ : 0;
  const bool known = exponents_ && std::isfinite(exponents_->standard_errors().front());
  if (known && grows_exponentially(growth))
    return Regime::chaotic;
  // Deviations that shrink leave nothing but a motion that repeats.
  if (approach.multiple > 0 || (exponents_ && growth < -settings_.exponent_threshold))
    return Regime::settling;
  if (!exponents_)
    return Regime::aperiodic;
  return known && growth <= settings_.exponent_threshold ? Regime::quasi_periodic
                                                         : Regime::undecided;
}

// Impacts at the very end of a period may fall on either side of it: the mean over all repetitions
// in the window, rounded, is the count of each.
void RegimeRecorder::add_impacts(const FieldWriter &result, long multiple) const {
  const auto cycles = static_cast<double>(states_.size() - 1);
  for (std::size_t c = 0; c < impacts_.size(); ++c) {
    const std::string &name = system_.contacts.pairs()[c].name;
    const double per_period = static_cast<double>(impacts_[c]) / cycles;
    result.number("impacts_per_period/" + name, per_period, "1",
                  "impacts begun per forcing period");
    result.number("impacts_per_repetition/" + name,
                  multiple > 0 ? std::round(per_period * static_cast<double>(multiple))
                               : std::numeric_limits<double>::quiet_NaN(),
                  "1", "impacts until the motion repeats; NaN when it does not");
  }
}

void RegimeRecorder::add_fields(const FieldWriter &result) const {
  const FieldWriter of = result.below("regime/").listed();
  const StroboscopicPoints points = this->points();
  Repetition repetition = find_repetition(points, settings_.longest, settings_.tolerance);
  Approach approach;
  if (repetition.multiple > 1)
    approach = find_spiral(points, repetition.multiple);
  if (approach.multiple > 0)
    repetition.multiple = 0;
  else if (repetition.multiple == 0)
    approach = find_approach(points, settings_.longest);
  const Regime regime = classify(repetition, approach);
  of.number(
      "class", static_cast<double>(regime), "1",
      "0 does not repeat, 1 periodic, 2 settling towards a periodic motion, 3 quasi-periodic, "
      "4 chaotic, 5 not decided between 3 and 4: a longer window would");
  if (regime == Regime::undecided)
    of.line("cycles_that_would_decide", deciding_cycles(), "1");
  of.number("period_multiple", static_cast<double>(repetition.multiple), "1",
            "forcing periods after which the motion repeats; 0 when it does not");
  of.number(
      "difference", repetition.difference, "1",
      "largest relative difference of states a repetition apart; without one the smallest of all");
  of.number("longest_searched", static_cast<double>(repetition.searched), "1",
            "longest repetition looked for, in forcing periods");
  of.number("approached_multiple", static_cast<double>(approach.multiple), "1",
            "forcing periods of the repetition the motion approaches; 0 when none is recognised");
  of.number("remaining", approach.multiple > 0 ? approach.remaining : 0, "1",
            "estimated relative distance to that motion at the end of the window");
  if (exponents_) {
    of.number("exponent", exponents_->exponents().front(), "1/s", "largest Lyapunov exponent");
    of.number("exponent_error", exponents_->standard_errors().front(), "1/s",
              "standard error of it; NaN where the window has too few periods");
  }
  add_impacts(of, repetition.multiple);
}

} // namespace vibroimpact::analyses
