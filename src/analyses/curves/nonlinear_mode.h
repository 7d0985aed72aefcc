// Nonlinear mode: periodic motions of a system without excitation, followed by their energy from a
// linear mode on, without damping or with damping that a self-excitation balances (phase
// resonance).
#pragma once

#include "analyses/analysis.h"
#include "analyses/curves/mode_start.h"
#include "analyses/recorders/recorders.h"
#include "continuation/settings.h"
#include "periodic/energy_orbits.h"

namespace vibroimpact::analyses {

class NonlinearMode : public Analysis {
public:
  struct Settings {
    ModeStart start;
    periodic::Losses losses = periodic::Losses::none;
    continuation::Settings continuation{};
    long levels = 0; ///< of branches that begin at special points of others
    std::vector<RecorderFactory> recorders = default_recorders();
  };
  explicit NonlinearMode(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "nonlinear mode"; }
  std::vector<Axis> axes() const override { return {}; }
  void check(const System &system) const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  PointResult compute(const System &system, LineContext &context) const;

  Settings settings_;
};

} // namespace vibroimpact::analyses
