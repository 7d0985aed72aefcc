// Samples a motion at equal intervals, from the dense output: the steps are not disturbed.
#pragma once

#include "analyses/channels.h"
#include "analyses/field_writer.h"
#include "analyses/system.h"
#include "motion/event/impact_log.h"
#include "motion/trajectory.h"

#include <vector>

namespace vibroimpact::analyses {

/// Instants first, first + interval, ... up to last, inclusive (within rounding).
std::vector<double> equal_instants(double first, double last, double interval);

/// Channels, gaps and forces at given instants (increasing; those at the very start included).
class MotionRecorder : public motion::Observer {
public:
  MotionRecorder(const System &system, std::vector<double> instants);

  void step(const motion::StepView &view) override;

  /// Adds `time` and one field per channel and contact along the dimension `time`.
  void add_fields(const FieldWriter &result) const;

private:
  struct Series {
    std::vector<double> displacement, velocity, acceleration;
  };
  struct ContactSeries {
    std::vector<double> gap, force;
  };
  void sample(const motion::StepView &view, std::size_t first, std::size_t last);

  const contact::ContactSet &contacts_;
  std::vector<Channel> channels_;
  std::vector<double> instants_;
  std::size_t next_ = 0;
  std::vector<Series> series_;
  std::vector<ContactSeries> contact_series_;
};

/// Modal coordinates of all bodies and their rates, gaps and forces of all contacts at given
/// instants, for the expansion to the mesh.
class FrameRecorder : public motion::Observer {
public:
  FrameRecorder(const System &system, std::vector<double> instants);

  void step(const motion::StepView &view) override;
  /// With the peak forces of the impacts that the log of the same motion holds.
  Motion motion(const motion::ImpactLog &log) const;

private:
  void sample_coordinates(const motion::StepView &view, std::size_t last);
  void sample_contacts(const motion::StepView &view, std::size_t last);

  const model::Model &model_;
  std::vector<double> instants_;
  std::size_t next_ = 0;
  Motion motion_;
};

} // namespace vibroimpact::analyses
