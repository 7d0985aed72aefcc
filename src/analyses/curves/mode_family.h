// The motions of one nonlinear mode: their maps, where they begin, and what is known of each.
#pragma once

#include "analyses/curves/mode_start.h"
#include "analyses/curves/self_excited_map.h"
#include "analyses/recorders/recorders.h"
#include "continuation/branch.h"
#include "periodic/energy_orbits.h"

#include <map>
#include <memory>
#include <vector>

namespace vibroimpact::analyses {

class ModeFamily {
public:
  /// InputError as linear_mode(), and for a rotor.
  ModeFamily(const System &system, const ModeStart &start, periodic::Losses losses,
             std::vector<RecorderFactory> recorders);

  /// The linear mode at the energy where it begins.
  const continuation::Point &start() const { return start_; }
  /// Half periods over which the maps of the mode go: one where its motions are symmetric.
  long halves() const { return halves_; }
  std::shared_ptr<periodic::EnergyOrbits> problem(long halves);
  /// Motions over so many half periods, apart from those of the continuation.
  periodic::EnergyOrbits &recorded(long halves);
  PointResult row(const continuation::BranchPoint &point, long halves);

private:
  const periodic::StroboscopicMap &map() { return maps_.at(Vector::Zero(1)); }
  Vector whole(const Vector &motion);
  Vector sizes(double energies);
  void find_period();
  bool is_symmetric();

  LinearMode mode_;
  std::shared_ptr<periodic::FreePeriod> period_;
  double growth_; ///< of motions, up to the last energy
  SelfExcitedMap maps_;
  std::vector<RecorderFactory> recorders_;
  periodic::EnergyOrbits::Rule rule_;
  std::shared_ptr<periodic::EnergyMemory> memory_; ///< that all share
  continuation::Point start_;
  long halves_ = 2;
  std::map<long, std::shared_ptr<periodic::EnergyOrbits>> recorded_; ///< by their half periods
};

} // namespace vibroimpact::analyses
