// Steady state: one motion from the initial conditions that settles and is then recorded, by
// periods of an excitation or by time. Whether it became steady is a result; it need not.
#pragma once

#include "analyses/analysis.h"
#include "analyses/recorders/recorders.h"
#include "analyses/sweeps/settling.h"

namespace vibroimpact::analyses {

class SteadyState : public Analysis {
public:
  struct Settings {
    SettlingRule settling;    ///< when settling_time is 0
    double settling_time = 0; ///< [s]
    bool by_time = false;     ///< settles for settling_time
    long cycles = 0;          ///< recorded, when recorded_time is 0
    double recorded_time = 0; ///< [s]
    std::string excitation;   ///< whose period counts; empty: the only one that has one
    std::vector<RecorderFactory> recorders = default_recorders();

    bool needs_period() const { return !by_time || recorded_time == 0; }
  };
  explicit SteadyState(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "steady state"; }
  std::vector<Axis> axes() const override { return {}; }
  void check(const System &system) const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  double period(const System &system) const;
  SettledMotion settle_motion(const System &system, motion::Trajectory &trajectory, double period,
                              double share, LineContext &context) const;
  double settling_share(double period) const;
  Window window(double start, double period) const;
  PointResult compute(const System &system, LineContext &context) const;

  Settings settings_;
};

} // namespace vibroimpact::analyses
