// The stroboscopic map of a system at any values of some keys, for continuation.
#pragma once

#include "analyses/keys/keyed_system.h"
#include "periodic/orbit_problem.h"

#include <map>
#include <memory>
#include <optional>

namespace vibroimpact::analyses {

class KeyedMap : public periodic::MapAlongKeys {
public:
  /// Keys, system and context as for KeyedSystem; `period`: where it is free, null otherwise. Maps
  /// measure states by `accuracy`; `size` as for Symmetry::find(), which must hold at all ends of
  /// the keys. InputError.
  KeyedMap(std::vector<SweptParameter> keys, const std::string &excitation, System &system,
           const LineContext &context, motion::VariationAccuracy accuracy, double size,
           std::shared_ptr<periodic::FreePeriod> period = {});

  const periodic::StroboscopicMap &at(const Vector &point) override;
  const periodic::StroboscopicMap &overlooking(const Vector &values,
                                               const periodic::Overlooked &overlooked) override;
  periodic::FreePeriod *free_period() override { return free_.get(); }
  /// Of the last at().
  const System &system() const { return *keyed_.system(); }
  motion::Trajectory &trajectory() { return maps_.forced->trajectory(); }
  bool symmetric() const { return symmetry_.has_value(); }

private:
  /// A forced system with its map, and its keys at one place.
  struct Maps {
    std::shared_ptr<const contact::ContactSet> contacts; ///< none: those of the system
    std::unique_ptr<periodic::ForcedSystem> forced;
    std::unique_ptr<periodic::StroboscopicMap> map;
    std::vector<std::unique_ptr<periodic::ForcedKey>> keys;
  };
  /// Neighbours along each key.
  using Neighbours = std::vector<std::vector<motion::KeyNeighbour>>;

  Vector within_ends(Vector values) const;
  void move_to(const Vector &values);
  void find_symmetry(double size);
  void make_forced(Maps &maps) const;
  void finish(Maps &maps, Neighbours neighbours) const;
  Neighbours neighbours(const Vector &values) const;

  KeyedSystem keyed_;
  std::shared_ptr<periodic::FreePeriod> free_;
  motion::VariationAccuracy accuracy_;
  std::optional<periodic::Symmetry> symmetry_;
  Maps maps_;
  std::map<periodic::Overlooked, Maps> overlooking_;
  std::optional<Vector> values_; ///< at which the maps have their keys
};

} // namespace vibroimpact::analyses
