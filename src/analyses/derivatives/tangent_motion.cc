#include "analyses/derivatives/tangent_motion.h"

#include "analyses/recorders/window_recording.h"
#include "motion/variation/variation.h"

namespace vibroimpact::analyses {

namespace {

/// Beside the variation: it asks for the derivative before and after each event.
class Along : public motion::Observer {
public:
  Along(const motion::Trajectory &trajectory, motion::Variation &variation,
        const motion::KeyTangent &key, FormTangents &forms, TangentVisitor &visitor)
      : trajectory_(trajectory), variation_(variation), key_(key), forms_(forms), visitor_(visitor),
        before_(trajectory.equations()), after_(trajectory.equations()) {}

  bool sees_steps(const motion::Equations &equations) const override {
    return variation_.sees_steps(equations);
  }
  bool follows_phases() const override { return true; }
  void step(const motion::StepView &view) override { variation_.step(view); }
  void interval(const motion::Interval &interval) override { variation_.interval(interval); }
  bool wants_integrals() const override { return false; }
  void event(const motion::ContactEvent &event) override;
  Vector change() { return variation_.columns().col(0) + variation_.key_columns().col(0); }

private:
  void take_modes(const motion::ContactEvent &event);
  double delay(const motion::ContactEvent &event, const TangentPoint &before);

  const motion::Trajectory &trajectory_;
  motion::Variation &variation_;
  const motion::KeyTangent &key_;
  FormTangents &forms_;
  TangentVisitor &visitor_;
  motion::Equations before_, after_; ///< in the modes on both sides of an event
  double collision_ = 0;             ///< instant of the last one [s]
  double collision_delay_ = 0;
};

// Of several events of one collision the first one says all modes.
void Along::take_modes(const motion::ContactEvent &event) {
  before_.set_source_break(trajectory_.equations().source_break());
  after_.set_source_break(trajectory_.equations().source_break());
  for (std::size_t c = 0; c < after_.modes().size(); ++c)
    before_.set_mode(c, event.collision ? event.collision->modes_before[c] : after_.modes()[c]);
  if (event.collision)
    for (std::size_t c = 0; c < after_.modes().size(); ++c)
      after_.set_mode(c, event.collision->modes_after[c]);
  else
    after_.set_mode(event.contact, event.to);
}

double Along::delay(const motion::ContactEvent &event, const TangentPoint &before) {
  const bool impact = event.guard->action == contact::GuardAction::impact;
  if (impact && !event.collision && event.time == collision_)
    return collision_delay_;
  const double delay = forms_.delay(event, before);
  if (impact) {
    collision_ = event.time;
    collision_delay_ = delay;
  }
  return delay;
}

void Along::event(const motion::ContactEvent &event) {
  take_modes(event);
  const TangentPoint before(before_, key_, event.time, *event.before, change());
  const double delay = this->delay(event, before);
  variation_.event(event);
  const TangentPoint after(after_, key_, event.time, *event.state, change());
  visitor_.event({.event = event, .before = before, .after = after, .delay = delay});
}

/// Where the motion starts, how its state there changes with the key at the fixed time, and its
/// end.
struct TangentWindow {
  motion::MotionState start;
  Vector change;  ///< physical_size() entries per unit of the key
  double end = 0; ///< [s]
};

void follow(motion::Trajectory &trajectory, const TangentWindow &window, motion::KeyTangent &key,
            const motion::VariationAccuracy &accuracy, FormTangents &forms,
            TangentVisitor &visitor) {
  trajectory.start(window.start);
  motion::Variation variation(trajectory, accuracy.scale, accuracy.tolerance, {&key});
  variation.set_columns(window.change);
  Along along(trajectory, variation, key, forms, visitor);
  const std::vector<double> stops = visitor.stops();
  for (std::size_t i = 0; i < stops.size(); ++i) {
    if (stops[i] > trajectory.time())
      trajectory.advance(stops[i], along);
    visitor.stop(
        i, {trajectory.equations(), key, trajectory.time(), trajectory.state(), along.change()});
  }
  trajectory.advance(window.end, along);
}

} // namespace

PointResult measure_tangents(const RecordedOrbit &motion, periodic::ForcedKey &key,
                             const std::vector<motion::KeyNeighbour> &neighbours,
                             const Vector &by_key) {
  periodic::ForcedSystem forced = forced_like(motion.system, motion, motion.map.period());
  const double phase = motion.orbit.section.phase, start = phase * forced.period();
  const TangentWindow window{
      .start = {.time = start, .physical = motion.orbit.point.state},
      .change = by_key - phase * key.period * motion.map.rates(phase, motion.orbit.point.state),
      .end = periods_window(start, forced.period(), motion.orbit.multiple()).end};
  WindowRecording recording(motion.recorders, motion.system);
  recording.keep_extrema();
  SmoothIntervals intervals;
  forced.trajectory().start(window.start);
  recording.run({.start = start, .end = window.end}, forced.trajectory(), {&intervals});
  PointResult result;
  if (recording.empty() || (intervals.breaks && key.tangent.sources().break_rate() != 0))
    return result;
  FormTangents forms(motion.system, neighbours);
  ExtremeTangents extremes(recording.extrema(), intervals.events, forms);
  ImpactTangents impacts(motion.system.contacts, intervals.list, forms);
  for (TangentVisitor *visitor :
       {static_cast<TangentVisitor *>(&extremes), static_cast<TangentVisitor *>(&impacts)})
    follow(forced.trajectory(), window, key.tangent, orbit_accuracy(motion.system, forced), forms,
           *visitor);
  if (extremes.events() == intervals.events.size())
    recording.add_tangents({.extremes = extremes, .impacts = impacts}, result);
  return result;
}

} // namespace vibroimpact::analyses
