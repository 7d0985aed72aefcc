// What the integrators may know of a contact law.
//
// A law gives the normal force between two points from
//   gap       distance along the contact normal, > 0 open, penetration = max(0, -gap)      [m]
//   gap_rate  its time derivative; penetration_rate = -gap_rate                            [m/s]
//   internal  first-order states of the law itself (deformation of a stop, memory, ...)
// and the force is >= 0 where it pushes the two apart (laws without tension cut-off may pull).
//
// A law has discrete modes (open, in contact, inside but without force, ...). Within a mode it is
// smooth. A mode is left through a guard: an expression, affine in (gap, gap_rate, internal), that
// is positive while the mode holds and falls through zero when it ends. Because guards are affine,
// an integrator can isolate their zeros safely without knowing which law it serves.
//
// Along tangential directions the two sides may slide on each other. What a law sees there is the
// slip of side b on side a; the tangential force acts on the coordinates as the normal one does. A
// mode may hold the slip rate at zero (the sides stick), by whatever force that takes. Along two
// directions the limit of friction is a circle, and what is left of it, the margin, no affine form:
// a guard sees it by value, and linear phases as squares of affine forms.
//
// Rigid laws give no finite force. A guard may end its mode by an impact, in which the velocities
// jump; a mode may hold the gap, so that the force is whatever keeps the gap rate at zero.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vibroimpact::contact {

/// Directions in which two sides can slide on each other, at most.
constexpr std::size_t most_tangential = 2;

struct TangentialState {
  double slip = 0;      ///< displacement of side b relative to side a [m]
  double slip_rate = 0; ///< of the two surfaces: its time derivative and their own speed [m/s]
  double force = 0;     ///< in modes that hold the slip rate: the force that does it [N]
};

struct LocalState {
  double gap = 0;      ///< [m]
  double gap_rate = 0; ///< [m/s]
  std::span<const double> internal{};
  /// In modes that hold the gap: the force that does it; of laws with friction whose normal force
  /// is no affine form: that force [N].
  double normal_force = 0;
  double gap_acceleration = 0;  ///< in modes that see the rate of the normal force [m/s^2]
  double normal_force_rate = 0; ///< likewise [N/s]
  double margin = 0;            ///< in modes that see it: what is left until their limit
  double slow_slip = 0; ///< of laws along two directions: a slip that is about to stop [m/s]
  std::array<TangentialState, most_tangential> tangential{};
};

/// What an affine form has of one direction: position u + rate u' + force F.
struct DirectionForm {
  double position = 0;
  double rate = 0;
  double force = 0; ///< of modes that hold the rate of that direction

  bool zero() const { return position == 0 && rate == 0 && force == 0; }
};

/// constant + gap g + gap_rate g' + internal . z + normal_force F + normal_force_rate F' +
/// margin M + the same of tangential directions. F, F' and M are those of LocalState; F' is in the
/// form of an affine F what the time derivative of a row of the state is.
struct AffineForm {
  double constant = 0;
  double gap = 0;
  double gap_rate = 0;
  std::vector<double> internal{}; ///< empty: all zero
  double normal_force = 0;        ///< of modes that hold the gap or have no affine form of it
  double normal_force_rate = 0;   ///< of modes that see it
  double margin = 0;              ///< likewise
  std::array<DirectionForm, most_tangential> tangential{};

  double operator()(const LocalState &state) const;
  /// Of direction 0, the normal, or of the tangential directions 1, 2.
  DirectionForm along(int direction) const {
    return direction == 0 ? DirectionForm{.position = gap, .rate = gap_rate, .force = normal_force}
                          : tangential[static_cast<std::size_t>(direction - 1)];
  }
  /// Of the position, the rate or the held force along a direction alone.
  static AffineForm position_along(int direction);
  static AffineForm rate_along(int direction);
  static AffineForm force_along(int direction);
  bool zero() const;
  /// Does it have a force that is no affine form?
  bool sees_forces() const;
  /// Has it the normal force by value, or its rate?
  bool sees_normal_force() const { return normal_force != 0 || normal_force_rate != 0; }
  AffineForm &operator+=(const AffineForm &other);
  AffineForm &operator*=(double factor);
};
AffineForm operator*(double factor, AffineForm form);
AffineForm operator+(AffineForm form, const AffineForm &other);

/// radius^2 - |across|^2, positive within a circle: a margin, and its partial derivatives at a
/// state as the coefficients of a form.
struct LimitCircle {
  AffineForm radius{};
  std::array<AffineForm, most_tangential> across{};

  double operator()(const LocalState &state) const;
  AffineForm gradient(const LocalState &state) const;
};

enum class GuardAction {
  change_mode, ///< the target is entered, positions and velocities stay
  impact,      ///< the gap rate jumps; the target is entered only if the two sides stay together
};

struct Guard {
  AffineForm indicator; ///< > 0 while the mode holds
  int target = 0;       ///< mode entered when it falls through zero
  /// New internal states at that instant, as affine forms of the local state; empty: unchanged.
  std::vector<AffineForm> reset{};
  GuardAction action = GuardAction::change_mode;
  /// The friction begins: ContactLaw::mode_by_slip says which mode takes the place of the target.
  bool by_slip = false;
};

/// Force and internal rates as affine forms, for modes in which the law is linear.
struct AffineLaw {
  AffineForm force;
  std::vector<AffineForm> internal_rate{};
  std::array<AffineForm, most_tangential> tangential_force{};
  AffineForm sliding_speed{}; ///< LawResponse::sliding_speed
};

/// What the two sides do along the tangential directions.
enum class Friction {
  none, ///< no friction acts
  stick,
  slip,
};

struct Mode {
  std::string name;
  bool in_contact = false;            ///< counts as an impact between entering and leaving
  std::vector<Guard> guards{};        ///< in order of priority
  std::optional<AffineLaw> affine{};  ///< present where the law is affine in this mode
  bool holds_gap = false;             ///< the gap rate stays zero, by a force the law does not know
  bool holds_slip = false;            ///< the slip rates stay zero, likewise
  bool sees_force_rate = false;       ///< rates or guards depend on the rate of the normal force
  bool sees_margin = false;           ///< a guard does
  std::optional<LimitCircle> limit{}; ///< the margin of modes that are affine
  Friction friction = Friction::none;

  bool holds() const { return holds_gap || holds_slip; }
  /// Of direction 0, the normal, or of a tangential one.
  bool holds(int direction) const { return direction == 0 ? holds_gap : holds_slip; }
};

/// Along one tangential direction.
struct TangentialResponse {
  double force = 0; ///< [N]; 0 in modes that hold the slip rate
  AffineForm by{};  ///< its partial derivatives, as the coefficients of a form
  /// Of the internal rates by the slip rate, n_internal() entries; empty: all zero.
  std::vector<double> internal_rate_by_slip_rate{};
};

/// Values and partial derivatives of a law at one local state; arrays have n_internal() entries.
struct LawResponse {
  double force = 0;             ///< [N]
  double force_by_gap = 0;      ///< [N/m]
  double force_by_gap_rate = 0; ///< [N s/m]
  double stored_energy = 0;     ///< [J]; what a change of mode takes away counts as dissipated
  double dissipated_power = 0;  ///< [W]
  std::vector<double> force_by_internal{};
  std::vector<double> internal_rate{};
  std::vector<double> internal_rate_by_gap{};
  std::vector<double> internal_rate_by_gap_rate{};
  std::vector<double> internal_rate_by_internal{}; ///< row-major n x n
  // Of laws with friction:
  std::vector<double> internal_rate_by_gap_acceleration{}; ///< empty: all zero
  std::array<TangentialResponse, most_tangential> tangential{};
  double friction_power = 0; ///< the part of dissipated_power that friction takes [W]
  double sliding_speed = 0;  ///< of the surfaces on each other, >= 0, no elastic part in it [m/s]
  double margin = 0;         ///< of modes without a limit circle
  AffineForm margin_by{};    ///< its partial derivatives, those by N and its rate among them
};

/// What an internal state is, for the results.
struct InternalState {
  std::string name; ///< "stop_deformation"
  std::string unit; ///< SI
  std::string description;
};

/// The constants of a force that grows with a power of the penetration:
/// F = k u^n (1 + d u'), d = 0 where nothing is dissipated.
struct PowerLaw {
  double stiffness = 0;                  ///< k > 0 [N/m^n]
  double exponent = 1.5;                 ///< n
  std::optional<double> dissipation = 0; ///< d >= 0 [s/m]; none when it differs between impacts
};

/// The part of a force that is left without damping and history: F = k u^n.
struct ElasticForce {
  double stiffness = 0; ///< k > 0 [N/m^n]
  double exponent = 1;  ///< n > 0
};

/// How a force grows from nothing, or falls to it, with the time s since then or until then:
/// s^power times a series in s^(1/root), where the penetration is smooth but for what the force
/// itself does.
struct ForceEdge {
  double power = 0; ///< > -1
  int root = 1;     ///< >= 1
};

/// The force of a mode in contact: from a touch on, and to the guards of the mode at which it ends
/// without a jump.
struct ForcePulse {
  struct End {
    std::size_t guard = 0; ///< of the mode
    ForceEdge edge{};
  };
  ForceEdge begin{};
  std::vector<End> ends{};
};

/// What the restitution coefficient of an impact with friction is the ratio of: the work that the
/// normal force gives back and takes (Stronge), its square root; speeds (Newton); impulses
/// (Poisson).
enum class RestitutionHypothesis { energetic, newton, poisson };

class ContactLaw {
public:
  virtual ~ContactLaw() = default;

  virtual std::string name() const = 0;
  const std::vector<Mode> &modes() const { return modes_; }
  int n_internal() const { return static_cast<int>(initial_internal_.size()); }
  /// Internal states before the first contact.
  const std::vector<double> &initial_internal() const { return initial_internal_; }
  /// n_internal() names; those that a law does not tell are internal_0, internal_1, ...
  virtual std::vector<InternalState> internal_states() const;

  /// The mode in which a motion starts. A guard that is zero there and falling ends it at once.
  virtual int initial_mode(const LocalState &state) const = 0;

  /// Force, internal rates, derivatives and energies. `response` keeps its storage between calls.
  virtual void evaluate(int mode, const LocalState &state, LawResponse &response) const = 0;

  /// Tangential directions that the law sees.
  virtual int n_tangential() const { return 0; }
  /// The mode in place of `mode` by what the sides slide at: where friction begins, and where an
  /// impact has changed the velocities.
  virtual int mode_by_slip(int mode, const LocalState & /*state*/) const { return mode; }

  /// Why the law does not hold where a motion has come to, "pulls at a penetration of 2e-05 m";
  /// empty: it does. Asked of modes that are no affine forms, where trial states of a step are
  /// behind.
  virtual std::string objection(int /*mode*/, const LocalState & /*state*/) const { return {}; }

  /// Internal states where a mode is left, before the guard's resets: what they have drifted off a
  /// limit that the mode keeps is taken off. Most laws have none.
  virtual void leave(int /*mode*/, const LocalState & /*state*/,
                     std::span<double> /*internal*/) const {}

  /// Separation speed over approach speed of an impact; for laws whose guards have that action.
  virtual double restitution(double /*approach_speed*/) const { return 0; }
  virtual RestitutionHypothesis hypothesis() const { return RestitutionHypothesis::energetic; }
  /// Tangential over normal impulse while rigid sides slide on each other, and force over force at
  /// which they begin to; 0: no friction acts.
  virtual double impact_friction() const { return 0; }
  virtual double static_friction() const { return 0; }

  /// True when some guard is an impact: the sides cannot overlap.
  bool rigid() const;
  /// True when the sides never part: there is no gap that could close.
  bool always_in_contact() const;

  /// For laws of that form; nothing for all others.
  virtual std::optional<PowerLaw> power_law() const { return std::nullopt; }

  /// Does the force pull where its formula says so?
  virtual bool may_pull() const { return false; }

  /// The elastic part of the force; nothing for rigid laws and where it is no power of the
  /// penetration. It says how the peak force of an impact grows with the mass: like m^(n/(n+1)).
  virtual std::optional<ElasticForce> elastic_force() const;

  /// Of modes whose force is no affine form and that are entered at a touch; nothing for all
  /// others, and where internal states change within the mode.
  virtual std::optional<ForcePulse> force_pulse(int /*mode*/) const { return std::nullopt; }

protected:
  ContactLaw(std::vector<Mode> modes, std::vector<double> initial_internal);

private:
  std::vector<Mode> modes_;
  std::vector<double> initial_internal_;
};

/// A mode with the internal states that belong to it.
struct SettledMode {
  int mode = 0;
  std::vector<double> internal;
};

/// Where the law comes to rest when a local state is held: from its initial mode through every
/// guard that has fallen below zero there.
SettledMode settle(const ContactLaw &law, LocalState state);

/// The two modes most laws have: 0 = open, left when the gap closes; 1 = contact, left when the
/// penetration returns to zero. `affine_contact` as in Mode::affine.
std::vector<Mode> open_and_contact(std::optional<AffineLaw> affine_contact = std::nullopt);

/// The three modes of laws whose force would turn into tension before the overlap ends: 0 = open,
/// 1 = contact, 2 = separating, inside but without force. `push` has the sign of the force that the
/// formula gives; where it falls to zero contact becomes separating, where it rises through zero
/// inside the force comes on again. `no_force` as in Mode::affine for the modes without force.
std::vector<Mode> open_contact_separating(const AffineForm &push,
                                          std::optional<AffineLaw> affine_contact = std::nullopt,
                                          const AffineLaw &no_force = {});

/// initial_mode for both: open at touch, so that a contact that begins there is an event.
int open_or_contact(const LocalState &state);

} // namespace vibroimpact::contact
