// The stroboscopic map of a system at any value of a key, for continuation.
#pragma once

#include "analyses/analysis.h"
#include "analyses/swept_parameter.h"
#include "periodic/orbit_problem.h"

#include <map>
#include <memory>
#include <optional>

namespace vibroimpact::analyses {

class KeyedMap : public periodic::MapAlongKey {
public:
  /// Keeps references. A frequency is set in `system` itself; for another key the systems are built
  /// by `context`. Maps measure states by `accuracy`; `size` as for Symmetry::find(), which must
  /// hold at both ends of the key. InputError.
  KeyedMap(const SweptParameter &parameter, const std::string &excitation, System &system,
           const LineContext &context, motion::VariationAccuracy accuracy, double size);

  const periodic::StroboscopicMap &at(double value) override;
  const periodic::StroboscopicMap &with_open(double value, std::size_t contact) override;
  /// Of the last at().
  const System &system() const { return *present_; }
  motion::Trajectory &trajectory() { return maps_.forced->trajectory(); }
  bool symmetric() const { return symmetry_.has_value(); }

private:
  /// A forced system with its map, and its key at one value.
  struct Maps {
    std::unique_ptr<contact::ContactSet> contacts; ///< none: those of the system
    std::unique_ptr<periodic::ForcedSystem> forced;
    std::unique_ptr<periodic::StroboscopicMap> map;
    std::unique_ptr<periodic::ForcedKey> key;
  };
  void move_to(double value);
  void build(double value);
  void find_symmetry(double size);
  void make_forced(Maps &maps) const;
  void finish(Maps &maps, std::vector<motion::KeyNeighbour> neighbours) const;
  std::vector<motion::KeyNeighbour> neighbours(double value) const;

  const SweptParameter &parameter_;
  std::string excitation_;
  System &original_;
  const LineContext &context_;
  motion::VariationAccuracy accuracy_;
  std::optional<periodic::Symmetry> symmetry_;
  std::unique_ptr<System> built_;
  const System *present_;
  Maps maps_;
  std::map<std::size_t, Maps> open_; ///< by the contact that stays open
  std::optional<double> value_;      ///< at which the maps have their key
};

} // namespace vibroimpact::analyses
