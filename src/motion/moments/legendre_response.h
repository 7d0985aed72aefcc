// What a force that is a Legendre polynomial over a step makes of a coordinate with one exponent.
//
//   J_k(z, x) = integral from 0 to x of exp(z (x - s)) P_k(2 s - 1) ds
//
// with z the exponent times the length of the step and x in [0, 1] the part of it that is over.
// Integration by parts of (2 k + 1) P_k = (P_{k+1} - P_{k-1})' gives
//
//   J_{k+1} = J_{k-1} + (2 (2 k + 1) J_k - P_{k+1}(2 x - 1) + P_{k-1}(2 x - 1)) / z,
//
// which multiplies errors by 1680 / |z|^4 up to k = 4: good for |z| >= 4. Below, J_k is the sum of
// its monomials, the integral of exp(z (x - s)) s^p being p! x^(p+1) phi_{p+1}(z x) with
// phi_p(w) = 1 / p! + w phi_{p+1}(w), from a series for the last one.
#pragma once

#include "motion/phase/modal_form.h"

#include <array>

namespace vibroimpact::motion {

/// Polynomials that a force has in a step: degrees below that.
constexpr int n_moments = 4;
/// One more, by which the part is estimated that the force lacks.
constexpr int n_responses = n_moments + 1;

using LegendreResponses = std::array<Complex, n_responses>;

LegendreResponses legendre_responses(Complex z, double x);

/// P_0, P_1 ... of 2 x - 1.
std::array<double, n_responses> shifted_legendre(double x);

/// The same for a matrix: entry k is J_k(Z, x).
std::array<Matrix, n_responses> legendre_responses(const Matrix &z, double x);

} // namespace vibroimpact::motion
