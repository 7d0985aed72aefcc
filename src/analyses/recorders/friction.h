// What friction does in a window: work, wear, ways, and how long the sides stick and slip.
//
// Works are those that the equations of motion integrate; the work rate of wear is the mean of the
// normal force times the speed at which the surfaces slide on each other, without any elastic part
// of the slip.
#pragma once

#include "analyses/recorders/recorder.h"

#include <vector>

namespace vibroimpact::analyses {

class FrictionRecorder : public Recorder {
public:
  explicit FrictionRecorder(const System &system);

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  /// Modes and events say all.
  bool sees_steps(const motion::Equations & /*equations*/) const override { return false; }
  void interval(const motion::Interval &part) override;
  void event(const motion::ContactEvent &event) override;
  void end(const motion::Trajectory &trajectory) override;
  /// For every contact C with friction: contact/C/friction/energy [J], /work_rate [W],
  /// /sliding_way [m], /stick_fraction, /slip_fraction, /sticks, /slips.
  void add_fields(const FieldWriter &result) const override;

private:
  struct Labels {
    explicit Labels(const std::string &contact);
    Label energy, work_rate, sliding_way, stick_fraction, slip_fraction, sticks, slips;
  };
  /// Of one contact.
  struct Track {
    std::size_t contact = 0;
    Labels labels;
    double stuck = 0, slipped = 0; ///< [s]
    long sticks = 0, slips = 0;    ///< begun
  };
  const contact::ContactSet &contacts_;
  std::vector<Track> tracks_; ///< in the order of ContactPair::sliding_place
  Window window_;
  Vector first_, change_; ///< states
  motion::StateLayout layout_;
};

} // namespace vibroimpact::analyses
