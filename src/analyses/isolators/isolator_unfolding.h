// The plane of the unfolding parameters of an isolator with a damped elastic stop on both sides.
//
//   y'' + h(y') + g(y) = f sin(lambda t)      y over the clearance, t times the natural frequency
//   g = y,  h = 2 zeta_0 y'                                        |y| <= 1
//   g = (1 + mu) y - mu sgn y,  h = 2 (zeta_0 + zeta_1) y'         |y| > 1
//
// Averaging (isolator_averaging.h) with its equation expanded to third order in z = 1/a, where a is
// the amplitude, leaves the bifurcation equation
//
//   G = [u(z) + eta]^2 + alpha_1^2 (1 - rho z) + alpha_2 z^2 = 0,    u = z - z^3/6
//   alpha_1 = pi lambda zeta_1 (1 + sigma) / (2 mu)       eta = pi/4 ((lambda^2 - 1)/mu - 1)
//   alpha_2 = (rho alpha_1 / 2)^2 - (pi f / (4 mu))^2
//   rho = 8 / (pi (1 + sigma)),  sigma = zeta_0 / zeta_1
//
// alpha_1 holds lambda, which is therefore a number that is chosen beforehand; eta is what varies
// along a response curve. The curve changes its shape where (alpha_1, alpha_2) crosses one of
//
//   B2     G = G_z = G_eta = 0: alpha_2 = (rho alpha_1 / 2)^2, where f = 0; nothing lies above
//   B3+-   G = G_z = 0 at z = 1: a fold where the stop is first reached
//   H      G = G_z = G_zz = 0: two folds meet in a cusp
//
// (B1 is alpha_1 = 0: no damping, or a rigid stop.) The expansion is one for z << 1. It takes u' =
// 1/2 at z = 1, where the averaged equation has 0: B3, and with it what tells I and II from III and
// IV, is of the expansion, not of the isolator.
//
// Source: stopdesign and golubitsky1985 in docs/references.bib; the derivation is in
// docs/theory.md.
#pragma once

#include <string>

namespace vibroimpact::analyses {

/// Fractions of critical damping, both of the isolator's mass and spring.
struct IsolatorDamping {
  double isolator = 0; ///< zeta_0 >= 0
  double stop = 0;     ///< zeta_1 > 0

  double sigma() const { return isolator / stop; }
  double rho() const;
};

/// sigma below which the plane is as described here, 4/pi - 1: above it rho < 2, B3+ and B3- meet
/// in a point, and the damping of the expansion vanishes at no amplitude that reaches the stop.
extern const double largest_damping_ratio;

/// What is chosen of a stop.
struct StopChoice {
  double stiffness = 0; ///< mu > 0, over that of the isolator
  double force = 0; ///< f > 0: static displacement under the force's amplitude over the clearance
};

struct UnfoldingParameters {
  double first = 0;  ///< alpha_1 > 0
  double second = 0; ///< alpha_2
};

/// `ratio`: the lambda in alpha_1.
UnfoldingParameters unfolding_of(const StopChoice &stop, const IsolatorDamping &damping,
                                 double ratio);
/// The inverse; f is NaN above B2.
StopChoice stop_of(const UnfoldingParameters &at, const IsolatorDamping &damping, double ratio);

/// alpha_2 on the bifurcation sets at alpha_1; rho >= 2.
double set_b2(double first, double rho);
double set_b3_plus(double first, double rho);
double set_b3_minus(double first, double rho);

/// A point of the hysteresis set.
struct HysteresisPoint {
  double z = 0; ///< of the cusp
  UnfoldingParameters at;
  double eta = 0; ///< of the cusp
};

/// z in (0, 1]; at z = 1 it lies on B3-.
HysteresisPoint hysteresis_set(double z, double rho);

/// The point of H with this alpha_1, which grows with z. std::domain_error beyond both its ends.
HysteresisPoint hysteresis_above(double first, double rho);

enum class Region { none, one, two, three, four };
/// "none", "I", ... "IV"
std::string name_of(Region region);

/// none: above B2. I: from there to B3+. II: to B3-. III: below it, left of H. IV: the rest
/// and H.
Region region_of(const UnfoldingParameters &at, double rho);

/// Folds of the response curve for 0 < z < 1: 2 in I, one of them on the side of low frequencies; 1
/// in II, the jump back being at the first touch; 2 in III; 0 in IV and where there is no curve.
int folds_in(Region region);

/// A point of a region, on the vertical line in the middle of H: half its largest alpha_1.
UnfoldingParameters example_of(Region region, double rho);

} // namespace vibroimpact::analyses
