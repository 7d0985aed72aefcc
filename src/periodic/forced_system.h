// A model under forcing that repeats itself after one period T, and its motions.
#pragma once

#include "motion/path/trajectory.h"
#include "motion/variation/key_tangent.h"

#include <vector>

namespace vibroimpact::periodic {

class ForcedSystem {
public:
  /// Keeps references; of the model only the frequency of the source may change. `source`: whose
  /// period is that of the forcing. InputError for a rotor, whose speed is a second frequency, and
  /// for a source that does not repeat itself after that period.
  ForcedSystem(const model::Model &model, const contact::ContactSet &contacts,
               const motion::Settings &settings, std::size_t source);

  const model::Model &model() const { return model_; }
  const contact::ContactSet &contacts() const { return contacts_; }
  std::size_t source() const { return source_; }
  double period() const { return period_of(model_, source_); } ///< T [s]
  /// Advances one motion after the other.
  motion::Trajectory &trajectory() { return trajectory_; }
  const motion::Equations &equations() const { return trajectory_.equations(); }
  const motion::StateLayout &layout() const { return trajectory_.layout(); }

  static double period_of(const model::Model &model, std::size_t source) {
    return model.sources()[source].function->period();
  }

private:
  const model::Model &model_;
  const contact::ContactSet &contacts_;
  std::size_t source_;
  motion::Trajectory trajectory_;
};

/// The derivative of a forced system by one key.
struct ForcedKey {
  motion::KeyTangent tangent;
  double period = 0; ///< dT/dp [s per unit of the key]
};

/// From four systems at neighbouring values of the key (motion::KeyTangent), whose forcing is the
/// same source. NumericalError when they do not change smoothly.
ForcedKey forced_key(const std::string &name, const ForcedSystem &system,
                     std::vector<motion::KeyNeighbour> neighbours);

/// The first source that does not repeat itself after this period [s] from time zero on; nullptr:
/// all do.
const model::Source *source_without_period(const model::Model &model, double period);

/// s(t + T/2) = -s(t) for every source.
bool forcing_is_odd(const ForcedSystem &system);

} // namespace vibroimpact::periodic
