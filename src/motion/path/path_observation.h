// What a motion in closed form shows of itself: its parts with the extreme values over them, or
// steps, and the state with its work integrals at their ends.
#pragma once

#include "motion/episode/contact_steps.h"
#include "motion/path/accuracy.h"
#include "motion/path/known_phases.h"

#include <functional>
#include <limits>

namespace vibroimpact::motion {

/// A contact change of which it is known what it leads to.
struct KnownChange {
  double time = 0;
  std::size_t contact = 0;
  std::size_t guard = 0;
  const FrictionRoutes::Route &route;
  const Vector &behind; ///< the physical state, where the route changes it
};

/// Who observes, and what a contact change takes: `state` is that just before, with its work
/// integrals, in the modes before; the change is that of `contact` through `guard`.
struct PathObservers {
  const Observers &observers;
  bool integrals = true; ///< of work and impulses are to be kept
  std::function<void(double time, std::size_t contact, std::size_t guard, Vector &state)> change;
  std::function<void(const KnownChange &change, Vector &state)> known_change;
};

class PathObservation {
public:
  /// Keeps references. `tolerance`: relative, of contacts.
  PathObservation(const Equations &equations, const ExactPhases &phases, double tolerance,
                  Accuracy &counts);

  /// From a state on; nullptr: nobody observes.
  void begin(const PathObservers *observers, const Vector &state);
  bool observed() const { return observers_ != nullptr; }
  const Vector &state() const { return state_; }

  /// Of a phase that the modes of the equations are those of.
  struct Start {
    double time = 0;
    const double *amplitudes = nullptr;
    bool stays = false;        ///< these amplitudes, until the part is over
    bool enters_phase = false; ///< or goes on in it
  };
  void enter(KnownPhase &phase) { phase_ = &phase; }
  /// Where somebody observes.
  void begin_part(KnownPhase &phase, const Start &start);
  /// Up to which its work integrals are exact [s]; infinite where nobody wants them.
  double part_limit() const {
    return observers_ ? part_limit_ : std::numeric_limits<double>::infinity();
  }
  /// The modes of the equations are those of the part. Leaves its state at the end.
  void end_part(double time, const double *amplitudes);
  /// Reports a contact change at the end of the part, which takes the equations to the modes after
  /// it.
  void report_change(double time, const PhaseGuard &passed, const double *amplitudes);
  /// The same of a contact with friction, which comes to amplitudes of another phase.
  void report_friction(double time, const PhaseGuard &passed, const double *amplitudes,
                       const FrictionRoutes::Route &route, const ExactPhase &next,
                       const double *behind);
  /// Reports the contact that was passed last, which begins at a guard at the end of the part.
  void report_contact(ContactPart &part, double time, const PhaseGuard &passed,
                      const double *amplitudes);

private:
  ObservedPhase &observation_of(KnownPhase &phase) const;
  ObservedContact &observation_of(ContactPart &part) const;
  void show_steps(double time, const double *amplitudes);
  void show_whole(ContactPart &part, ObservedContact &observed, double time);

  const Equations &equations_;
  const ExactPhases &phases_;
  double tolerance_;
  Accuracy &counts_;
  ContactSteps contact_steps_;
  const PathObservers *observers_ = nullptr;
  Vector state_;
  // Of the present part:
  KnownPhase *phase_ = nullptr;
  ObservedPhase *observed_ = nullptr;
  Start start_;
  Amplitudes start_copy_; ///< of amplitudes that do not stay
  Vector start_state_;
  Vector behind_; ///< physical state, behind a contact change
  double part_limit_ = 0;
  // Of a step that is shown:
  Amplitudes step_start_, step_end_;
  EndPoint start_point_, end_point_;
};

} // namespace vibroimpact::motion
