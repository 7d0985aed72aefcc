// A motion over any number of contact changes that nobody watches, as settling is: linear phases of
// the flight kernel strung together.
//
// Only what is clear is done here. Where the kernel cannot prove what happens, where contacts
// change together or at once again, where a guard starts on the edge or a phase is not made of
// exponentials, the flight stops before it and leaves the rest to the steps that every motion can
// take.
#pragma once

#include "integration/flight_kernel.h"
#include "integration/flight_phase.h"
#include "integration/flight_stepper.h"

#include <map>
#include <memory>
#include <vector>

namespace vibroimpact {

class UnwatchedFlight {
public:
  struct Tally {
    long pieces = 0;
    long events = 0;
    double event_residual = 0; ///< largest uncertainty of an event's instant [s]
  };

  /// Keeps references.
  UnwatchedFlight(Equations &equations, FlightStepper &stepper, double event_tolerance);

  /// The equations, or the excitation, are others.
  void forget();
  /// The motion was moved on or changed by somebody else.
  void leave() { aloft_ = false; }

  /// Flies on from (time, state) in the present modes of the equations, to `limit` (no later than
  /// the next break of the sources) at most. True when that moved the motion on; the entries of the
  /// ledger stay as they are.
  bool fly(double &time, Vector &state, double limit);
  /// Of all flights so far; add up and clear.
  Tally take_tally();
  double last_event() const { return last_event_; }

private:
  struct Transition {
    FlightPhase *target = nullptr;
    std::vector<double> proportion; ///< of the guards of the target to the one passed
  };
  struct KnownPhase {
    std::unique_ptr<FlightPhase> phase; ///< none: not made of exponentials
    std::vector<std::unique_ptr<Transition>> transitions;
  };

  bool take_off(double time, const Vector &state);
  bool same_inputs() const;
  KnownPhase &known_phase();
  const Transition *transition(std::size_t guard);
  void set_inputs(double time, const FlightPhase &phase, Amplitudes &amplitudes) const;
  bool change_phase();
  bool begin_guards(const Transition &transition, std::size_t passed);
  double time_tolerance(double time) const;
  void land(double time, Vector &state);

  Equations &equations_;
  FlightStepper &stepper_;
  double event_tolerance_;
  std::map<std::vector<int>, KnownPhase> phases_;
  std::vector<ExponentialForm> sources_; ///< with the common origin they had when phases_ was begun
  KnownPhase *known_ = nullptr;
  FlightKernel kernel_, next_;
  Amplitudes amplitudes_;
  Vector rows_, physical_;
  double origin_ = 0; ///< when kernel_ was started
  double last_event_;
  bool aloft_ = false;
  Tally tally_;
};

} // namespace vibroimpact
