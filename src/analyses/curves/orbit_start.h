// Where a periodic motion comes from: a motion that has settled, the initial conditions, or a state
// that the file gives; Newton's method goes on from there.
#pragma once

#include "analyses/analysis.h"
#include "analyses/sweeps/settling.h"
#include "common/bytes.h"
#include "common/error.h"
#include "periodic/orbit.h"

#include <functional>
#include <optional>

namespace vibroimpact::analyses {

struct OrbitStart {
  SettlingRule
      settling{}; ///< from the initial conditions; no periods: they are the start themselves
  std::vector<double> state{}; ///< at phase 0; empty: the settled one
  long multiple = 0;           ///< [periods]; 0: that of the settled motion
  /// About the period where no excitation gives one; 0: that of the lowest natural frequency [s]
  double period = 0;
  std::optional<parameters::Values> section{}; ///< for messages
};

void declare_orbit_start(parameters::Section &section);
OrbitStart read_orbit_start(const parameters::Values &section);

/// A system with its map, which knows whether it is symmetric, and how motions of it begin.
class OrbitSearch {
public:
  /// Keeps references. `source`: the excitation that gives the period, none where it is free.
  /// InputError when the system has no periodic motions, or a state of the start another number of
  /// entries.
  OrbitSearch(const System &system, std::optional<std::size_t> source, const OrbitStart &start);

  /// Settles, finds the symmetry, and shoots. `after_period` as for Settler. Where steps are kept,
  /// the orbit is one, without its image. NumericalError.
  periodic::Orbit run(const std::function<void(long periods)> &after_period = {},
                      StepRecord *steps = nullptr);

  periodic::ForcedSystem &forced() { return forced_; }
  /// Null where an excitation gives the period.
  const std::shared_ptr<periodic::FreePeriod> &free_period() const { return forced_.free_period(); }
  /// Made by run().
  periodic::StroboscopicMap &map() { return *map_; }
  long settling_cycles() const { return cycles_; }
  /// Periods after which the settled motion repeated itself; 0: it was not seen to; none: nothing
  /// was to settle, or that was left to an earlier run.
  std::optional<long> settled_multiple() const { return settled_multiple_; }

private:
  /// From which Newton's method starts.
  struct FirstState {
    Vector state;
    long multiple = 1;
    long cycles = 0;   ///< until it had settled
    double period = 0; ///< where it is free [s]

    friend void members(auto &visit, As<FirstState> auto &first) {
      visit(first.state, first.multiple, first.cycles, first.period);
    }
  };
  FirstState first_state(const std::function<void(long periods)> &after_period);
  FirstState settled_state(const std::function<void(long periods)> &after_period);

  const System &system_;
  const OrbitStart &start_;
  periodic::ForcedSystem forced_;
  Vector scale_;
  std::optional<periodic::StroboscopicMap> map_;
  long cycles_ = 0;
  std::optional<long> settled_multiple_;
};

/// What to say where motions cannot be found or followed and the model has a rigid-body motion;
/// empty where it has none.
std::string rigid_body_cause(const System &system);
/// Why no periodic motion was found, and the rigid-body motion as its cause where the model has
/// one.
NumericalError no_orbit(const System &system, const NumericalError &why);
/// run_single_point() for what looks for periodic motions: fails with no_orbit().
void run_orbit_point(const System &system, LineContext &context,
                     const std::function<PointResult()> &compute);

/// Factors that make states comparable, and how exactly tangents are carried along.
motion::VariationAccuracy orbit_accuracy(const System &system,
                                         const periodic::ForcedSystem &forced);

} // namespace vibroimpact::analyses
