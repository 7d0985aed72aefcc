// Periodic orbit: a motion that repeats itself, stable or not, with its multipliers, found by
// Newton's method on the stroboscopic map and recorded over one of its periods.
#pragma once

#include "analyses/analysis.h"
#include "analyses/derivatives/orbit_derivatives.h"
#include "analyses/recorders/recorders.h"
#include "analyses/results/field_writer.h"

namespace vibroimpact::analyses {

class PeriodicOrbit : public Analysis {
public:
  struct Settings {
    OrbitStart start;
    std::string excitation; ///< whose period is that of the forcing; empty: the only one
    std::vector<RecorderFactory> recorders = default_recorders();
    std::vector<OrbitKey> keys{}; ///< by which derivatives are wanted
  };
  explicit PeriodicOrbit(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "periodic orbit"; }
  std::vector<Axis> axes() const override { return {}; }
  void check(const System &system) const override;
  void check_built(const SystemSource &build) const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  void add_all_derivatives(PointResult &result, const RecordedOrbit &motion,
                           const LineContext &context) const;
  PointResult compute(const System &system, LineContext &context) const;

  Settings settings_;
};

} // namespace vibroimpact::analyses
