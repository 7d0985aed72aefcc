// What friction does in a window: work, wear, ways, and how long the sides stick and slip.
//
// Works are those that the equations of motion integrate; the work rate of wear is the mean of the
// normal force times the speed at which the surfaces slide on each other, without any elastic part
// of the slip. In circular gaps both are known by sectors of the circumference too.
#pragma once

#include "analyses/recorders/recorder.h"
#include "analyses/recorders/sector_work.h"
#include "analyses/recorders/window_blocks.h"

#include <optional>
#include <vector>

namespace vibroimpact::analyses {

struct FrictionSettings {
  long sectors = 0; ///< of each circular gap; 0: none
  long blocks = 10; ///< of the standard errors
};

class FrictionRecorder : public Recorder {
public:
  FrictionRecorder(const FrictionSettings &settings, const System &system);

  static void declare(parameters::Section &analysis);
  static RecorderFactory create(const parameters::Values &analysis);

  void begin(const Window &window, const motion::Trajectory &trajectory) override;
  void period_end(long cycle, const motion::Trajectory &trajectory) override;
  /// Modes and events say all but how the work is spread over sectors.
  bool sees_steps(const motion::Equations &equations) const override;
  void step(const motion::StepView &view) override;
  void interval(const motion::Interval &part) override;
  void event(const motion::ContactEvent &event) override;
  void end(const motion::Trajectory &trajectory) override;
  /// For every contact C with friction: contact/C/friction/energy [J], /work_rate [W] with its
  /// standard error /work_rate_error, /sliding_way [m], /stick_fraction, /slip_fraction, /sticks,
  /// /slips; with sectors /sector/work_rate, /work_rate_error, /energy along friction_sector, and
  /// /largest_work_rate, /largest_work_rate_error and /largest_angle of the one that wears most.
  void add_fields(const FieldWriter &result) const override;

private:
  struct Labels {
    explicit Labels(const std::string &contact);
    Label energy, work_rate, work_rate_error, sliding_way, stick_fraction, slip_fraction, sticks,
        slips;
  };
  struct SectorLabels {
    explicit SectorLabels(const std::string &contact);
    Label energy, work_rate, work_rate_error, largest, largest_error, largest_angle;
  };
  struct Sectors {
    SectorLabels labels;
    SectorWork work;
  };
  /// Of one contact.
  struct Track {
    std::size_t contact = 0;
    Labels labels;
    std::optional<Sectors> sectors{};
    double stuck = 0, slipped = 0; ///< [s]
    long sticks = 0, slips = 0;    ///< begun
  };
  Vector wear(const Vector &state) const;
  void add_angles(const FieldWriter &result) const;
  void add_impact(const motion::ContactEvent &event);
  void add_sectors(const Sectors &sectors, const Vector &errors, const FieldWriter &result) const;

  const contact::ContactSet &contacts_;
  FrictionSettings settings_;
  std::vector<Track> tracks_; ///< in the order of ContactPair::sliding_place
  Window window_;
  Vector first_, change_; ///< states
  WindowBlocks blocks_;   ///< of what wear() gives
  motion::StateLayout layout_;
};

} // namespace vibroimpact::analyses
