// A motion: the phases between contact changes strung together, each change located in time.
//
// Linear phases are propagated in closed form (exact/). Elsewhere every accepted step is a
// polynomial for each guard of the present modes, whose first down-crossing is found without
// sampling; the step is taken again up to that instant, and again after Newton corrections, until
// the instant is within the event tolerance. There the mode changes and the method restarts, as it
// does where an excitation is not smooth: no step reaches across such a break.
#pragma once

#include "motion/event/collision.h"
#include "motion/event/contact_scales.h"
#include "motion/event/zero_guard.h"
#include "motion/interval/observer.h"
#include "motion/path/accuracy.h"
#include "motion/path/stall.h"
#include "motion/path/step_costs.h"
#include "motion/settings.h"
#include "motion/steps/motion_ts.h"
#include "motion/steps/steppers.h"

#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace vibroimpact::motion {

class ExactPath;
class MomentPath;

/// Where a motion stands, to start another one from.
struct MotionState {
  double time = 0;
  Vector physical; ///< q, v, internal states of the contacts, torques of motors
};

class Trajectory {
public:
  /// Keeps references to the model and the contacts. Of these only the frequencies of the
  /// excitation may change, between two motions.
  Trajectory(const model::Model &model, const contact::ContactSet &contacts,
             const Settings &settings);
  ~Trajectory();

  /// q, v given, contacts' internal states at rest, motors at their initial torque. InputError when
  /// a contact that does not accept it starts penetrated.
  void start(double time, const Vector &displacement, const Vector &velocity);
  /// Goes on from an earlier state, whatever the contacts do there.
  void start(const MotionState &from);

  /// Integrates up to `end` exactly. NumericalError when that fails, Interrupted when the run is to
  /// stop.
  void advance(double end, const Observers &observers);
  /// The same without being observed, which some methods do faster. Where nobody wants the
  /// integrals, the energy balance is not kept: it begins anew with the next motion in which
  /// somebody does.
  void advance(double end);

  double time() const { return steppers_.present().time(); }
  const Vector &state() const { return steppers_.present().state(); }
  MotionState motion_state() const;
  const Equations &equations() const { return equations_; }
  const StateLayout &layout() const { return equations_.layout(); }
  Accuracy accuracy() const;
  /// Contact changes since start().
  long events() const { return counts_.events; }

private:
  struct Crossing {
    double tau = 0; ///< in the step
    std::size_t contact = 0;
    std::size_t guard = 0;
    double residual = 0; ///< |indicator| left where it was located
    double rate = 0;     ///< its rate there [1/s]
    double hidden = 0;   ///< what rounding makes of the instant, where it hides the residual [s]
    StepReason reason = StepReason::system; ///< where a nonlinear contact begins
  };

  struct PresentGuard {
    std::size_t contact = 0;
    std::size_t guard = 0;
    Index place = 0; ///< among those of all contacts
  };

  /// A form of a contact's local state that is zero but for an error.
  struct KnownZero {
    contact::AffineForm form;
    double size = 0; ///< of the error
  };

  /// Of energies, since it began.
  struct Balance {
    bool integrals = true; ///< of work and impulses are kept
    bool exact = true;     ///< every step
    double initial_energy = 0;
    Vector initial_state; ///< with its work integrals
  };

  /// Of the last event.
  struct LastInstant {
    double time = -std::numeric_limits<double>::infinity();
    long events = 0;                    ///< without progress in time
    std::vector<std::size_t> changed{}; ///< contacts
    /// Modes of all contacts, since the last impulse.
    std::vector<std::vector<int>> tried{};
  };

  const contact::Guard &guard_of(std::size_t contact, std::size_t guard) const {
    return equations_.mode(contact).guards[guard];
  }
  double negligible(std::size_t contact, const contact::AffineForm &form) const;
  void forget_grown_guards();
  Bernstein indicator(const StepView &view, std::size_t contact, std::size_t guard) const;
  void begin_phase(double time, const Vector &state);
  void integrate(double end, const Observers &observers);
  void move(double end, const Observers &observers);
  bool propagate(double limit, const Observers &observers);
  bool propagate_by_moments(double limit, const Observers &observers);
  void note_path_events();
  void take_over();
  void begin_balance();
  bool at_source_break() const;
  void pass_source_break();
  void choose_initial_modes(double time, const Vector &state);
  void enter_contacts(double time, Vector &state) const;
  void refuse_penetration(double time, const Vector &state) const;
  bool changes_in_step(Crossing &crossing);
  void list_guards();
  bool find_crossing(const StepView &view, Crossing &crossing) const;
  bool locate(Crossing &crossing);
  GuardStart guard_start(std::size_t contact, std::size_t guard) const;
  bool find_fall(const GuardCurves &curves, Crossing &crossing);
  void end_at_fall(Crossing &crossing);
  void end_at_start(Crossing &crossing);
  double event_uncertainty(const StepView &view, Crossing &crossing) const;
  void change_modes(const Crossing &first, const Observers &observers);
  void collide(std::size_t first, const Observers &observers);
  void renew_zero_guards(const Vector &state);
  void note_zero_guards(const Vector &state);
  void note_zero_guards(std::size_t contact, const std::vector<KnownZero> &known, double delay,
                        const Vector &state);
  std::vector<ZeroGuard>::const_iterator find_zero_guard(std::size_t contact,
                                                         std::size_t guard) const;
  std::vector<KnownZero> known_zeros(const Crossing &first, bool stuck) const;
  void pass_guard(const Crossing &first, bool stuck, const Observers &observers);
  void keep_modes();
  bool keeps_modes() const;
  void change_mode(double instant, std::size_t contact, std::size_t guard, Vector &state,
                   const Observers &observers);
  StepView view() const;
  void show(const StepView &step);
  double time_tolerance() const;
  double location_tolerance() const;
  void note_change(std::size_t contact, bool at_once);
  StepReason reason_for_steps() const;
  std::string stall_reason(const std::string &what) const;
  double energy_threshold() const;

  Settings settings_;
  Equations equations_;
  ContactScales scales_;
  Collisions collisions_;
  Steppers steppers_;
  std::unique_ptr<MotionTs> ts_;    ///< none: nobody looks at it by PETSc's means
  std::unique_ptr<ExactPath> path_; ///< none where the method is another
  StepCosts costs_;
  std::unique_ptr<MomentPath> moments_; ///< none where such steps cannot be taken or are not due
  bool steps_outdated_ = false;         ///< the steppers must begin anew to take a step
  Balance balance_;
  Accuracy counts_; ///< without the energies
  LastInstant last_;
  StallBound progress_;
  std::vector<PresentGuard> guards_; ///< of the phase, in the order in which they count
  /// Guards that were zero at the start of the phase and have not grown beyond that yet.
  std::vector<ZeroGuard> zero_at_start_;
  Vector before_; ///< the state before the last change of a mode
  /// Who is shown steps, as asked in these modes of the contacts.
  Audience audience_;
  std::optional<std::vector<int>> audience_modes_;
};

} // namespace vibroimpact::motion
