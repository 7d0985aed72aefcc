// Curves of special points in two keys: folds, flips, Neimark-Sacker points, grazes.
//
// F(x, p) = 0 is extended by one scalar equation g(x, p) = 0. For folds and flips g comes of the
// bordered system [[J -+ I, b], [c^T, 0]] (v, g) = (0, 1), whose matrix is regular where J -+ I has
// one null vector (W. Govaerts, Numerical methods for bifurcations of dynamical equilibria, 2000,
// chapter 3).
#pragma once

#include "continuation/branch.h"

namespace vibroimpact::continuation {

enum class LocusKind { fold, flip, neimark_sacker, graze };

struct LocusStart {
  LocusKind kind = LocusKind::fold;
  Point point;                ///< with both keys, at the special point of a branch
  std::optional<Graze> graze; ///< of a locus of grazes
  bool forward = true;        ///< the second key grows at first
};

struct LocusPoint {
  Point point;
  Vector tangent;      ///< scaled, of length 1, n + 2
  double residual = 0; ///< of F and g, scaled
  Vector defect;       ///< F, n
  Matrix by_state;     ///< dF/dx, n x n; at grazes of F without the touch
  Pattern pattern;
  double angle = 0; ///< Neimark-Sacker: argument of the multiplier [rad]
  /// 1 or -1: on which side, by the first key, two solutions meet that the fold ends, the
  /// multiplier is outside the unit circle, or the guard touches. 0 where the curve turns in it.
  int side = 0;
  double arclength = 0; ///< from the start, scaled
};

enum class LocusSpecial {
  cusp,         ///< of folds: two of them meet
  ends_at_graze ///< the multiplier behind the graze is 1 or -1 on the grazing curve
};

struct SpecialLocusPoint {
  LocusSpecial kind;
  LocusPoint at;
  std::size_t after = 0; ///< index of the locus' point before it
};

using Locus = Curve<LocusPoint, SpecialLocusPoint>;

/// `problem` has two keys. The record is as for follow().
Locus follow_locus(Problem &problem, const LocusStart &start, const Settings &settings,
                   const CurveListener<Locus> &listener = {}, StepRecord *record = nullptr);

} // namespace vibroimpact::continuation
