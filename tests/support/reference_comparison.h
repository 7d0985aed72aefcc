// The program's motion of a system beside its reference.
#pragma once

#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "support/reference_motion.h"

namespace vibroimpact::testing {

struct ProgramMotion {
  Vector displacement, velocity; ///< at the end
  std::vector<std::vector<motion::Impact>> impacts;
  motion::Accuracy accuracy;
};

/// From time 0 to `end` by the whole program. Each coordinate moves a point along x. The event
/// tolerance is set far below what the relative one allows.
ProgramMotion program_motion(const ReferenceSystem &system, const ReferenceStart &start, double end,
                             double tolerance, const std::string &method = "exact");

/// Differences, each relative to the largest value of the motion or of the impact.
struct MotionError {
  double state = 0;          ///< displacements and velocities at the end
  double instant = 0;        ///< onsets and releases, over the duration of the impact
  double impulse = 0;        ///< impulses; separation speeds over approach speeds
  double energy = 0;         ///< dissipated, over the kinetic energy that met
  double deepest = 0;        ///< largest penetrations
  bool same_contacts = true; ///< as many finished impacts of each contact

  double largest() const; ///< of state, instant and impulse
};
MotionError compare(const ProgramMotion &motion, const ReferenceSystem &system,
                    const ReferenceResult &reference);

/// How much a relative change of the initial velocities grows up to the end, at least 1: what
/// errors of the first contact may become.
double amplification(const ReferenceSystem &system, const ReferenceStart &start, double end);

} // namespace vibroimpact::testing
