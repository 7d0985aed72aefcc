// The equations of motion as a first-order system for one combination of contact modes.
//
// State x = [q (n), v (n), z (internal states of the contacts), torques of motors, integrals]. The
// last part holds time integrals that are carried along for the energy balance and the impulses;
// they do not act back.
#pragma once

#include "contact/contact_set.h"
#include "model/model.h"
#include "motion/interval/end_point.h"
#include "motion/system/active_constraints.h"
#include "motion/system/source_memory.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace vibroimpact::motion {

/// Where things stand in the state vector.
struct StateLayout {
  Index n = 0;          ///< coordinates
  Index n_internal = 0; ///< internal states of all contacts
  Index n_drive = 0;    ///< torques of motors
  Index n_contacts = 0;
  Index n_sliding = 0; ///< contacts with tangential directions

  Index velocity() const { return n; }
  Index internal() const { return 2 * n; }
  Index drive() const { return 2 * n + n_internal; }
  Index integrals() const { return drive() + n_drive; }
  Index input_work() const { return integrals(); }              ///< by loads and moving bases [J]
  Index absolute_input_work() const { return integrals() + 1; } ///< integral of |power| [J]
  Index damping_work() const { return integrals() + 2; }        ///< dissipated by C [J]
  Index impulse(Index contact) const { return integrals() + 3 + contact; }          ///< [N s]
  Index contact_work(Index contact) const { return impulse(contact) + n_contacts; } ///< dissipated
  /// Of the contact at this place among those with tangential directions: energy that friction has
  /// taken [J], integral of normal force times sliding speed [J], way of the surfaces on each other
  /// [m].
  Index friction_work(Index sliding) const { return integrals() + 3 + 2 * n_contacts + sliding; }
  Index wear_work(Index sliding) const { return friction_work(sliding) + n_sliding; }
  Index sliding_way(Index sliding) const { return wear_work(sliding) + n_sliding; }
  Index physical_size() const { return integrals(); }
  Index size() const { return integrals() + 3 + 2 * n_contacts + 3 * n_sliding; }
};

class Equations {
public:
  /// Keeps references: both must outlive it. The model's excitation may change between uses.
  Equations(const model::Model &model, const contact::ContactSet &contacts);

  const model::Model &model() const { return model_; }
  const contact::ContactSet &contacts() const { return contacts_; }
  const StateLayout &layout() const { return layout_; }

  /// Mode of each contact, used by all evaluations below.
  const std::vector<int> &modes() const { return modes_; }
  void set_mode(std::size_t contact, int mode);
  const contact::Mode &mode(std::size_t contact) const {
    return contacts_.pairs()[contact].law->modes()[static_cast<std::size_t>(modes_[contact])];
  }
  /// What is held in the present modes.
  const ActiveConstraints &holding() const { return constraints_; }
  /// Does friction see the normal force of the contact by value, or its rate?
  bool sees_normal_force(std::size_t contact) const;
  /// A slip rate of the contact below this is about to stop [m/s].
  void set_slow_slip(std::size_t contact, double rate) { slow_slip_[contact] = rate; }
  /// Partial derivatives of the margin that the present mode sees, as the coefficients of a form.
  contact::AffineForm margin_gradient(std::size_t contact, double time, ConstVectorView x) const;
  /// Does a present mode see the rate of its normal force?
  bool sees_force_rates() const { return !following_.empty(); }

  /// The phase ends at `instant`, a break of the sources (+infinity: none). There they have the
  /// values from the right; all evaluations below see those from the left.
  void set_source_break(double instant);
  double source_break() const { return source_break_; }
  /// Where to ask a source for its value at `time` in this phase.
  double source_time(double time) const { return std::min(time, last_source_time_); }

  /// s, s', s'' of all sources; no higher derivatives.
  void source_values(double time, std::vector<SourceValues> &values) const;

  /// Contacts with a force by their law in the present modes.
  std::size_t n_acting() const { return acting_.size(); }

  /// In its present mode the contact has neither force nor internal states.
  bool inactive(std::size_t contact) const;

  /// Gap, slips, their rates, and the forces that hold them or that the law sees by value; the
  /// internal states refer into `x`.
  contact::LocalState local_state(std::size_t contact, double time, ConstVectorView x) const;

  /// dx/dt
  void rates(double time, ConstVectorView x, VectorView dxdt) const;
  /// d(dx/dt)/dx, row by row: size x size.
  void jacobian(double time, ConstVectorView x, Matrix &jacobian) const;

  /// Second derivative of a contact's gap, or of the slip along a tangential direction, from given
  /// accelerations at a state.
  double gap_acceleration(std::size_t contact, double time, ConstVectorView x,
                          ConstVectorView acceleration, int direction = 0) const;
  /// The derivative of the local state by time, that of held forces and of the rate of the normal
  /// force left out; the internal rates refer into `rates`, dx/dt at x.
  contact::LocalState local_rates(std::size_t contact, double time, ConstVectorView x,
                                  ConstVectorView rates) const;

  /// Of a contact in a circular gap: u' in place of gap and slip, u'' in place of their rates, and
  /// the internal rates, which refer into `rates`.
  contact::LocalState relative_rates(std::size_t contact, double time, ConstVectorView x,
                                     ConstVectorView rates) const;

  /// Takes what is left of the slip rates that the present modes hold off the velocities.
  void stop_slip(double time, Vector &x) const;

  /// Bound of the rounding error of an acceleration.
  double acceleration_rounding(std::size_t contact, double time, const Vector &x,
                               int direction = 0) const;

  /// Where a contact in a circular gap stands.
  contact::CircularFrame frame(std::size_t contact, double time, ConstVectorView x) const;
  /// The gap (0) or a slip by the coordinates: what a force along that direction acts along.
  RowVector row_along(std::size_t contact, int direction, double time, ConstVectorView x) const;

  /// What a force along each row does: M^-1 rows^T at a position, n x rows.
  Matrix response_to(const Matrix &rows, double time, ConstVectorView x) const;

  /// Sum of the absolute values of the terms that an affine form of the local state is made of,
  /// down to single coordinates.
  double magnitude(std::size_t contact, const contact::AffineForm &form, double time,
                   const Vector &x) const;

  /// Bound of the rounding error with which such a form is evaluated: 64 eps times that sum.
  double rounding(std::size_t contact, const contact::AffineForm &form, double time,
                  const Vector &x) const;

  /// Kinetic + elastic energy of the bodies + stored energy of the contacts [J].
  double stored_energy(double time, ConstVectorView x) const;

  /// Normal force of a contact at a local state in a mode.
  double force(std::size_t contact, int mode, const contact::LocalState &state) const;
  /// Energy a contact has stored [J].
  double contact_energy(std::size_t contact, int mode, const contact::LocalState &state) const;

  static constexpr double rounding_factor = 64 * std::numeric_limits<double>::epsilon();

private:
  /// A contact that adds to the rates in the present modes.
  struct Acting {
    std::size_t contact = 0;
    const contact::ContactPair *pair = nullptr;
  };
  struct BaseCoefficient {
    std::size_t source = 0;
    double factor = 0; ///< not zero
  };
  /// A direction of a contact.
  struct Component {
    contact::Direction along;
    std::vector<BaseCoefficient> base_coefficients; ///< that move it
  };
  const Component &component(std::size_t contact, int direction) const {
    return components_[first_component_[contact] + static_cast<std::size_t>(direction)];
  }
  /// At the instant at which the phase has it.
  double source(std::size_t source, std::size_t derivative, double time) const {
    return sources_(source, derivative, source_time(time));
  }
  void load(double time) const;
  std::pair<double, double> motion_along(const Component &component, double time,
                                         ConstVectorView x) const;
  contact::LocalState local_motion(std::size_t contact, double time, ConstVectorView x) const;
  double base_rate(const Component &component, double time) const;
  double carried_along(std::size_t contact, int direction, double time, ConstVectorView x) const;
  double acceleration_along(const Component &component, double time,
                            ConstVectorView acceleration) const;
  contact::RelativeMotion relative_motion(std::size_t contact, double time,
                                          ConstVectorView x) const;
  contact::AcrossAxis relative_acceleration(std::size_t contact, double time,
                                            ConstVectorView acceleration) const;
  double add_circular(const Acting &acting, double time, ConstVectorView x, VectorView dxdt) const;
  void add_circular(std::size_t contact, double time, ConstVectorView x, Matrix &jacobian) const;
  void write_row(std::size_t contact, const contact::AffineForm &components, Index place,
                 Matrix &jacobian) const;
  void add_rows(std::size_t contact, const contact::AffineForm &components, const Vector &into,
                Matrix &jacobian) const;
  void write_circular_rates(std::size_t contact, double time, ConstVectorView x,
                            Matrix &jacobian) const;
  RowVector gap_acceleration_row(std::size_t contact, double time, ConstVectorView x,
                                 const Matrix &jacobian) const;
  double circular_magnitude(std::size_t contact, const contact::AffineForm &form, double time,
                            const Vector &x) const;
  std::pair<double, double> magnitude_along(const Component &component, double time,
                                            const Vector &x) const;
  void list(std::size_t contact);
  double add_contact(const Acting &acting, double time, ConstVectorView x, VectorView dxdt) const;
  double add_friction(std::size_t contact, double time, VectorView dxdt) const;
  void write_friction(const contact::ContactPair &pair, VectorView dxdt) const;
  void see_normal_force(std::size_t contact, double time, ConstVectorView x, ConstVectorView rates,
                        contact::LocalState &state) const;
  void see_margin(std::size_t contact, contact::LocalState &state) const;
  void follow_force_rates(double time, ConstVectorView x, VectorView dxdt) const;
  void follow_force_rates(double time, ConstVectorView x, Matrix &jacobian) const;
  double normal_force_magnitude(std::size_t contact, const contact::AffineForm &form, double time,
                                const Vector &x) const;
  void add_contact(std::size_t contact, double time, ConstVectorView x, Matrix &jacobian) const;
  void add_friction(std::size_t contact, Matrix &jacobian) const;
  void write_internal_rates(std::size_t contact, Matrix &jacobian) const;
  void place_constraints(double time, ConstVectorView x) const;
  double hold(double time, ConstVectorView x, VectorView dxdt) const;
  double rub(std::size_t contact, double normal_force, double time, ConstVectorView x,
             VectorView dxdt) const;
  void hold(double time, ConstVectorView x, Matrix &jacobian) const;
  void turn_held_forces(double time, ConstVectorView x, Matrix &jacobian) const;
  void add_held_gradients(double time, ConstVectorView x, ConstVectorView acceleration,
                          Matrix &missing) const;
  double acceleration_of_forces(const Component &component, double time, const Vector &x) const;
  double turning_acceleration(std::size_t contact, double time, const Vector &x) const;
  double force_magnitude(std::size_t contact, int direction, double time, const Vector &x) const;
  double add_nonlinear_forces(double time, ConstVectorView x, VectorView dxdt) const;
  void add_nonlinear_forces(double time, ConstVectorView x, Matrix &jacobian) const;
  void couple_rotors(double time, ConstVectorView x, Matrix &jacobian) const;
  Vector uncoupled_acceleration(double time, ConstVectorView x) const;

  const model::Model &model_;
  const contact::ContactSet &contacts_;
  StateLayout layout_;
  std::vector<int> modes_;
  double source_break_ = std::numeric_limits<double>::infinity();
  double last_source_time_ = std::numeric_limits<double>::infinity();
  std::vector<std::vector<char>> inactive_; ///< per contact and mode: no force, no internal states
  std::vector<Acting> acting_;
  std::vector<double> slow_slip_;      ///< of each contact
  std::vector<std::size_t> following_; ///< contacts whose modes see the rate of their normal force
  std::vector<Component> components_;  ///< of all contacts
  std::vector<std::size_t> first_component_; ///< of each
  mutable ActiveConstraints
      constraints_; ///< its response follows the position where there are rotors
  mutable SourceMemory sources_;
  mutable contact::LawResponse response_;
  mutable Vector load_, elastic_, damping_, held_rates_, held_forces_, frame_;
};

} // namespace vibroimpact::motion
