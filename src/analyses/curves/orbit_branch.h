// Branch: periodic motions, stable and unstable, followed along a key by pseudo-arclength
// continuation, with the points at which they turn, double their period, lose their symmetry, or
// their contacts graze.
//
// How many points there are is known only in the end, so that a branch is one result whose arrays
// run along `branch_point`; the special points have arrays of their own along `special_point`.
#pragma once

#include "analyses/analysis.h"
#include "analyses/curves/orbit_start.h"
#include "analyses/keys/branch_keys.h"
#include "analyses/keys/swept_parameter.h"
#include "analyses/recorders/recorders.h"
#include "continuation/branch.h"

namespace vibroimpact::analyses {

class OrbitBranch : public Analysis {
public:
  struct Settings {
    SweptParameter parameter; ///< with the two ends as values
    double start_value = 0;   ///< of the key, unless it is a frequency [its unit]
    OrbitStart start;
    Directions directions = Directions::both;
    continuation::Settings continuation{};
    long levels = 0;        ///< of branches that begin at special points of others
    std::string excitation; ///< whose period is that of the forcing; empty: the only one
    std::vector<RecorderFactory> recorders = default_recorders();
  };
  explicit OrbitBranch(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "branch"; }
  std::vector<Axis> axes() const override { return {}; }
  void check(const System &system) const override;
  std::vector<std::vector<parameters::Override>> variants() const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  PointResult compute(System &system, LineContext &context) const;

  Settings settings_;
};

} // namespace vibroimpact::analyses
