// A law of friction along one tangential direction, written without knowing the normal law: that
// gives the normal force N as an affine form of the local state.
//
// The force F acts on side b along the direction, against the slip rate v of b on a. A law has
// discrete modes, as contact laws have; where N ends, so does F.
#pragma once

#include "contact/contact_law.h"

#include <string>
#include <vector>

namespace vibroimpact::contact {

struct TangentialMode {
  std::string name; ///< "stick"
  Friction friction = Friction::none;
  bool holds_slip = false;                 ///< the slip rate stays zero, by whatever force
  AffineForm force{};                      ///< [N]; zero where it is held
  std::vector<AffineForm> internal_rate{}; ///< of the law's own internal states
  AffineForm sliding_speed{};              ///< of the surfaces on each other, >= 0 [m/s]
  std::vector<Guard> guards{};             ///< targets and resets: of the law's own
};

class TangentialLaw {
public:
  virtual ~TangentialLaw() = default;

  virtual std::string name() const = 0;
  /// The modes at this normal force, always the same ones in the same order; the first is where
  /// nothing slides. `first_internal`: place of the law's first internal state in forms.
  virtual std::vector<TangentialMode> modes(const AffineForm &normal_force,
                                            std::size_t first_internal) const = 0;
  /// The mode in place of `mode` after a jump of the slip rate to `slip_rate` [m/s], or where
  /// friction begins.
  virtual int mode_by_slip(int mode, double slip_rate) const = 0;

  /// Zero before friction begins.
  virtual std::vector<InternalState> internal_states() const { return {}; }
  /// k of the stored energy k z^2 / 2, z the only internal state [N/m]; 0: none is stored.
  virtual double stiffness() const { return 0; }
  /// c of what a dashpot beside that spring takes, c z'^2 [N s/m].
  virtual double damping_constant() const { return 0; }
  /// Does the law ask for the rate of the normal force?
  virtual bool follows_normal_rate() const { return false; }
};

/// The time derivative of a normal force that depends on the gap alone.
AffineForm rate_of_normal_force(const AffineForm &normal_force);

} // namespace vibroimpact::contact
