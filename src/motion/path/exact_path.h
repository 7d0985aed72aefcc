// A motion through linear phases, over any number of contact changes, in closed form.
//
// Who observes it sees parts of it with the extreme values over them, or steps, and every contact
// change.
//
// Where the kernel cannot prove what happens, where contacts change together or at once again, it
// stops before and leaves the rest to the steps that every motion can take. At a change into a
// phase that is not linear, and at an impact, it ends, but for contacts that are solved as a whole
// (episode/), from which it goes on in the phase before.
#pragma once

#include "motion/event/zero_guard.h"
#include "motion/path/guards_at_start.h"
#include "motion/path/path_observation.h"
#include "motion/path/stall.h"

#include <optional>
#include <span>
#include <vector>

namespace vibroimpact::motion {

class ExactPath {
public:
  /// Keeps references.
  ExactPath(Equations &equations, ExactPhases &phases, const Settings &settings,
            StallBound &progress, Accuracy &counts);

  /// Another motion begins, which must not depend on those before; the excitation may be another.
  void begin();
  /// The motion was moved on or changed by somebody else.
  void leave() { running_ = false; }

  /// A contact change at which the motion stands, and which is left to others.
  struct PendingChange {
    std::size_t contact = 0;
    std::size_t guard = 0;
    double residual = 0;                    ///< |indicator| left
    double rate = 0;                        ///< its rate [1/s]
    StepReason reason = StepReason::system; ///< where a nonlinear contact begins
  };

  /// Goes on from (time, state) in the present modes of the equations, to `limit` (no later than
  /// the next break of the sources) and through `most_events` contact changes at most. The guards
  /// in `zero` count as zero at first if they rise. True when that moved the motion on; pending()
  /// then tells whether a contact changes there, and state() where it stands. Where nobody
  /// wants them the work integrals stay as they are.
  bool advance(double &time, const Vector &state, double limit, long most_events,
               std::span<const ZeroGuard> zero = {}, const PathObservers *observers = nullptr);
  const Vector &state() const { return observation_.state(); }
  const std::optional<PendingChange> &pending() const { return pending_; }
  /// False: nothing can be proven from where the motion stands, and a step must find out.
  bool clear() const { return running_ || pending_; }
  double last_event() const { return last_event_; }

private:
  struct Limits {
    double event_tolerance;
    double tolerance; ///< relative, of contacts
    double longest_step;
  };
  /// Amplitudes; those of the march are two of them by turns.
  struct Buffers {
    void resize(std::size_t largest);
    /// The march goes on from `next`.
    void take_next(MarchState &march);

    Amplitudes first, present, turned, next;
    Amplitudes origin; ///< where the march began
    Vector physical;   ///< at the start
    AlignedArray magnitudes, reach;
  };
  /// Rounding turns the inputs that are carried along from phase to phase, so that they are taken
  /// from their closed form again and again.
  struct Inputs {
    void take(const Excitation &excitation, double time);
    void renew(const Excitation &excitation, const ExactPhase &phase, double time,
               double *amplitudes);

    std::vector<double> values;
    int changes = 0; ///< since they were taken
  };

  KnownPhase &prepare_start(double time);
  bool start_from(double time, std::span<const ZeroGuard> zero);
  void start_walk(KnownPhase &known, double time);
  void begin_part(double time);
  void part_the_phase(double time);
  bool change_phase(double limit, long &most_events);
  bool enter_phase(const Transition &next, std::size_t contact, double time);
  void enter(double time, KnownPhase &target, const FrictionRoutes::Route *route);
  bool is_rigid(std::size_t contact) const {
    return equations_.contacts().pairs()[contact].law->rigid();
  }
  bool has_friction(std::size_t contact) const {
    return !equations_.contacts().pairs()[contact].tangential.empty();
  }
  /// Along the plane of a contact: its guards are forms of the motion.
  bool has_plane_friction(std::size_t contact) const {
    return has_friction(contact) && !equations_.contacts().pairs()[contact].circle;
  }
  std::optional<StepReason> pass_contact(double time, std::size_t passed, double limit);
  bool enter_behind(Transition *behind, const PhaseEpisode &contact);
  int rising_order(const KnownPhase &phase, std::size_t guard, const double *amplitudes,
                   const double *derivatives) const;
  double time_tolerance(double time) const;
  void note_pending(StepReason reason);
  void note_residual();
  void stand(double time, const double *amplitudes);
  const PhaseGuard &passed_guard() const {
    return known_->guards()[static_cast<std::size_t>(march_.guard)];
  }

  const Equations &equations_;
  ExactPhases &exact_phases_;
  StallBound &progress_;
  Accuracy &counts_;
  const Kernel &kernel_;
  Limits limits_;
  KnownPhases phases_;
  PathObservation observation_;
  KnownPhase *known_ = nullptr;
  MarchState march_;
  Buffers buffers_;
  GuardsAtStart guards_;
  Inputs inputs_;
  double origin_ = 0; ///< when the march began [s]
  double last_event_;
  bool running_ = false;
  std::optional<PendingChange> pending_;
};

} // namespace vibroimpact::motion
