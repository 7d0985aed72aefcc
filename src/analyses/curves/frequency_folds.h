// Where the frequency of motions without excitation turns along their branch, which is no fold of
// the key, the energy: between three neighbouring points of which the middle one has the largest or
// the smallest frequency, the zero of its derivative along the branch.
#pragma once

#include "continuation/branch.h"
#include "periodic/energy_orbits.h"

#include <deque>
#include <optional>

namespace vibroimpact::analyses {

class FrequencyFolds {
public:
  explicit FrequencyFolds(const continuation::Settings &settings) : settings_(settings) {}

  /// Another branch, or part of one, begins.
  void begin() { last_.clear(); }
  /// The next point; what lies about the one before it, none where motions of other contact changes
  /// or charts are beside it, or it cannot be located.
  std::optional<continuation::BranchPoint> next(periodic::EnergyOrbits &motions,
                                                const continuation::BranchPoint &point);

private:
  struct Seen {
    continuation::BranchPoint at;
    double frequency = 0;
  };
  bool turns() const;
  continuation::BranchPoint located(periodic::EnergyOrbits &motions) const;

  continuation::Settings settings_;
  std::deque<Seen> last_; ///< three of them
};

} // namespace vibroimpact::analyses
