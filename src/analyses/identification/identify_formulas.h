// Restitution, approach speed and damping factor of an impact from its force history alone.
//
// Two bodies meet with F = k u^n (1 + (mu/k) u'); u is the penetration. Other forces do nothing
// while the contact lasts, so that u'' = -lambda F, lambda being the compliance of the contact: one
// over the mass that meets there. Of the force history two figures are used, the impulse J and the
// largest force f_m, in one dimensionless ratio:
//
//   gamma = 8 k (f_m / k)^((n+1)/n) / ((n+1) J^2 lambda)
//
//   J lambda = (1 + e) v_c               momentum: the approach speed once e is known
//   e = e(gamma)                         depends on the set of formulas
//   mu = k d_c(e) / v_c                  likewise
//
// Sets of formulas; L = lambda in units of length/(force time^2), see Scales:
//   printed     e = 2/(L + sqrt(L^2 - 2 L + gamma)) - 1,    d_c = 3/4 (1 - e^2)
//   corrected   e = 2/(1 + sqrt(gamma - 1)) - 1,            d_c = 3/4 (1 - e^2)
//   exact       gamma(e) of two free bodies solved for e,   (1 + e) d_c = ln[(1 + d_c)/(1 - e d_c)]
//
// `printed` has a factor lambda too many in its energy balance and so depends on the units; it
// equals `corrected` for L = 1. Both take f_m = k u_m^n, as if the largest force and the deepest
// penetration coincided, and therefore see too much damping: 1 - e comes out 2.4 times too large as
// e approaches 1 (n = 3/2). Formulas are evaluated as they stand, so that these two can give e < 0.
#pragma once

#include <array>

namespace vibroimpact::analyses {

/// What a force transducer shows of one impact.
struct PulseFigures {
  double impulse = 0;    ///< J [N s]
  double peak_force = 0; ///< f_m [N]
};

/// What must be known of the contact beforehand.
struct ContactConstants {
  double compliance = 0; ///< lambda [1/kg]
  double stiffness = 0;  ///< k [N/m^n]
  double exponent = 1.5; ///< n
};

/// Units in which the printed formulas are evaluated; 1 is SI.
struct Scales {
  double length = 1; ///< [m]
  double time = 1;   ///< [s]
  double force = 1;  ///< [N]

  /// lambda force time^2 / length
  double dimensionless(double compliance) const {
    return compliance * force * time * time / length;
  }
};

/// Relative half-widths of the intervals in which the true values lie.
struct Uncertainties {
  double impulse = 0, peak_force = 0, compliance = 0, stiffness = 0;
};

struct Identified {
  double restitution = 0;    ///< e; NaN where the formulas have no solution
  double approach_speed = 0; ///< v_c [m/s]
  double damping_factor = 0; ///< mu [N s/m^(n+1)]
};

/// lowest and highest restitution that the uncertainties allow
struct Interval {
  double low = 0, high = 0;
};

/// One of the three sets.
struct FormulaSet {
  const char *name;
  /// e(gamma); below lowest_ratio NaN, at it the largest e the formulas can give.
  double (*restitution)(double ratio, double scaled_compliance, double exponent);
  double (*lowest_ratio)(double scaled_compliance);
  /// d_c(e)
  double (*dimensionless_damping)(double restitution);
};

inline constexpr std::size_t n_formula_sets = 3;
const std::array<FormulaSet, n_formula_sets> &formula_sets();

/// gamma of a pulse; NaN for a pulse without impulse.
double pulse_ratio(const PulseFigures &pulse, const ContactConstants &contact);

/// gamma that two free bodies show, from 1 at e = 1 upwards; e in (0, 1].
double free_collision_ratio(double restitution, double exponent);
/// Its inverse: NaN for gamma < 1, 0 where e would be below 1e-6.
double free_collision_restitution(double ratio, double exponent);

Identified identify(const FormulaSet &set, const PulseFigures &pulse,
                    const ContactConstants &contact, const Scales &scales);

/// Extremes of e over all corners of the uncertainties. Where a corner has no solution because
/// gamma falls below its lowest value, the interval reaches the largest e of the formulas. NaN when
/// no corner has a solution: then this was no impact of two free bodies.
Interval restitution_interval(const FormulaSet &set, const PulseFigures &pulse,
                              const ContactConstants &contact, const Scales &scales,
                              const Uncertainties &uncertainties);

} // namespace vibroimpact::analyses
