// A motion through linear phases, over any number of contact changes, in closed form.
//
// Who observes it sees the extreme values of linear forms of the motion or its parts as steps, and
// every contact change.
//
// Where the kernel cannot prove what happens, where contacts change together or at once again, it
// stops before and leaves the rest to the steps that every motion can take. At a change into a
// phase that is not linear, and at an impact, it ends, but for contacts that are solved as a whole
// (collocation/), from which it goes on in the phase before.
#pragma once

#include "motion/episode/contact_outputs.h"
#include "motion/episode/contact_steps.h"
#include "motion/event/zero_guard.h"
#include "motion/interval/observer.h"
#include "motion/path/accuracy.h"
#include "motion/path/exact_outputs.h"
#include "motion/path/stall.h"
#include "motion/phase/exact_change.h"
#include "motion/phase/exact_phases.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace vibroimpact::motion {

/// Who observes, and does what a contact change takes: `state` is that just before, with its work
/// integrals, in the modes before; the change is that of `contact` through `guard`.
struct PathObserver {
  OutputMonitor *monitor = nullptr; ///< none: nobody wants extreme values
  Observer *steps = nullptr;        ///< none: nobody must see steps
  Observer *everyone = nullptr;     ///< sees steps through contacts that somebody must see so
  bool integrals = true;            ///< of work and impulses are to be kept
  std::function<void(double time, std::size_t contact, std::size_t guard, Vector &state)> change;
};

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
               std::span<const ZeroGuard> zero = {}, const PathObserver *observer = nullptr);
  const Vector &state() const { return state_; }
  const std::optional<PendingChange> &pending() const { return pending_; }
  /// False: nothing can be proven from where the motion stands, and a step must find out.
  bool clear() const { return running_ || pending_; }
  double last_event() const { return last_event_; }

private:
  struct KnownPhase;
  // What an observer monitors of a contact that is solved as a whole.
  struct MonitoredContact {
    long monitor = -1;
    MonitoredForms forms;
    std::unique_ptr<ContactOutputs> outputs{};
  };
  struct ContactEpisodePart {
    std::unique_ptr<PhaseEpisode> contact;
    std::unique_ptr<ContactWork> work{}; ///< none until the integrals are asked for
    /// By the present observer and by the one before.
    std::unique_ptr<MonitoredContact> monitored{}, monitored_before{};

    std::size_t bytes() const;
  };
  struct Transition {
    std::size_t bytes() const;

    KnownPhase *target = nullptr;   ///< none: left to others
    std::vector<double> proportion; ///< of the guards of the target to the one passed
    std::unique_ptr<ExactChange> change{};
    long excitation = -1; ///< that the change is for
    bool contact_known = false;
    std::unique_ptr<ContactEpisodePart>
        contact{}; ///< of a target that is not linear; none: left to others
    /// The linear phase behind a contact, by the mode that it ends in.
    std::map<int, std::unique_ptr<Transition>> behind{};
  };
  // What an observer monitors of a phase.
  struct MonitoredOutputs {
    long monitor = -1;
    MonitoredForms forms;
    std::unique_ptr<ExactOutputs> outputs{}; ///< none where there are no forms
    long excitation = -1;                    ///< that these are for
  };
  // What depends on the excitation is renewed when it is asked for under another one.
  struct KnownPhase : PhasePart {
    explicit KnownPhase(LinearPhase &of) : linear(of), transitions(guards().size()) {}
    std::size_t bytes() const override;
    void forget(const LinearPhase &other) override;

    LinearPhase &linear;
    std::vector<std::unique_ptr<Transition>> transitions;
    /// By the present observer and by the one before: a search for the steady motion and the
    /// recorders of a window take turns.
    std::unique_ptr<MonitoredOutputs> monitored{}, monitored_before{};

    const std::vector<PhaseGuard> &guards() const { return linear.forms().guards(); }
    ExactPhase &phase() const { return linear.phase(); }
    const PhaseView &view() const { return linear.phase().view(); }
  };

  void set_modes(const std::vector<int> &modes);
  KnownPhase *known_phase();
  void renew(Transition &transition, const std::vector<PhaseForms::Reset> &resets);
  Transition *transition(std::size_t guard);
  Transition find_transition(const PhaseGuard &passed);
  bool start_from(double time, std::span<const ZeroGuard> zero);
  void prepare_monitoring(KnownPhase &known);
  void begin_part(double time);
  void end_part(double time, const double *amplitudes);
  void part_the_phase(double time);
  void show_steps(double time, const double *amplitudes);
  void report_change(double time);
  void start_walk(KnownPhase &known);
  bool change_phase(double limit, long &most_events);
  bool change_friction(double time, std::size_t passed);
  void enter(double time, KnownPhase &target);
  ContactEpisodePart *contact_beyond(std::size_t guard);
  std::optional<StepReason> pass_contact(double time, std::size_t passed, double limit);
  Transition *phase_behind(std::size_t passed, const PhaseEpisode &contact);
  bool enter_behind(Transition *behind, const PhaseEpisode &contact);
  void report_contact(ContactEpisodePart &part, double time);
  void monitor_contact(ContactEpisodePart &part, double time);
  ContactOutputs &outputs_of(ContactEpisodePart &part);
  void renew_inputs(const ExactPhase &phase, double time, double *amplitudes);
  /// Of a guard in the phase to come, by its derivatives there: what its value is known to.
  using KnownTo = std::function<double(std::size_t guard, const double *derivatives)>;
  bool begin_guards(const KnownPhase &phase, std::optional<std::size_t> contact,
                    const Amplitudes &amplitudes, const AlignedArray &rounding,
                    const KnownTo &known_to);
  int rising_order(const KnownPhase &phase, std::size_t guard, const double *amplitudes,
                   const double *derivatives) const;
  double hidden(const PhaseView &view, std::size_t guard, const double *amplitudes) const;
  double time_tolerance(double time) const;
  void note_pending(StepReason reason);
  void note_residual();
  void stand(double time, const double *amplitudes);

  Equations &equations_;
  ExactPhases &exact_phases_;
  StallBound &progress_;
  Accuracy &counts_;
  const Kernel &kernel_;
  double event_tolerance_, tolerance_, longest_step_;
  ContactSteps contact_steps_;
  std::vector<double> inputs_;
  KnownPhase *known_ = nullptr;
  MarchState march_;
  Amplitudes first_, amplitudes_, turned_, next_;
  AlignedArray magnitudes_, reach_, rounding_, next_rounding_, noise_;
  std::vector<unsigned char> order_;
  int changes_ = 0; ///< since the inputs were taken from the sources
  Vector physical_;
  double origin_ = 0; ///< when the walk began
  double last_event_;
  bool running_ = false;
  std::optional<PendingChange> pending_;
  const PathObserver *observer_ = nullptr; ///< of the present call
  Vector state_;
  Amplitudes start_;             ///< when the walk began
  const double *part_ = nullptr; ///< at the start of the part that is not reported yet
  Amplitudes part_copy_;         ///< if that is not when the walk began
  double part_start_ = 0, part_limit_ = 0;
  Amplitudes step_start_, step_end_;
  EndPoint start_point_, end_point_; ///< of a step that is shown
};

} // namespace vibroimpact::motion
