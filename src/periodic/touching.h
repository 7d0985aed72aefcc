// What a contact does where a guard just touches zero.
#pragma once

#include "continuation/problem.h"
#include "periodic/graze_extension.h"
#include "periodic/guard_at_instant.h"

namespace vibroimpact::periodic {

class Touching {
public:
  /// At the least value of the guard of the window, or where its slip ends.
  explicit Touching(const GuardAtInstant &at);

  continuation::Touch touch() const { return touch_; }
  GrazeKind kind() const { return kind_; }
  /// Derivative, by the least value, of the state behind the touch where it is a corner, or where
  /// sides stick on; otherwise empty.
  Vector jump() const;

  /// At the limit of stick, which the guard is, the force that holds the sides is that of the slip
  /// behind it; `held`: the local state in stick, at the limit or not.
  static bool slips_without_jump(const contact::ContactLaw &law, const contact::Guard &limit,
                                 contact::LocalState held);

private:
  void touch_of_contact();
  void touch_of_slip();
  double dashpot() const;
  bool lets_go() const;
  bool sticks_on() const;
  Vector impulse() const;
  Vector stop() const;

  const GuardAtInstant &at_;
  const contact::ContactLaw &law_;
  const contact::Mode &from_, &to_;
  continuation::Touch touch_ = continuation::Touch::smooth;
  GrazeKind kind_ = GrazeKind::contact;
};

} // namespace vibroimpact::periodic
