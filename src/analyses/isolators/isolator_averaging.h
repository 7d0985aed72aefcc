// The averaged primary resonance of the isolator of isolator_unfolding.h.
//
// y = a cos(lambda t + phi) with slowly varying a and phi leaves, for a > 1 and z = 1/a,
//
//   (P - lambda^2)^2 + 4 Q^2 lambda^2 = f^2 z^2
//   P = 1 + mu (1 - 4 S/pi),  Q = zeta_0 + zeta_1 (1 - 4 S/pi),  S = (arcsin z + z sqrt(1 - z^2))/2
//
// a quadratic equation for lambda^2 with the two roots P - 2 Q^2 -+ sqrt(E), the sides of the
// response curve, and E = f^2 z^2 - 4 Q^2 (P - Q^2). They meet at the largest amplitude, E = 0. As
// S' = sqrt(1 - z^2) is 0 at z = 1, the curve goes on smoothly where the stop is first reached and
// folds come in pairs. 1 - 4 S/pi is the share of stop in stiffness and damping, 0 at z = 1.
#pragma once

#include "analyses/isolators/isolator_unfolding.h"

#include <array>
#include <vector>

namespace vibroimpact::analyses {

/// A point of an averaged response curve; the stop is reached there.
struct AveragedPoint {
  double z = 0;     ///< 1/a in (0, 1]
  double ratio = 0; ///< lambda; NaN where there is no such motion
};

/// Amplitude, over the clearance, and frequency ratio of the largest response.
struct ResponsePeak {
  double amplitude = 0;
  double ratio = 0;
};

class AveragedResponse {
public:
  AveragedResponse(const IsolatorDamping &damping, const StopChoice &stop);

  /// Whether any motion of the curve reaches the stop.
  bool reaches_stop() const { return least_z_ < 1; }
  /// 1/a of the largest amplitude, where the stop is reached; 1 where it is not.
  double least_z() const { return least_z_; }
  /// lambda on both sides of the curve, the lower one first.
  std::array<double, 2> ratios(double z) const;
  /// Where the curve turns, by lambda.
  std::vector<AveragedPoint> folds() const;
  /// Infinite amplitude without damping and contact.
  ResponsePeak peak() const;

private:
  /// The share of the stop, P and Q, and derivatives by z.
  struct Terms;
  Terms terms(double z) const;
  double discriminant(double z) const;
  double turning(double z, double side) const;
  void add_folds(double side, std::vector<AveragedPoint> &folds) const;

  IsolatorDamping damping_;
  StopChoice stop_;
  double least_z_ = 1;
};

/// Least mu with which the largest amplitude at the force f is `amplitude` > 1 clearances: from E =
/// 0, mu (1 - 4 S/pi) = f^2 z^2/(4 Q^2) - 1 + Q^2. Negative where the dashpot alone keeps it below.
double stiffness_for_peak(double force, double amplitude, const IsolatorDamping &damping);

/// Largest mu up to which the averaged curve does not fold at the force f: that of the cusp. NaN
/// where that is above 1e4.
double stiffness_of_first_jump(double force, const IsolatorDamping &damping);

} // namespace vibroimpact::analyses
