// How large the gaps of a motion, their rates and forces have been: what errors are measured
// against where a contact touches, rests or begins its mode at a zero.
//
// A length in metres fits one size of model only. Two things make an error here:
//   rounding          64 eps times the sum of the sizes of all terms that a contact's gap is made
//   of,
//                     the largest since the motion began: amplitudes that cancel now leave their
//                     rounding behind. A coordinate that oscillates counts with its amplitude,
//                     |q| + |v| / w, w^2 = k / m.
//   the integration   1e-11 times the largest such sum of all contacts, or what the forces on them
//                     could make of one at the highest frequency w, a / w^2 with the acceleration
//                     a: what is held between two stops has never moved
// and the absolute tolerance, where one is set. Lengths, times and masses can be scaled by any
// factor and the same decisions follow.
#pragma once

#include "motion/settings.h"
#include "motion/system/equations.h"

#include <vector>

namespace vibroimpact::motion {

class ContactScales {
public:
  /// Keeps a reference to the equations.
  ContactScales(const Equations &equations, const Settings &settings);

  /// A motion begins there.
  void begin(double time, const Vector &state);
  /// The motion has come to `time`. `with_forces`: those count too, which takes longer.
  void note(double time, const Vector &state, bool with_forces = false);

  /// Error of a contact's gap, and of its slips [m].
  double length(std::size_t contact) const;
  /// The part of it that is rounding [m].
  double rounding(std::size_t contact) const;
  /// Error of their rates [m/s].
  double speed(std::size_t contact) const;
  /// Error of an affine form of its local state.
  double error(std::size_t contact, const contact::AffineForm &form) const;
  /// Error of its gap and gap rate within a step that ends there: 1e-11 times what they are made
  /// of.
  double error_of_step(std::size_t contact, const contact::AffineForm &form, double end,
                       const Vector &state) const;

private:
  struct Sizes {
    double gap = 0, gap_rate = 0;
    void include(const Sizes &other);
  };
  Sizes terms(std::size_t contact, double time, const Vector &state, double elapsed) const;
  Sizes terms(const contact::Direction &along, double time, const Vector &state,
              double elapsed) const;
  void include_forces(std::size_t contact, double time, const Vector &state);
  void include_slopes(std::size_t contact, double time, const Vector &state);
  void include_margin(std::size_t contact, double time, const Vector &state);
  double mass_along(std::size_t contact, int direction) const;
  double of_normal_force(std::size_t contact, const contact::AffineForm &form, double length,
                         double speed, double acceleration) const;

  const Equations &equations_;
  double highest_;                   ///< frequency [rad/s]
  double absolute_, absolute_speed_; ///< [m], [m/s]
  Vector turning_time_;   ///< 1 / w of each coordinate [s]; infinite: it does not oscillate
  double time_ = 0;       ///< the motion was looked at last [s]
  std::vector<Sizes> of_; ///< each contact
  Sizes largest_;         ///< of all
  /// Largest derivatives of the normal force by gap and gap rate, where friction sees it by value.
  std::vector<Sizes> slopes_;
  /// Largest errors of the margins, of each contact and each of its modes.
  std::vector<std::vector<double>> margins_;
  double acceleration_ = 0; ///< of a gap, each of its terms alone [m/s^2]
};

} // namespace vibroimpact::motion
