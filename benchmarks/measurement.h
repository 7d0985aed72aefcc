// One system integrated by several programs: how near they come, at which tolerance, at what cost.
#pragma once

#include "common/linear_algebra.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::benchmarks {

/// What a motion showed and what it took.
struct Outcome {
  double excursion = 0; ///< largest less smallest recorded displacement [m]; 0: not recorded
  std::vector<long> contacts{}; ///< begun, per contact; empty: not counted
  long steps = 0;               ///< accepted
  long evaluations = 0;         ///< of the right-hand side; 0: none, or not counted
};

struct Tolerance {
  double relative = 0;
  double absolute = 0; ///< of displacements [m]
};

/// Integrates the whole motion from its beginning; every call does the same.
using Motion = std::function<Outcome()>;

struct Side {
  std::string name;
  /// Sets a motion up; an empty function: this program is not there.
  std::function<Motion(const Tolerance &tolerance, bool records)> prepare;
  bool exact = false; ///< has no tolerance
};

struct Case {
  std::string name;
  double length = 0; ///< displacement the absolute tolerances refer to [m]
  long periods = 0;  ///< of the forcing, in one motion
  std::vector<Side> sides;
  std::size_t baseline = 0;            ///< the side others are compared with
  std::vector<std::size_t> references; ///< two sides whose tightest runs must agree
};

/// The loosest tolerance of a side that reaches an error.
struct Setting {
  Tolerance tolerance;
  double error = 0; ///< of the excursion, relative
  Outcome outcome;
};

struct Spread {
  double median = 0, lower_quartile = 0, upper_quartile = 0;
};

struct SideResult {
  std::optional<Setting> setting; ///< none: not there, or the error is not reached
  Spread recorded, unrecorded;    ///< CPU time of one motion [s]
  Spread speed;                   ///< times as fast as the baseline, both recording
};

struct CaseResult {
  double disagreement = 0; ///< of the two references, relative
  std::vector<SideResult> sides;
};

/// Processor time of this process [s].
double cpu_time_of(const std::function<void()> &work);

/// Throws NumericalError when the references disagree beyond a tenth of `target`, or a side that is
/// there does not reach the target with as many contacts as they count.
CaseResult measure(const Case &system, double target, int repetitions);

} // namespace vibroimpact::benchmarks
