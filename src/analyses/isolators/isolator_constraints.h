// Which stops an isolator may have, by closed forms in the plane of f and mu
// (isolator_unfolding.h):
//
//   (a) f <= f_max = |1 - lambda_w^2 + 2 i zeta_0 lambda_w|: at the working frequency the stop is
//   not
//       reached
//   (b) mu >= the stiffness that keeps the averaged resonance at the allowed amplitude
//   (c) mu <= that on the hysteresis set H, or at the first fold of the averaged response: the
//       resonance does not jump
//
// The allowed displacement X is fixed and so is the force F; a smaller clearance makes f = F/(k_0
// d) and the allowed amplitude X/d larger, their ratio X k_0/F stays. (b) falls with f, (c) rises:
// the set is a curved triangle, bounded by the clearance (a). With the clearance fixed as well
// there is one f, and (b) and (c) are two numbers.
#pragma once

#include "analyses/isolators/isolator_unfolding.h"

namespace vibroimpact::analyses {

/// Force on the base over the force of the excitation, or displacement of the mass over that of the
/// base: |1 + 2 i zeta_0 lambda|/|1 - lambda^2 + 2 i zeta_0 lambda|.
double transmissibility(double ratio, double damping_ratio);
/// Largest lambda > 1 with the transmissibility T in (0, 1); its approximation without damping is
/// sqrt(1 + 1/T).
double ratio_for_transmissibility(double transmissibility, double damping_ratio);
double undamped_ratio_for_transmissibility(double transmissibility);

/// (a)
double largest_linear_force(double working_ratio, double damping_ratio);

/// (c): mu on H at the force f; NaN where H has no point, which is so below force_where_set_ends().
double stiffness_on_hysteresis_set(double force, const IsolatorDamping &damping, double ratio);
/// f at the end of H, z = 1.
double force_where_set_ends(const IsolatorDamping &damping, double ratio);

/// What says where a jump begins. H is that of the expansion with a lambda chosen beforehand.
enum class JumpLimit { hysteresis_set, averaged_response };

struct StopConditions {
  IsolatorDamping damping;
  double unfolding_ratio = 1; ///< the lambda in alpha_1
  double working_ratio = 0;   ///< lambda_w
  double allowed = 0;         ///< X k_0/F
  double margin = 0;          ///< by which part each condition is to be more than met
  JumpLimit jump_limit = JumpLimit::hysteresis_set;

  /// 1 + margin
  double spare() const { return 1 + margin; }
  /// The three limits with the margin.
  double largest_force() const;
  double least_stiffness(double force) const;
  double largest_stiffness(double force) const;
};

enum class Preference { least_stiffness, largest_clearance };

/// Corners of the set; those that are not there have NaN.
struct StopCorners {
  StopChoice resonance_and_jump;   ///< b and c: the largest clearance
  StopChoice linear_and_resonance; ///< a and b: the softest stop
  StopChoice linear_and_jump;      ///< a and c
};

StopCorners corners_of(const StopConditions &conditions);

/// The corner that is preferred. NumericalError when no stop meets all conditions, or none is
/// needed.
StopChoice preferred_stop(const StopConditions &conditions, const StopCorners &corners,
                          Preference preference);

} // namespace vibroimpact::analyses
