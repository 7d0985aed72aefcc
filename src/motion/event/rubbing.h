// Contacts that touch at one instant, some of which have friction: their rates, impulses and forces
// along the normal and the tangential direction, one after the other for each contact. Rows of
// tangential directions that a contact does not have are zero.
#pragma once

#include "contact/frictional_impulses.h"
#include "motion/interval/observer.h"
#include "motion/system/equations.h"

#include <vector>

namespace vibroimpact::motion {

/// One that rests along its normal.
struct RestingContact {
  Index place = 0; ///< among those that touch
  int mode = 0;    ///< in which it sticks
  double slow = 0; ///< slip rates below count as none [m/s]
  int slides = 0;  ///< the sign of its slip where that is known without a slip rate
};

class Rubbing {
public:
  /// Of these contacts at a state; keeps a reference to the equations.
  Rubbing(const Equations &equations, const std::vector<std::size_t> &contacts, double time,
          const Vector &state);

  /// Has one of the contacts friction that acts on rigid sides?
  static bool holds(const Equations &equations, const std::vector<std::size_t> &contacts);

  /// Impulses of those that take part; `restitution`: of all, 0 where nothing approaches.
  void find(const std::vector<Index> &taking_part, const Vector &restitution);
  /// Velocities and work integrals.
  void apply(Vector &state) const;

  /// Of the contacts, along their normals.
  Vector normal_impulses() const { return of_normals(impulses_); }
  Vector normal_rates_after() const { return of_normals(after_); }
  long reduced() const { return reduced_; }

  /// What the contacts of the list do that rest along their normals, from their accelerations
  /// without forces between them: the mode of each, or -1 where it opens.
  std::vector<int> modes_at_rest(const std::vector<RestingContact> &list,
                                 const Vector &accelerations, const Vector &state) const;

  /// The impulses by the rates before them, for the contacts of the list.
  void record(const std::vector<Index> &list, Collision &record) const;

  bool has_friction(Index k) const {
    return friction_[static_cast<std::size_t>(k)].coefficient > 0;
  }

private:
  const contact::ContactPair &pair(Index k) const {
    return equations_.contacts().pairs()[contacts_[static_cast<std::size_t>(k)]];
  }
  static Vector of_normals(const Vector &all);
  Vector rates(const Vector &state) const;

  const Equations &equations_;
  std::vector<std::size_t> contacts_;
  std::vector<contact::ContactFriction> friction_;
  Matrix rows_, response_, effect_; ///< W, M^-1 W^T, W M^-1 W^T
  Vector before_, carried_;         ///< rates; the part of them that bases and surfaces make
  Vector impulses_, after_, friction_work_, rubbing_;
  Matrix by_rates_;
  long reduced_ = 0;
};

} // namespace vibroimpact::motion
