// One system integrated by two programs: how close they come, at which tolerance, at what cost.
#pragma once

#include "common/linear_algebra.h"

#include <functional>
#include <string>
#include <vector>

namespace vibroimpact::benchmarks {

/// What a motion ended with and what it took.
struct Outcome {
  Vector state;         ///< q, v at the end
  long steps = 0;       ///< accepted
  long rejected = 0;    ///< for the error control alone
  long impacts = 0;     ///< contacts begun
  long evaluations = 0; ///< of the right-hand side; 0 when the motion was not made to count them
};

struct Tolerance {
  double relative = 0;
  double absolute = 0; ///< of displacements [m]
};

/// Integrates the whole motion from its beginning; every call does the same.
using Motion = std::function<Outcome()>;

struct Side {
  std::string name;
  /// Sets a motion up. One that counts evaluations is not for timing.
  std::function<Motion(const Tolerance &tolerance, bool counts_evaluations)> prepare;
};

struct Case {
  std::string name;
  double length = 0; ///< displacement the absolute tolerances refer to [m]
  Vector weight;     ///< twice the energy per squared entry of the state: stiffness, then mass
  Side vibroimpact;
  Side odeint;
};

/// Energy norm of a difference over that of the reference.
double relative_error(const Vector &weight, const Vector &state, const Vector &reference);

/// The cheapest setting of a side that reaches an error.
struct Setting {
  Tolerance tolerance;
  double error = 0;
  Outcome outcome; ///< with evaluations
};

struct SideResult {
  Setting setting;
  double seconds = 0; ///< median CPU time of one motion
};

struct CaseResult {
  double disagreement = 0; ///< of the two sides at the tightest tolerance
  SideResult vibroimpact;
  SideResult odeint;
  double ratio = 0; ///< median over the pairs of vibroimpact's time to odeint's
  double ratio_lower_quartile = 0;
  double ratio_upper_quartile = 0;
};

/// Throws NumericalError when the two sides disagree beyond a tenth of `target`, find different
/// numbers of impacts, or one of them does not reach the target.
CaseResult measure(const Case &system, double target, int repetitions);

} // namespace vibroimpact::benchmarks
