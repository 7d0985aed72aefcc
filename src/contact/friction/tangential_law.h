// A law of friction along one tangential direction, or two, written without knowing the normal law:
// that gives the normal force N as a form of the local state, which is affine in gap, gap rate and
// internal states where the normal law is, and N by value where it is not.
//
// The force F acts on side b along the directions, against the slip rate v of b on a. A law has
// discrete modes, as contact laws have; where N ends, so does F. In each the force and the rates of
// internal states are forms of the same kind, or are evaluated.
#pragma once

#include "contact/contact_law.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vibroimpact::contact {

struct TangentialMode {
  std::string name; ///< "stick"
  Friction friction = Friction::none;
  bool holds_slip = false;                         ///< the slip rate stays zero, by whatever force
  std::array<AffineForm, most_tangential> force{}; ///< [N]; zero where it is held
  std::vector<AffineForm> internal_rate{};         ///< of the law's own internal states
  AffineForm sliding_speed{};                      ///< of the surfaces on each other, >= 0 [m/s]
  std::vector<Guard> guards{};                     ///< targets and resets: of the law's own
  std::optional<LimitCircle> limit{}; ///< the margin that guards see, of modes with forms
  bool evaluated = false; ///< force, internal rates and sliding speed are no forms, but evaluate()d
  bool sees_force_rate = false; ///< of evaluated modes: by the rate of the normal force
};

/// A number that depends on the local state, and its partial derivatives as the coefficients of a
/// form: by the normal force, the slip, its rate and the law's internal states.
struct TangentialValue {
  double value = 0;
  AffineForm by{};
};

/// What a mode gives at a local state.
struct TangentialValues {
  std::array<TangentialValue, most_tangential> force{};
  std::vector<TangentialValue> internal_rate{};
  double sliding_speed = 0;
  TangentialValue margin{}; ///< that guards see
};

class TangentialLaw {
public:
  virtual ~TangentialLaw() = default;

  virtual std::string name() const = 0;
  /// Directions along which it acts.
  virtual int n_directions() const { return 1; }
  /// The modes at this normal force, always the same ones in the same order; the first is where
  /// nothing slides. `first_internal`: place of the law's first internal state in forms.
  virtual std::vector<TangentialMode> modes(const AffineForm &normal_force,
                                            std::size_t first_internal) const = 0;
  /// The mode in place of `mode` after a jump of the slip rates, or where friction begins.
  virtual int mode_by_slip(int mode, const LocalState &state, std::size_t first_internal) const = 0;
  /// ContactLaw::leave() of the law's own internal states.
  virtual void leave(int /*mode*/, double /*normal_force*/, std::span<double> /*internal*/) const {}

  /// Of modes that are evaluated; `state` has the normal force. `values` keeps its storage.
  virtual void evaluate(int mode, const LocalState &state, std::size_t first_internal,
                        TangentialValues &values) const;

  /// mu and mu_s of laws whose force is -sigma mu N in slip and whose sides stick up to mu_s N, and
  /// nothing else: those that rigid sides can have. None: it is another law.
  struct Coefficients {
    double sliding = 0, at_rest = 0;
  };
  virtual std::optional<Coefficients> coefficients() const { return std::nullopt; }

  /// Zero before friction begins.
  virtual std::vector<InternalState> internal_states() const { return {}; }
  /// k of the stored energy k z^2 / 2, z the only internal state [N/m]; 0: none is stored.
  virtual double stiffness() const { return 0; }
  /// c of what a dashpot beside that spring takes, c z'^2 [N s/m].
  virtual double damping_constant() const { return 0; }
};

/// The time derivative of a normal force.
AffineForm rate_of_normal_force(const AffineForm &normal_force);

} // namespace vibroimpact::contact
