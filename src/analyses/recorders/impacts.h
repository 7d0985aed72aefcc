// Figures of the impacts in a window: how many, how hard, how long.
//
// All is of impacts that begin in the window. Those that still last at its end are counted, and by
// themselves as well; their peak force and penetration are those up to then. Impulse and duration
// are of impacts that also end in the window, for a part of an impact would falsify the mean.
#pragma once

#include "analyses/recorders/recorder.h"
#include "analyses/results/field_writer.h"
#include "motion/event/impact_log.h"

#include <vector>

namespace vibroimpact::analyses {

/// PATH/mean, /minimum, /maximum of the impacts.
struct RangeLabels {
  RangeLabels(const std::string &path, const std::string &unit, const std::string &meaning);
  Label mean, minimum, maximum;
};

class Impacts : public Recorder {
public:
  explicit Impacts(const System &system);

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void outputs(const motion::Equations &equations, std::vector<motion::Output> &list) override {
    log_.outputs(equations, list);
  }
  bool sees_steps(const motion::Equations &equations) const override {
    return log_.sees_steps(equations);
  }
  void step(const motion::StepView &view) override;
  void interval(const motion::Interval &interval) override;
  void event(const motion::ContactEvent &event) override;
  void end(const motion::Trajectory &trajectory) override;
  /// For every contact C: contact/C/impacts, /unfinished, /impacts_per_period (where the window has
  /// periods), /contact_fraction, /chatters, and mean, minimum and maximum of /approach_speed,
  /// /impulse, /peak_force, /contact_duration, /penetration; these are NaN without an impact.
  void add_fields(const FieldWriter &result) const override;
  bool keeps_extrema() override;
  /// Of the force and the overlap of each impact.
  std::vector<ObservedExtremum> extrema() const override;
  void add_tangents(const TangentMotion &motion, const FieldWriter &result) const override;

private:
  /// Of the impacts of one contact.
  struct Labels {
    explicit Labels(const std::string &contact);
    Label impacts, unfinished, impacts_per_period, contact_fraction, chatters;
    RangeLabels approach_speed, impulse, peak_force, contact_duration, penetration;
  };
  void note_contacts(const motion::Interval &interval);

  const contact::ContactSet &contacts_;
  std::vector<Labels> labels_;
  Window window_;
  motion::ImpactLog log_;
  std::vector<double> time_in_contact_; ///< [s]
  std::vector<long> chatters_;
  std::vector<std::vector<double>> approach_speeds_; ///< per contact [m/s]
};

} // namespace vibroimpact::analyses
