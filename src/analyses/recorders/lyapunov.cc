#include "analyses/recorders/lyapunov.h"

#include "analyses/fields.h"
#include "analyses/steadiness.h"

#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {

using motion::Trajectory;

namespace {

constexpr const char *section_name = "Lyapunov";
constexpr double intervals_without_periods = 200;

// Some deviation that lies in no plane of symmetry: unequal parts of every state.
Vector generic_deviation(const Vector &scale) {
  Vector deviation(scale.size());
  for (Index j = 0; j < scale.size(); ++j)
    deviation[j] = std::cos(1 + static_cast<double>(j)) / scale[j];
  return deviation;
}

// Where a coordinate moves no point, its own unit is as good as any.
Vector usable_scale(const Trajectory &trajectory, double period) {
  const double forcing = period > 0 ? 2 * std::numbers::pi / period : 1;
  const Vector scale = state_scale(trajectory.equations(), forcing);
  return (scale.array() > 0).select(scale, 1);
}

} // namespace

void LyapunovExponent::begin(const Window &window, const Trajectory &trajectory) {
  const Vector scale = usable_scale(trajectory, window.period);
  growth_ = Growth(settings_.discarded_share);
  variation_.emplace(trajectory, scale, settings_.tolerance);
  variation_->set_columns(generic_deviation(scale));
  variation_->normalise(0);
  interval_start_ = trajectory.time();
  interval_ = window.cycles > 0 ? 0 : (window.end - window.start) / intervals_without_periods;
}

void LyapunovExponent::end_interval(double time) {
  growth_.add(time - interval_start_, std::log(variation_->size(0)));
  variation_->normalise(0);
  interval_start_ = time;
}

void LyapunovExponent::step(const motion::StepView &view) {
  variation_->step(view);
  if (interval_ > 0 && view.end() - interval_start_ >= interval_)
    end_interval(view.end());
}

void LyapunovExponent::period_end(double time) { end_interval(time); }

void LyapunovRecorder::declare(parameters::Section &analysis) {
  using namespace parameters;
  analysis
      .subsection(section_name, "Largest Lyapunov exponent, by the variational equation through "
                                "the contacts.")
      .quantity("Discarded share", "0.1", dimension::none,
                Range{.lower = 0, .upper = 1, .upper_open = true}, "",
                "Share of the window at its start that lets the deviation turn into the direction "
                "of largest growth and does not count.")
      .integer("Blocks", "10", Range{.lower = 2, .upper = 1e6}, "",
               "Blocks whose means give the standard error; each should be longer than the motion "
               "remembers.")
      .quantity("Tolerance", "1e-8", dimension::none, Range{.lower = 1e-14, .upper = 1e-2}, "",
                "Relative error of the deviation in a time step.");
}

RecorderFactory LyapunovRecorder::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(section_name);
  const LyapunovSettings settings{.discarded_share = values.quantity("Discarded share"),
                                  .blocks = values.integer("Blocks"),
                                  .tolerance = values.quantity("Tolerance")};
  return [settings](const System & /*system*/) -> std::unique_ptr<Recorder> {
    return std::make_unique<LyapunovRecorder>(settings);
  };
}

void LyapunovRecorder::begin(const Window &window, const Trajectory &trajectory) {
  period_ = window.period;
  exponent_.begin(window, trajectory);
}

void LyapunovRecorder::period_end(long /*cycle*/, const Trajectory &trajectory) {
  exponent_.period_end(trajectory.time());
}

void LyapunovRecorder::add_fields(PointResult &result) const {
  std::vector<Field> scalars = {
      scalar_field("lyapunov/exponent", exponent_.exponent(), "1/s", "largest Lyapunov exponent"),
      scalar_field("lyapunov/standard_error", exponent_.standard_error(), "1/s",
                   "of the exponent, from the means of blocks"),
      scalar_field("lyapunov/tangential_events", static_cast<double>(exponent_.tangential_events()),
                   "1", "contact changes whose instant has no derivative; passed as if fixed")};
  if (period_ > 0)
    scalars.push_back(scalar_field("lyapunov/exponent_per_period", exponent_.exponent() * period_,
                                   "1", "largest Lyapunov exponent times the forcing period"));
  for (const Field &field : scalars) {
    result.summary.push_back(
        scalar_line("lyapunov." + field.name().substr(field.name().find('/') + 1), field.values[0],
                    field.unit()));
    result.fields.push_back(field);
  }
  result.fields.push_back(series_field("lyapunov/elapsed", "lyapunov_interval",
                                       exponent_.growth().elapsed(), "s",
                                       "time since the window began"));
  result.fields.push_back(series_field("lyapunov/running_exponent", "lyapunov_interval",
                                       exponent_.growth().running_exponent(), "1/s",
                                       "exponent from the intervals up to this one"));
}

} // namespace vibroimpact::analyses
