// A nonlinear contact within a linear phase: while the two sides touch, the phase goes on under one
// more force, in its own coordinates, and when they have parted it is the same phase again.
//
// In a circular gap it is a force along two directions, which is solved in the frame of the touch
// and acts along the axes of the gap.
//
// For laws with force_pulse(), which says how the force begins and by which guards of its mode it
// may end. Of several guards that which ended the contact before is tried first; the others must
// stay positive. Where the mode behind the guard is another one than that before the touch (inside
// without force), another linear phase follows. The guards of all other contacts are proven to stay
// positive (other_guards.h).
//
// What cannot be proven, or is no single hump of force, is left to others.
#pragma once

#include "motion/episode/contact_episode.h"
#include "motion/episode/other_guards.h"
#include "motion/episode/step_reason.h"
#include "motion/phase/exact_phases.h"

#include <Eigen/SparseCore>

#include <memory>
#include <optional>

namespace vibroimpact::motion {

/// What earlier contacts that began at one guard have taught; it outlives what solves them.
struct TaughtContact {
  int left_out = 0;       ///< contacts to come that are left to others
  std::size_t ending = 0; ///< of the last contact
  long generation = -1;   ///< of the phase that these are for:
  std::vector<std::shared_ptr<ContactEpisode::Taught>> shapes{}; ///< by endings

  void forget();
};

class PhaseEpisode {
public:
  /// The contact that begins where `guard` of the phase is passed, in `mode` of its law. nullptr:
  /// none of this kind. The modes of the equations are those of the phase. Keeps references.
  static std::unique_ptr<PhaseEpisode>
  create(const Equations &equations, LinearPhase &linear, std::size_t guard, int mode,
         double tolerance,
         std::shared_ptr<TaughtContact> taught = std::make_shared<TaughtContact>());

  /// From the amplitudes at the touch. `longest`: what the contact may last [s]. A reason: it is
  /// left to others, as are the next few when it was of another kind.
  std::optional<StepReason> pass(const double *amplitudes, double longest);

  // Of the contact passed last:
  double duration() const { return contact_->duration(); } ///< [s]
  const Amplitudes &after() const { return after_; }
  std::size_t contact() const { return onset_.contact; }
  /// Guard of the contact's mode by which its force ends, and the mode behind it.
  std::size_t release() const { return endings_[taught_->ending].guard; }
  int mode_after() const { return mode().guards[release()].target; }
  const contact::ContactPair &pair() const { return equations_.contacts().pairs()[onset_.contact]; }
  int n_directions() const { return pair().circle ? 2 : 1; }
  int mode_within() const { return mode_; }
  /// Largest rounding of each of the phase's groups that the contact has added.
  void add_rounding(double *rounding) const;

  const ContactEpisode &solution() const { return *contact_; }
  const ForcedFlow &flow() const { return *flow_; }
  /// The penetration; of a circular gap u_1 and u_2.
  const ForcedOutput &output(int direction = 0) const {
    return outputs_[static_cast<std::size_t>(direction)];
  }
  LinearPhase &linear() const { return linear_; }
  /// What amplitudes x mean: the physical state, C x, and the second derivatives of velocities and
  /// internal states and the third of sources, C S^2 x, rows of C as in ExactPhase::columns().
  using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  const Rows &state_rows() const { return state_rows_; }
  const Rows &bent_rows() const { return bent_rows_; }
  /// Of the physical state: C S b, what one newton along each axis adds to these.
  const Vector &bent_load(int direction = 0) const {
    return bent_loads_[static_cast<std::size_t>(direction)];
  }
  /// Amplitudes at the touch, with the internal states that the contact begins with.
  const Amplitudes &before() const { return before_; }
  /// (I_k f)(1) of the solution, k < terms(), of each direction.
  const std::vector<double> &end_moments() const { return end_moments_; }
  /// The law, with the internal states that the contact keeps.
  const LawForce &force() const { return *force_; }
  /// Adds to amplitudes what the force has made of them by a target of ContactEpisode::moments().
  void add_force(const std::vector<double> &moments, int n_targets, int target,
                 double *amplitudes) const;
  /// The force at a node along an axis of a circular gap, or along the normal [N].
  double force_along(int axis, int node) const;

  /// Counts the systems that flow() has been made for; what was made of an earlier one is outdated.
  long version() const { return version_; }
  std::size_t bytes() const;
  /// A form of the rows of the phase, by the places of the amplitudes.
  Vector in_amplitudes(const RowVector &row) const;

private:
  struct Ending {
    std::size_t guard = 0; ///< of the contact's mode
    contact::ForceEdge edge{};
    std::unique_ptr<ContactEpisode> contact{};
  };

  PhaseEpisode(const Equations &equations, LinearPhase &linear, const PhaseGuard &onset, int mode,
               double tolerance, std::shared_ptr<TaughtContact> taught);

  const contact::ContactLaw &law() const { return *pair().law; }
  const contact::Mode &mode() const { return law().modes()[static_cast<std::size_t>(mode_)]; }
  bool leads_back(const contact::Guard &guard) const;
  void renew();
  Vector load(int direction) const;
  void set_outputs();
  void set_rows();
  Vector by_places(const RowVector &seen) const;
  std::vector<FlowBlock> blocks() const;
  void find_frame();
  void reset_internal();
  Motions touch() const;
  Refusal solve(double longest);
  EndCondition condition(std::size_t guard) const;
  void finish();
  bool guards_of_law_hold() const;
  Push push_along(int axis) const;
  bool others_stay_away();

  const Equations &equations_;
  LinearPhase &linear_;
  PhaseGuard onset_;
  int mode_; ///< of the contact
  double tolerance_;
  std::unique_ptr<LawForce> force_;
  std::unique_ptr<ForcedFlow> flow_;
  std::vector<ForcedOutput> outputs_; ///< by axes
  TouchFrame frame_;                  ///< of the present contact, where the normal turns
  std::vector<Ending> endings_;
  std::shared_ptr<TaughtContact> taught_;
  ContactEpisode *contact_ = nullptr; ///< by the ending of the last contact
  long generation_ = -1;              ///< of the phase that these are for
  Rows state_rows_, bent_rows_;
  std::vector<Vector> bent_loads_;
  Amplitudes before_, after_;
  std::vector<double> end_moments_;
  long version_ = 0;
  std::vector<double> internal_;
  OtherGuards others_;
  Vector state_;
};

} // namespace vibroimpact::motion
