#include "analyses/recorders/lyapunov.h"

#include "analyses/results/fields.h"
#include "analyses/sweeps/steadiness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact::analyses {

using motion::Trajectory;

namespace {

constexpr const char *lyapunov_section = "Lyapunov";
constexpr double intervals_without_periods = 200;

// Deviations that lie in no plane of symmetry: unequal parts of every state, independent of each
// other.
Matrix generic_deviations(const Vector &scale, Index count) {
  Matrix deviations(scale.size(), count);
  for (Index k = 0; k < count; ++k)
    for (Index j = 0; j < scale.size(); ++j)
      deviations(j, k) =
          std::cos(1 + static_cast<double>(j) * static_cast<double>(k + 1)) / scale[j];
  return deviations;
}

// The dimension of Kaplan and Yorke: with the sum S_j of the first j exponents, the largest j with
// S_j >= 0, plus S_j / |lambda_(j+1)|. NaN when that exponent is not known.
double kaplan_yorke_dimension(const std::vector<double> &exponents, bool all) {
  double sum = 0;
  for (std::size_t j = 0; j < exponents.size(); ++j) {
    if (sum + exponents[j] < 0)
      return static_cast<double>(j) - sum / exponents[j];
    sum += exponents[j];
  }
  return all ? static_cast<double>(exponents.size()) : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

void LyapunovExponents::begin(const Window &window, const Trajectory &trajectory) {
  const double forcing = window.period > 0 ? 2 * std::numbers::pi / window.period : 1;
  const Vector scale = deviation_scale(trajectory.equations(), forcing);
  const Index count = settings_.exponents > 0
                          ? std::min(static_cast<Index>(settings_.exponents), scale.size())
                          : scale.size();
  growths_.assign(static_cast<std::size_t>(count), Growth(settings_.discarded_share));
  divergence_ = Growth(settings_.discarded_share);
  variation_.emplace(trajectory, scale, settings_.tolerance);
  variation_->set_columns(generic_deviations(scale, count));
  variation_->orthonormalise();
  logarithms_ = Vector::Zero(count);
  determinant_ = 0;
  interval_start_ = trajectory.time();
  interval_ = window.cycles > 0 ? 0 : (window.end - window.start) / intervals_without_periods;
}

void LyapunovExponents::end_interval(double time) {
  for (std::size_t k = 0; k < growths_.size(); ++k)
    growths_[k].add(time - interval_start_, logarithms_[static_cast<Index>(k)]);
  logarithms_.setZero();
  const double determinant = variation_->determinant().logarithm;
  divergence_.add(time - interval_start_,
                  std::isinf(determinant) ? determinant : determinant - determinant_);
  determinant_ = determinant;
  interval_start_ = time;
}

void LyapunovExponents::step(const motion::StepView &view) {
  variation_->step(view);
  logarithms_ += variation_->orthonormalise();
  if (interval_ > 0 && view.end() - interval_start_ >= interval_)
    end_interval(view.end());
}

void LyapunovExponents::event(const motion::ContactEvent &event) {
  variation_->event(event);
  logarithms_ += variation_->orthonormalise();
}

std::vector<double> LyapunovExponents::exponents() const {
  std::vector<double> exponents;
  for (const Growth &growth : growths_)
    exponents.push_back(growth.exponent());
  return exponents;
}

std::vector<double> LyapunovExponents::standard_errors() const {
  std::vector<double> errors;
  for (const Growth &growth : growths_)
    errors.push_back(growth.standard_error(static_cast<std::size_t>(settings_.blocks)));
  return errors;
}

void LyapunovRecorder::declare(parameters::Section &analysis) {
  using namespace parameters;
  analysis
      .subsection(lyapunov_section, "The largest Lyapunov exponents, by the variational equation "
                                    "through the contacts.")
      .integer("Exponents", "1", Range{.lower = 0, .upper = 1e6}, "n",
               "Number of exponents, the largest first; 0: one for each physical state "
               "(coordinates, velocities, internal states of contacts, torques).")
      .quantity("Discarded share", "0.1", dimension::none,
                Range{.lower = 0, .upper = 1, .upper_open = true}, "",
                "Share of the window at its start discarded at the start of the window, while "
                "perturbations align with the directions of largest growth.")
      .integer("Blocks", "10", Range{.lower = 2, .upper = 1e6}, "",
               "Blocks whose means give the standard error; each should be longer than the motion "
               "remembers.")
      .quantity("Tolerance", "1e-8", dimension::none, Range{.lower = 1e-14, .upper = 1e-2}, "",
                "Relative error of the deviation in a time step.");
}

RecorderFactory LyapunovRecorder::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(lyapunov_section);
  const LyapunovSettings settings{.exponents = values.integer("Exponents"),
                                  .discarded_share = values.quantity("Discarded share"),
                                  .blocks = values.integer("Blocks"),
                                  .tolerance = values.quantity("Tolerance")};
  return [settings, values](const System &system) -> std::unique_ptr<Recorder> {
    const auto states =
        2 * system.model.size() + system.contacts.n_internal() + system.model.n_drive();
    if (settings.exponents > states)
      values.reject("Exponents", "must be at most " + std::to_string(states) +
                                     ", the number of physical states of the system.");
    return std::make_unique<LyapunovRecorder>(settings);
  };
}

void LyapunovRecorder::begin(const Window &window, const Trajectory &trajectory) {
  period_ = window.period;
  exponents_.begin(window, trajectory);
  all_ = static_cast<Index>(exponents_.exponents().size()) == trajectory.layout().physical_size();
}

void LyapunovRecorder::period_end(long /*cycle*/, const Trajectory &trajectory) {
  exponents_.period_end(trajectory.time());
}

void LyapunovRecorder::add_fields(const FieldWriter &result) const {
  const double exponent = exponents_.exponents().front();
  const FieldWriter of = result.below("lyapunov/"), listed = of.listed();
  listed.number("exponent", exponent, "1/s", "largest Lyapunov exponent");
  listed.number("standard_error", exponents_.standard_errors().front(), "1/s",
                "of the exponent, from the means of blocks");
  listed.number("tangential_events", static_cast<double>(exponents_.tangential_events()), "1",
                "contact changes whose instant has no derivative; passed as if fixed");
  listed.number("mean_divergence", exponents_.mean_divergence(), "1/s",
                "mean growth rate of the volume of all perturbations (mean divergence), which is "
                "the sum of all exponents");
  if (period_ > 0)
    listed.number("exponent_per_period", exponent * period_, "1",
                  "largest Lyapunov exponent times the forcing period");
  if (exponents_.exponents().size() > 1) {
    listed.number("kaplan_yorke_dimension", kaplan_yorke_dimension(exponents_.exponents(), all_),
                  "1", "dimension of Kaplan and Yorke; NaN when more exponents are needed");
    of.series("spectrum", "lyapunov_exponent", exponents_.exponents(), "1/s",
              "Lyapunov exponents, the largest first; -infinity where deviations end in an event");
    of.series("spectrum_error", "lyapunov_exponent", exponents_.standard_errors(), "1/s",
              "standard errors of the exponents");
  }
  of.series("elapsed", "lyapunov_interval", exponents_.growth().elapsed(), "s",
            "time since the window began");
  of.series("running_exponent", "lyapunov_interval", exponents_.growth().running_exponent(), "1/s",
            "exponent from the intervals up to this one");
}

} // namespace vibroimpact::analyses
