// Stepped sweep: at each excitation frequency, or each value of any other key, the motion settles,
// is judged steady, and is then observed for some periods; the state at the end starts the next
// point.
//
// A point takes a whole number of forcing periods and every point begins at time zero, so that
// frequency or parameter change at the forcing phase of time zero, the whole physical state
// (coordinates, velocities, internal states of contacts, torques of motors) carried over. Steady
// means: the state seen once per period (stroboscopically) repeats after some k <= longest multiple
// of periods, and the distance still to go, estimated from the last changes as a geometric series,
// is below the tolerance times the size of the motion.
#pragma once

#include "analyses/analysis.h"
#include "analyses/keys/swept_parameter.h"
#include "analyses/recorders/recorders.h"
#include "analyses/sweeps/jump_search.h"
#include "analyses/sweeps/settling.h"

#include <optional>

namespace vibroimpact::analyses {

class SweptSystem;

class SteppedSweep : public Analysis {
public:
  /// `independent`: every point starts from the initial conditions.
  enum class Directions { forward, backward, both, independent };

  struct Settings {
    SweptParameter parameter;
    Directions directions = Directions::both;
    bool backward_from_rest = false; ///< else from the end of the forward sweep
    SettlingRule settling;
    long recorded = 0;         ///< [periods]
    std::string excitation;    ///< empty: the only one
    double jump_tolerance = 0; ///< width of a bracket over the largest swept value; 0: no search
    double jump_threshold = 0; ///< smallest relative difference of states that is a jump
    std::vector<RecorderFactory> recorders = default_recorders();
  };
  explicit SteppedSweep(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "stepped sweep"; }
  /// frequency or swept key, direction
  std::vector<Axis> axes() const override;
  std::size_t lines() const override;
  void check(const System &system) const override;
  std::vector<std::vector<parameters::Override>> variants() const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  struct Step;
  std::vector<Step> steps_of_line(std::size_t line) const;
  PointResult compute(const Step &step, SweptSystem &swept, const motion::MotionState &from,
                      SettledMotion &settled, LineContext &context) const;
  void note(long periods, LineContext &context) const;
  PointResult advance(const Step &step, SweptSystem &swept, motion::MotionState &from,
                      std::optional<BranchPoint> &before, LineContext &context) const;
  Jump search(const BranchPoint &before, const BranchPoint &after, SweptSystem &swept,
              LineContext &context) const;
  bool searches_jumps() const { return settings_.jump_tolerance > 0; }

  Settings settings_;
};

} // namespace vibroimpact::analyses
