// Stepped sine sweep: at each excitation frequency the motion settles, is judged steady, and is
// then watched for some periods; the state at the end starts the next frequency.
//
// Steady means: the state seen once per period (stroboscopically) repeats after some k <= longest
// multiple of periods, and the distance still to go, estimated from the last two changes as a
// geometric series, is below the tolerance times the size of the motion.
#pragma once

#include "analyses/analysis.h"
#include "analyses/recorders.h"
#include "integration/trajectory.h"

namespace vibroimpact {

class SteppedSweep : public Analysis {
public:
  enum class Directions { forward, backward, both };

  struct Settings {
    std::vector<double> frequencies; ///< increasing, in the unit of the axis [Hz]
    Directions directions = Directions::both;
    bool backward_from_rest = false; ///< else from the end of the forward sweep
    long minimum_settling = 0;       ///< [periods]
    long maximum_settling = 0;       ///< [periods]
    long recorded = 0;               ///< [periods]
    double steadiness = 0;           ///< relative tolerance
    long longest_multiple = 1;       ///< [periods]
    std::string excitation;          ///< empty: the only one
    std::vector<RecorderFactory> recorders = default_recorders();
  };
  explicit SteppedSweep(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "stepped sweep"; }
  /// frequency, direction
  std::vector<Axis> axes() const override;
  std::size_t lines() const override;
  Workload workload(const System &system) const override;
  void check(const System &system) const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  struct Step;
  std::vector<Step> steps_of_line(std::size_t line) const;
  std::size_t swept_source(const System &system) const;
  PointResult compute(const Step &step, System &system, Trajectory &trajectory,
                      const MotionState &from) const;

  Settings settings_;
};

} // namespace vibroimpact
