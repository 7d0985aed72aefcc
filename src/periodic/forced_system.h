// A model under forcing that repeats itself after one period T, or under none, and its motions.
#pragma once

#include "motion/path/trajectory.h"
#include "motion/variation/key_tangent.h"
#include "periodic/free_period.h"

#include <memory>
#include <optional>
#include <vector>

namespace vibroimpact::periodic {

class ForcedSystem {
public:
  /// Keeps references; of the model only the frequency of the source may change. `source`: whose
  /// period is that of the forcing. InputError for a rotor, whose speed is a second frequency, and
  /// for a source that does not repeat itself after that period.
  ForcedSystem(const model::Model &model, const contact::ContactSet &contacts,
               const motion::Settings &settings, std::size_t source);

  /// Where no excitation changes with time: the period is to be found, and this is what is known of
  /// it. InputError for a rotor.
  ForcedSystem(const model::Model &model, const contact::ContactSet &contacts,
               const motion::Settings &settings, std::shared_ptr<FreePeriod> period);

  const model::Model &model() const { return model_; }
  const contact::ContactSet &contacts() const { return contacts_; }
  /// None where the period is free.
  std::optional<std::size_t> source() const { return source_; }
  /// Null where the forcing has the period.
  const std::shared_ptr<FreePeriod> &free_period() const { return free_; }
  /// T [s]
  double period() const { return source_ ? period_of(model_, *source_) : free_->period(); }
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
  std::optional<std::size_t> source_;
  std::shared_ptr<FreePeriod> free_;
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

/// Does no excitation of the model change with time?
bool is_autonomous(const model::Model &model);

/// s(t + T/2) = -s(t) for every source.
bool forcing_is_odd(const ForcedSystem &system);

} // namespace vibroimpact::periodic
