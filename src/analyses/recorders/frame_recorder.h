// What pictures and stresses of a motion are made of, at some instants of it.
#pragma once

#include "analyses/run/system.h"
#include "common/result_sink.h"
#include "motion/event/impact_log.h"

#include <vector>

namespace vibroimpact::analyses {

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
