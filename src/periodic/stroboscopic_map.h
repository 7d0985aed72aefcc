// The map of a forced motion over a number of half periods, with its exact derivatives.
//
//   x(t_0) -> sigma^h x(t_0 + h T/2),   t_0 = phase T
//
// Entries of the state that the motion does not see (contact_memory) are zero at t_0, whatever x
// is. h = 2p is the stroboscopic map P^p over p periods; odd h needs the symmetry sigma of the
// model. Derivatives by a key keep the phase of the forcing: where the key changes the period, both
// ends of the motion move,
//
//   dx/dp = x_p + f(t_1) dt_1/dp - x_x f(t_0) dt_0/dp,   t_i = phase_i T,   dt_i/dp = phase_i T'
//
// with x_p, x_x at fixed times and f = dx/dt.
//
// Where no excitation gives the period, the map goes back to a plane across the motion
// (free_period.h), phases are times since the start in parts of the period and name the planes, and
// a map of h half periods is one to the h-th return near there.
//
// Seen from another phase the same motion has another state but the same multipliers. An event that
// passes the phase along a branch makes a kink in the state though the motion is smooth, so that
// the phase is placed away from events.
#pragma once

#include "motion/variation/linearised_motion.h"
#include "periodic/event_pattern.h"
#include "periodic/symmetry.h"

#include <memory>
#include <optional>

namespace vibroimpact::periodic {

/// Where the map begins and how far it goes.
struct Section {
  double phase = 0; ///< of the forcing, in its periods; of later ones too: 0 <= phase < multiple
  long halves = 2;  ///< h > 0 [half periods]

  double length() const { return 0.5 * static_cast<double>(halves); } ///< [periods]
  /// Odd h: the map includes the symmetry.
  bool with_symmetry() const { return halves % 2 != 0; }
  /// Periods after which a motion with this h, and no smaller one, repeats itself.
  long multiple() const { return with_symmetry() ? halves : halves / 2; }
};

/// A motion with its derivatives; n physical states.
struct Flow {
  Vector state;    ///< at the end, behind sigma^h
  Vector rates;    ///< dx/dt there
  Matrix by_state; ///< n x n
  Matrix by_keys;  ///< n x keys, per unit of each
  EventPattern pattern;
  motion::Determinant determinant; ///< of by_state, behind the projection of the start
  long without_derivative = 0;     ///< events, see motion::LinearisedMotion
};

class StroboscopicMap {
public:
  /// Keeps a reference. `accuracy` of the tangents, see motion::Variation.
  StroboscopicMap(ForcedSystem &system, motion::VariationAccuracy accuracy,
                  std::optional<Symmetry> symmetry = {});

  /// The derivatives by these keys are wanted from now on.
  void set_keys(std::vector<ForcedKey *> keys) { keys_ = std::move(keys); }
  bool symmetric() const { return symmetry_.has_value(); }
  /// At the present keys [s].
  double period() const { return system_.period(); }
  Index size() const { return system_.layout().physical_size(); }
  const ForcedSystem &system() const { return system_; }
  const std::vector<ForcedKey *> &keys() const { return keys_; }
  const Vector &scale() const { return accuracy_.scale; }
  /// Largest scaled entry.
  double norm(const Vector &state) const {
    return state.cwiseProduct(accuracy_.scale).cwiseAbs().maxCoeff();
  }

  /// NumericalError when the motion or its variation fails, Interrupted.
  Flow image(const Section &section, const Vector &state) const;
  /// The same on the way to another section, onto its plane where the period is free.
  Flow to_section(double from, double to, double phase, const Vector &state) const;
  /// Of a free period, after motions that were only looked at; does nothing otherwise.
  void set_period(double period) const;
  /// From one phase to a later one, which may be beyond the period.
  Flow flow(double from, double to, const Vector &state) const;
  /// That from which motions of a section go on for its length; where the period is free they
  /// all begin at zero.
  double first_phase(const Section &section) const {
    return system_.free_period() ? 0 : section.phase;
  }
  enum class Return { lost, nearer, there };
  /// Where the period is free: one step of Newton's method for the return of a motion that is there
  /// at the end of a section, behind sigma^h.
  Return step_to_return(const Section &section, const Plane &plane, const Vector &there,
                        const Vector &rates) const;
  /// The plane of a section, through this state where there is none yet.
  const Plane &plane(const Section &section, const Vector &begin) const;
  /// What a short time more or less makes of a flow that ends beside a plane.
  static void project(const Plane &plane, Flow &flow);
  /// The state alone.
  Vector carry(double from, double to, const Vector &state) const;
  /// The motion seen by an observer.
  void observe(double from, double to, const Vector &state, motion::Observer &observer) const;
  /// Begins a motion, so that the equations of the system are in its modes; returns it.
  motion::Trajectory &start(double phase, const Vector &state) const;
  /// Entries of the state that a motion from there does not see (contact_memory.h).
  std::vector<Index> idle(double phase, const Vector &state) const;
  /// dx/dt at a phase.
  Vector rates(double phase, const Vector &state) const;
  /// sigma^h applied to columns.
  Matrix mirrored(const Section &section, const Matrix &columns) const {
    return section.with_symmetry() ? symmetry_.value().apply(columns) : columns;
  }
  /// The contact that does, a section later, what this one does.
  std::size_t mirrored(const Section &section, std::size_t contact) const {
    return section.with_symmetry() ? symmetry_.value().partner(contact) : contact;
  }

private:
  Flow mirrored(const Section &section, Flow flow) const;
  Flow return_to_plane(const Section &section, const Vector &begin) const;
  void find_return(const Section &section, const Plane &plane, const Vector &begin) const;
  bool refine_return(const Section &section, const Plane &plane, const Vector &begin) const;
  double look_for_return(const Section &section, const Plane &plane, const Vector &begin) const;

  ForcedSystem &system_;
  motion::VariationAccuracy accuracy_;
  std::shared_ptr<motion::Lineariser> lineariser_; ///< of the system
  std::optional<Symmetry> symmetry_;
  std::vector<ForcedKey *> keys_;
};

/// Eigenvalues of a matrix, the largest first, of a conjugate pair that with positive imaginary
/// part. `scale` makes the entries of a state comparable.
Eigen::VectorXcd multipliers_of(const Matrix &by_state, const Vector &scale);

} // namespace vibroimpact::periodic
