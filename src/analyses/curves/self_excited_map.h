// The map of a system that no excitation times, at any self-excitation: the equations get a force
// xi M q' with a rate xi [1/s], the one key of this map.
#pragma once

#include "analyses/run/system.h"
#include "periodic/orbit_problem.h"

#include <map>
#include <memory>
#include <optional>

namespace vibroimpact::analyses {

/// Of how the damping that the file gives is dealt with.
enum class FileDamping {
  left_out, ///< and nothing is excited: the map has no key
  kept
};

class SelfExcitedMap : public periodic::MapAlongKeys {
public:
  /// Starts with no excitation. `largest`: a state as large as motions become.
  SelfExcitedMap(const System &system, FileDamping damping,
                 std::shared_ptr<periodic::FreePeriod> period, const Vector &largest);

  /// NumericalError for a map without a key elsewhere than at zero.
  const periodic::StroboscopicMap &at(const Vector &keys) override;
  const periodic::StroboscopicMap &overlooking(const Vector &keys,
                                               const periodic::Overlooked &overlooked) override;
  /// Of the last at().
  const System &system() const { return *present_; }
  periodic::ForcedSystem &forced() { return *maps_.forced; }
  bool symmetric() const { return symmetry_.has_value(); }

private:
  struct Maps {
    std::shared_ptr<const contact::ContactSet> contacts;
    std::unique_ptr<periodic::ForcedSystem> forced;
    std::unique_ptr<periodic::StroboscopicMap> map;
    std::unique_ptr<periodic::ForcedKey> key;
  };
  std::shared_ptr<const System> excited(double rate) const;
  Maps maps_with(std::shared_ptr<const contact::ContactSet> contacts) const;

  System given_;
  FileDamping damping_;
  std::shared_ptr<periodic::FreePeriod> period_;
  motion::VariationAccuracy accuracy_;
  std::optional<periodic::Symmetry> symmetry_;
  double natural_; ///< of about the motion [rad/s]
  double rate_ = 0;
  std::shared_ptr<const System> present_;
  Maps maps_;
  std::map<periodic::Overlooked, Maps> overlooking_;
};

} // namespace vibroimpact::analyses
