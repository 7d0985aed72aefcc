// A motion over any number of contact changes: linear phases of the flight kernel strung together.
// Who watches it sees the extreme values of what is linear in the motion, and every contact change.
//
// Only what is clear is done here. Where the kernel cannot prove what happens, where contacts
// change together or at once again or where a guard starts on the edge, the flight stops before it
// and leaves the rest to the steps that every motion can take. At a change into a phase that is not
// made of exponentials, and at an impact, it ends.
#pragma once

#include "integration/flight_kernel.h"
#include "integration/flight_ledger.h"
#include "integration/flight_phase.h"
#include "integration/flight_stepper.h"
#include "integration/phase_change.h"
#include "integration/zero_guard.h"

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace vibroimpact::integration {

/// Who watches a flight, and does what a contact change takes: `state` is that just before, with
/// its ledger, in the modes before; the change is that of `contact` through `guard`.
struct FlightCompany {
  FlightWatcher *watcher = nullptr;
  std::function<void(double time, std::size_t contact, std::size_t guard, Vector &state)> change;
};

class FlightPath {
public:
  struct Tally {
    long pieces = 0;
    long events = 0;
    double event_residual = 0; ///< largest uncertainty of an event's instant [s]
  };

  /// Keeps references.
  FlightPath(Equations &equations, FlightStepper &stepper, double event_tolerance);

  /// Another motion begins; the frequencies of the excitation may be others.
  void begin();
  /// The motion was moved on or changed by somebody else.
  void leave() { aloft_ = false; }

  /// A contact change at which a flight has ended, and which is left to others.
  struct Landing {
    std::size_t contact = 0;
    std::size_t guard = 0;
    double residual = 0; ///< |indicator| left
    double rate = 0;     ///< its rate [1/s]
  };

  /// Flies on from (time, state) in the present modes of the equations, to `limit` (no later than
  /// the next break of the sources) and through `most_events` contact changes at most. The guards
  /// in `zero` count as zero at first if they rise. True when that moved the motion on; landing()
  /// then tells whether a contact changes there. Without company the entries of the ledger stay as
  /// they are.
  bool fly(double &time, Vector &state, double limit, long most_events,
           std::span<const ZeroGuard> zero = {}, const FlightCompany *company = nullptr);
  const std::optional<Landing> &landing() const { return landing_; }
  /// False: where the last flight has ended nothing can be proven, and a step must find out.
  bool clear() const { return aloft_ || landing_; }
  /// Of all flights so far; add up and clear.
  Tally take_tally();
  double last_event() const { return last_event_; }

private:
  struct KnownPhase;
  struct Transition {
    KnownPhase *target = nullptr;   ///< none: left to others
    std::vector<double> proportion; ///< of the guards of the target to the one passed
    std::unique_ptr<PhaseChange> change{};
    long excitation = -1; ///< that the change is for
  };
  // What a watcher wants to see of a phase.
  struct Wishes {
    long watcher = -1;
    WatchedForms forms{{}};
  };
  // The forms belong to the modes, the rest to the excitation as well, and is renewed when it is
  // asked for under another one; what is missing is not known yet.
  struct KnownPhase {
    std::unique_ptr<PhaseForms> forms; ///< none: not linear
    std::vector<std::unique_ptr<Transition>> transitions;
    std::unique_ptr<PowerForms> powers;
    Wishes wishes;
    long described = -1; ///< the excitation
    bool flies = false;  ///< is made of exponentials under that excitation
    std::unique_ptr<FlightPhase> phase;
    std::unique_ptr<FlightLedger> ledger;
    long ledger_excitation = -1;
    std::unique_ptr<WatchedSums> watched; ///< for the wishes
    long watched_excitation = -1;
  };

  void describe(KnownPhase &known);
  void take_excitation();
  void forget_exponentials();
  bool take_off(double time, const Vector &state, std::span<const ZeroGuard> zero);
  bool begin_guard(std::size_t guard, std::span<const ZeroGuard> zero);
  KnownPhase &known_phase();
  Transition *transition(std::size_t guard);
  Transition find_transition(const FlightGuard &passed);
  bool prepare_watch(KnownPhase &known);
  bool begin_stretch(double time);
  void end_stretch(double time, const Amplitudes &amplitudes);
  bool tell_change(double time, KnownPhase &next);
  void set_inputs(double time, const FlightPhase &phase, Amplitudes &amplitudes) const;
  bool change_phase();
  bool begin_guards(const Transition &transition, std::size_t passed);
  double time_tolerance(double time) const;
  void note_landing();
  void note_residual();
  void land(double time, const Amplitudes &amplitudes, Vector &state);

  Equations &equations_;
  FlightStepper &stepper_;
  double event_tolerance_;
  std::map<std::vector<int>, KnownPhase> phases_;
  std::vector<model::ExponentialForm> sources_; ///< of the present excitation, with their origin
  long excitation_ = 0;                         ///< counts the excitations
  ExponentialBasis described_;                  ///< as it comes from the stepper
  Matrix inverse_;
  KnownPhase *known_ = nullptr;
  std::array<FlightKernel, 2> kernels_;
  FlightKernel *kernel_ = &kernels_[0], *next_ = &kernels_[1]; ///< they take turns
  Amplitudes amplitudes_;
  int changes_ = 0; ///< since the inputs were taken from the sources
  Vector rows_, physical_;
  double origin_ = 0; ///< when kernel_ was started
  double last_event_;
  bool aloft_ = false;
  std::optional<Landing> landing_;
  Tally tally_;
  const FlightCompany *company_ = nullptr; ///< of the present flight
  Vector *state_ = nullptr;                ///< of the present flight
  Amplitudes stretch_;                     ///< at its start
  double stretch_start_ = 0;
};

} // namespace vibroimpact::integration
