// A branch of solutions of F(x, p) = 0 followed by pseudo-arclength, with its special points.
//
// With scaled unknowns u = (x / s_x, p / s_p), a step from u along the unit tangent t is corrected
// on the hyperplane t . (v - u) = ds, which passes folds: there t_p = 0 while the bordered matrix
// [F_x F_p; t] stays regular (H. B. Keller, Numerical solution of bifurcation and nonlinear
// eigenvalue problems, 1977).
#pragma once

#include "common/step_record.h"
#include "continuation/curve.h"
#include "continuation/problem.h"
#include "continuation/settings.h"

#include <complex>
#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::continuation {

struct BranchPoint {
  Point point;
  Vector tangent;      ///< scaled, of length 1, n + 1; the last one is that of the key
  double residual = 0; ///< length of the scaled F
  Pattern pattern;
  std::vector<std::complex<double>> multipliers; ///< of a map, by falling modulus
  int unstable = 0;                              ///< multipliers outside the unit circle
  double arclength = 0;                          ///< from the start, scaled
};

enum class Special {
  fold,           ///< turning point of the key; a multiplier of 1
  branch_point,   ///< another branch crosses; a multiplier of 1
  flip,           ///< a multiplier of -1: period doubling, or loss of symmetry of a half-period map
  neimark_sacker, ///< a complex pair of multipliers of modulus 1
  graze,          ///< the least value of a guard is zero
  grazing_fold,   ///< the same, and the key turns there
  pattern_change  ///< the pattern changes without a graze that could be located; at its end
};
std::string name_of(Special kind);

struct SpecialPoint {
  Special kind;
  BranchPoint at;
  std::size_t after = 0; ///< index of the branch's point before it
  /// Fold, branch point: x of the null vector of dF/dx; flip: eigenvector of -1; Neimark-Sacker:
  /// real and imaginary part of that of the pair (n x 2). Scaled, of length 1. Grazes: none.
  Matrix vector;
  /// d(multiplier)/d(key) along the branch, of the one that crosses; modulus for Neimark-Sacker.
  /// Flat crossings are ill-conditioned: an error e of the multiplier moves the key by e over this.
  /// Flip and Neimark-Sacker only.
  double slope = 0;
  double angle = 0; ///< Neimark-Sacker: argument of the multiplier [rad]
  double width = 0; ///< change of pattern: of the key, on which it lies somewhere before the point
  std::optional<Graze> graze;
  int unstable_before = 0,
      unstable_after = 0; ///< multipliers outside the unit circle, at the sides
};

using Branch = Curve<BranchPoint, SpecialPoint>;

struct Start {
  Point point;
  /// Scaled, n + 1, whatever length. Empty: the direction in which the key grows if `forward`.
  Vector direction;
  bool forward = true;
};

/// Newton's method at fixed keys. NumericalError when it does not converge; `furthest` bounds each
/// correction, scaled.
BranchPoint solve(Problem &problem, const Point &guess, const Settings &settings,
                  double furthest = 0.5);

/// From a start that solve() has made, or branch_from(). A start outside the bounds ends at once.
/// What the steps gave is stored in the record, or taken from it.
Branch follow(Problem &problem, const Start &start, const Settings &settings,
              const CurveListener<Branch> &listener = {}, StepRecord *record = nullptr);

/// First point of the branch of `doubled` that begins at a flip of the map whose square it is, at
/// the distance settings.switch_distance. NumericalError when Newton's method falls back or fails.
Start branch_from(Problem &doubled, const SpecialPoint &flip, const Settings &settings);

} // namespace vibroimpact::continuation
