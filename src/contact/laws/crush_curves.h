// Loading and unloading curve of a stop that crushes, by its residual penetration.
//
// Between the curves the force is elastic, F = K (u - p), with the unloading stiffness K and the
// residual penetration p, at which the sides would part on that line. On a curve f(u) with slopes
// below K, p = u - f(u) / K grows with u, so that u is a function of p, as piecewise linear as f.
// The intervals are those of p within which both curves are straight.
#pragma once

#include "contact/laws/force_curve.h"

#include <limits>
#include <optional>
#include <vector>

namespace vibroimpact::contact {

/// A curve within one interval.
struct CrushSide {
  std::size_t segment = 0;
  double at_zero = 0, slope = 0; ///< u = at_zero + slope p on it [m, 1]
  double intercept = 0;          ///< F = intercept + stiffness u on it [N]
  double stiffness = 0;          ///< [N/m]

  double penetration(double residual) const { return at_zero + slope * residual; }
  double force(double penetration) const { return intercept + stiffness * penetration; }
  /// dp/du along the curve.
  double residual_rate() const { return 1 / slope; }
  bool no_force() const { return intercept == 0 && stiffness == 0; }
};

/// From `begin` on to the next interval's.
struct CrushInterval {
  double begin = 0;           ///< of p [m]
  double loading_begin = 0;   ///< u on the loading curve there [m]
  double unloading_begin = 0; ///< u on the unloading curve there [m]
  CrushSide loading, unloading;
};

class CrushCurves {
public:
  /// Both curves begin at (0, 0). Without an unloading curve the force falls along the line down to
  /// zero, where the sides part. unloading_stiffness > all slopes [N/m]; that of the first segment
  /// of the loading curve may be the same: up to its end the stop is elastic. std::invalid_argument
  /// otherwise, and where the unloading curve is not below the loading curve.
  CrushCurves(const ForceCurve &loading, const std::optional<ForceCurve> &unloading,
              double unloading_stiffness);

  /// Is a slope that of unloading, but for rounding?
  static bool is_elastic(double slope, double unloading_stiffness);

  double stiffness() const { return stiffness_; }
  const std::vector<CrushInterval> &intervals() const { return intervals_; }
  /// Is the first segment elastic?
  bool yields_later() const { return yields_later_; }
  /// Interval of a residual penetration.
  std::size_t interval(double residual) const;
  /// Energy that the stop gives back from a place on the line of an interval [J].
  double recoverable(std::size_t interval, double residual, double penetration) const;
  /// The same from a place on the unloading curve.
  double recoverable_below(std::size_t interval, double penetration) const;

private:
  double stiffness_;
  bool yields_later_;
  ForceCurve unloading_;
  std::vector<CrushInterval> intervals_;
};

} // namespace vibroimpact::contact
