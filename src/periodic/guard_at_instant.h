// A guard at one instant of a motion in the mode that it ends, and what it changes by.
#pragma once

#include "periodic/open_contact.h"
#include "periodic/stroboscopic_map.h"

namespace vibroimpact::periodic {

class GuardAtInstant {
public:
  /// `map`: whose keys and laws count. `kept`: the same map whose contact stays in the guard's
  /// mode. `of`: the guard as overlooked there, or of a contact that never closes. Keeps references
  /// to all but `of`; the equations of `kept` are left in the modes of the motion.
  GuardAtInstant(const StroboscopicMap &map, const StroboscopicMap &kept, const Overlooked &of,
                 double phase, const Vector &state);

  const contact::ContactPair &pair() const { return map_.system().contacts().pairs()[contact_]; }
  std::size_t contact() const { return contact_; }
  std::size_t mode() const { return mode_; }
  const contact::Guard &guard() const { return pick(*pair().law); }
  const contact::AffineForm &form() const { return guard().indicator; }
  const contact::LocalState &local() const { return local_; }
  const motion::Equations &equations() const { return kept_.system().equations(); }
  double time() const { return phase_ * kept_.period(); }
  ConstVectorView state() const { return {state_.data(), state_.size()}; }

  double value() const { return form()(local_); }
  /// By the physical state.
  RowVector gradient() const;
  /// Its total derivative by time where the state has these rates.
  double rate(const Vector &rates) const;
  /// Its derivatives by the keys at a fixed time, where the state has these, n x keys.
  RowVector by_keys(const Matrix &state_by_keys) const;

private:
  const contact::Guard &pick(const contact::ContactLaw &law) const {
    return law.modes()[mode_].guards[guard_];
  }

  const StroboscopicMap &map_, &kept_;
  std::size_t contact_, mode_, guard_;
  double phase_;
  const Vector &state_;
  contact::LocalState local_;
};

} // namespace vibroimpact::periodic
