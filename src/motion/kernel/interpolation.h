// The polynomial of degree 7 through value, slope and curvature at tau = 0 and five more values in
// (0, 1], in Bernstein form.
#pragma once

#include <array>
#include <complex>

namespace vibroimpact::motion {

/// The instants of the five values.
constexpr std::array<double, 5> interpolation_nodes = {0.309854, 0.54232, 0.753004, 0.913377, 1};

/// |f - p| / tau^r <= K_r max|f^(8)| for r = 0, 1, 2: the largest values of
/// tau^(3 - r) |(tau - tau_1) ... (tau - tau_5)| / 8! on [0, 1].
constexpr std::array<double, 3> interpolation_error = {2.371e-9, 1.371e-8, 1.104e-7};

/// Bernstein coefficients (rows) from value, slope, half the curvature and the five values.
using InterpolationMatrix = std::array<std::array<double, 8>, 8>;
const InterpolationMatrix &interpolation_matrix();

/// exp(z tau), 0 <= tau <= 1, as such a polynomial.
struct TabulatedExponential {
  double real[8] = {}, imaginary[8] = {}; ///< Bernstein coefficients
  double largest = 0;                     ///< bound of their magnitudes
  std::complex<double> end;               ///< exp(z)
  double growth = 1;                      ///< largest magnitude of exp(z tau), at most exp(600)
  double eighth = 0;                      ///< |z|^8

  explicit TabulatedExponential(std::complex<double> z);
};

} // namespace vibroimpact::motion
