// A period in equal intervals, each with the nodes of Gauss's rule, and the harmonic functions
// there.
//
// With 6 nodes the rule is exact for polynomials of degree 11: with intervals of 2 pi / (4 H), half
// a wave of cos(2 H phi), its error is 5e-10. The matrix of the collocation method at the same
// nodes serves what follows a first-order equation along the way (Gauss's implicit Runge-Kutta
// method, A-stable).
#pragma once

#include "common/linear_algebra.h"

namespace vibroimpact::periodic {

class HarmonicGrid {
public:
  static constexpr Index nodes = 6; ///< of an interval

  HarmonicGrid(Index harmonics, Index intervals);

  Index harmonics() const { return harmonics_; }
  Index coefficients() const { return 2 * harmonics_ + 1; }
  Index intervals() const { return intervals_; }
  double length() const; ///< of an interval [rad]
  double begin(Index interval) const { return length() * static_cast<double>(interval); }
  /// 1, cos phi, sin phi... at the nodes of a whole interval: coefficients x nodes.
  auto basis(Index interval) const { return basis_.middleCols(interval * nodes, nodes); }
  /// The same at the nodes of any part of the period.
  Matrix basis(double begin, double end) const;
  /// At the beginning of an interval, or the end of the last one: coefficients.
  auto basis_at(Index interval) const { return ends_.col(interval); }
  /// Derivatives by the phase of values of the harmonic functions, column by column.
  static Matrix rate_of(const Matrix &basis);

  static const Vector &places();      ///< of the nodes in (0, 1)
  static const Vector &weights();     ///< of the integral over (0, 1)
  static const Matrix &collocation(); ///< of the integral up to each node, nodes x nodes

private:
  Index harmonics_, intervals_;
  Matrix basis_, ends_;
};

} // namespace vibroimpact::periodic
