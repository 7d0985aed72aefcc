// Where a guard of a contact with friction leads to.
//
// That depends on more than the guard: where friction begins, on the slip rate; where the sides are
// to stick, on the force that this takes (event/mode_change.h). All of it follows from the modes
// before and after: which ways there are, what becomes of the state on each of them, and the forms
// of the state before the change that tell which one is taken. It is made once for a guard of a
// phase; at an instant only products with the amplitudes are left.
//
// Where sides are to stick, the velocities lose what is left of the slip rates,
//   v -= M^-1 W^T (W M^-1 W^T)^-1 W v,
// and the guards of stick are forms of what is left. A guard of stick that is below zero leads on
// to slip, and the two changes are one.
#pragma once

#include "motion/phase/amplitude_forms.h"
#include "motion/phase/exact_phases.h"

#include <array>
#include <optional>
#include <vector>

namespace vibroimpact::motion {

class FrictionRoutes {
public:
  struct Route {
    int mode = 0;                          ///< behind it
    std::vector<PhaseForms::Reset> resets; ///< what becomes of the state, from that before
  };

  /// Of a guard of a phase. The equations must be in the modes of the phase, and are left so.
  FrictionRoutes(Equations &equations, const LinearPhase &from, const ExactPhase &phase,
                 std::size_t guard);

  /// Takes over the present inputs of the phase.
  void renew() { forms_.renew(); }
  const Route &route(std::size_t k) const { return ways_.routes[k]; }
  /// Which one is taken, by the amplitudes at the guard, each known to `rounding`, by groups.
  std::size_t choose(const double *amplitudes, const double *rounding);
  std::size_t bytes() const { return forms_.bytes(); }

private:
  /// What leads on from a mode that holds the slip rate.
  struct Stick {
    std::size_t to = 0;                                ///< route
    std::optional<std::size_t> slides{};               ///< form: the slip acceleration imposed
    std::size_t slide_backward = 0, slide_forward = 0; ///< routes
    std::size_t first_guard = 0;                       ///< form
    std::vector<std::size_t> behind_guards{};          ///< routes
  };
  struct Ways {
    std::vector<Route> routes{};
    std::vector<LinearRow> forms{};
    std::optional<Stick> stick{};
    /// Routes by the slip rate where friction begins: backward, none, forward; the form of it.
    std::array<std::size_t, 3> by_slip{};
    std::optional<std::size_t> slip_rate{};
  };
  class Finder;

  std::size_t first_route() const;
  std::size_t lead_on() const;

  Ways ways_;
  AmplitudeForms forms_;
};

} // namespace vibroimpact::motion
