// Collisions: what happens at the instant at which rigid contacts meet.
//
// All contacts that touch at that instant take part, those that rest on each other too, except
// those that part already. Their impulses follow from Newton's rule (contact/impulses.h). Of those
// that touch without relative speed afterwards, the ones that are pressed on each other rest: a
// complementarity problem of the same kind, for forces and gap accelerations. The others are open.
// Where such an acceleration is zero to rounding, the first higher derivative of the gap that is
// not decides in its place, by its sign a little later.
//
// Where one of them has friction, impulses, forces and modes of all come from the problems with
// friction (event/rubbing.h). The impact at which a chatter begins is then plastic with friction:
// all friction impulses up to the end of T add up to mu times those along the normal, and so does
// the force of the slip that follows.
//
// Chatter. A contact with restitution e < 1 that parts with speed u under a constant gap
// acceleration -a meets again infinitely often, and rests after T = 2 u / (a (1 - e)). Once the
// flights are lower than eight times what counts as touching (ContactScales::length), u^2 / (2 a),
// or shorter than eight times the tolerance of events, and the acceleration expected at the end of
// T is still more than half of a, the rest of the sequence is left out: the contact rests at once.
// The total impulse up to the end of T is the same, 2 u m / (1 - e) more than a plastic impact has,
// whether it comes in steps or as the force at rest, so that positions and velocities after T
// differ by no more than the height of the flights. Where rounding of the gap would keep the
// flights from becoming so low, they end where it does. For e = 1 there is no end: under a pressure
// that grows the flights become ever shorter, v^3 / a being an adiabatic invariant of a bouncing
// body, and under one that fades v falls with a^(1/3). There the flights are left out too once
// their energy m v^2 / 2 is below the relative tolerance of all energy there is, which from then on
// never comes back: the motion differs from that with flights by no more than v and their height.
#pragma once

#include "motion/event/contact_scales.h"
#include "motion/interval/observer.h"
#include "motion/settings.h"

#include <vector>

namespace vibroimpact::motion {

class Collisions {
public:
  /// What one contact did.
  struct Change {
    std::size_t contact = 0;
    int from = 0;
    int to = 0;
    bool onset = false;
    double gap = 0;              ///< [m]
    double gap_rate = 0;         ///< before [m/s]
    double gap_rate_after = 0;   ///< [m/s]
    double chatter_duration = 0; ///< T of a chatter that was left out, or 0 [s]
  };
  struct Outcome {
    std::vector<Change> changes; ///< only of contacts that did something, the first one first
    std::vector<std::size_t> touching;
    std::vector<double> gaps; ///< of those that touch [m]
    Collision record;
    long reduced = 0; ///< restitutions that were reduced, so that the energy did not grow
  };

  /// Keeps references.
  Collisions(Equations &equations, const Settings &settings, const ContactScales &scales)
      : equations_(equations), settings_(settings), scales_(scales) {}

  /// The guard of contact `first` has ended its mode by an impact. Changes velocities and work
  /// integrals in `state`, and the modes of the equations. `time_tolerance`: uncertainty of the
  /// instant [s]. `last`: many impacts have come at this instant already, and this one ends all
  /// relative speeds.
  Outcome resolve(double time, double time_tolerance, std::size_t first, bool last, Vector &state);

  /// The modes of contacts that touch without speed when a motion begins.
  /// Takes what rounding has left of slip rates off the velocities.
  void settle(double time, double time_tolerance, Vector &state);

private:
  struct Instant; // what is known of the contacts that touch

  Instant look(double time, double time_tolerance, std::size_t first, const Vector &state) const;
  bool touches(std::size_t contact, const contact::LocalState &local, double time,
               double time_tolerance, const Vector &state) const;
  void find_impulses(Instant &instant) const;
  void complete_chatter(Instant &instant, const Vector &state);
  double negligible_height(const Instant &instant, std::size_t k) const;
  bool negligible_energy(const Instant &instant, std::size_t k, const Vector &state) const;
  double chatter_duration(const Instant &instant, std::size_t k, const Vector &after);
  void apply(const Instant &instant, Vector &state) const;
  void choose_modes(const Instant &instant, const Vector &state, const std::vector<char> &bouncing);
  void rest_rubbing(const Instant &instant, const Vector &state, const std::vector<Index> &resting);
  double gap_acceleration(std::size_t contact, double time, const Vector &state,
                          int direction = 0) const;
  double leaning(std::size_t contact, double time, const Vector &state, int direction = 0) const;
  void record_struck(const Instant &instant, const std::vector<Index> &struck,
                     Collision &record) const;
  Outcome report(const Instant &instant, std::size_t first) const;

  Equations &equations_;
  const Settings &settings_;
  const ContactScales &scales_;
};

} // namespace vibroimpact::motion
