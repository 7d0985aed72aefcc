// Real Fourier series x(phi) = a_0 + sum_h a_h cos(h phi) + b_h sin(h phi) as rows of 2 H + 1
// coefficients: a_0, a_1, b_1, a_2...
#pragma once

#include "common/linear_algebra.h"

namespace vibroimpact::continuation {

/// Of a row with that many coefficients. std::logic_error when they are not 2 H + 1.
Index harmonics_of(Index coefficients);
/// 1, cos phi, sin phi, cos 2 phi...: 2 H + 1.
Vector harmonic_basis(double phase, Index harmonics);
/// x(phi) = series . basis is projected back by integrals over a period of x times these: 1 / (2
/// pi) for the constant, basis / pi for the others.
Vector harmonic_projection(const Vector &basis);
/// The series of dx/dphi is series * rate, (2 H + 1) x (2 H + 1).
Matrix harmonic_rate(Index harmonics);
/// The same series with more coefficients, which are zero; rows are series.
Matrix with_harmonics(const Matrix &series, Index harmonics);
/// Amplitude of each harmonic, H + 1: |a_0|, sqrt(a_h^2 + b_h^2).
Vector harmonic_amplitudes(const RowVector &series);

struct SeriesRange {
  double minimum = 0, maximum = 0;
};
/// Extreme values over a period, to rounding unless two extrema lie within 1/16 of the shortest
/// wave.
SeriesRange range_of(const RowVector &series);

} // namespace vibroimpact::continuation
