// How far Rayleigh-Ritz values can be from the eigenvalues they stand for.
#pragma once

#include "common/linear_algebra.h"

namespace vibroimpact::modes {

/// Upper bounds of (theta_j - lambda_j) / (lambda_j - shift), quadratic in the residuals, for the
/// Ritz values theta_1 <= ... <= theta_n of a space of n dimensions; no theta_j lies below
/// lambda_j. It holds when exactly n eigenvalues lie below `gap` (infinity: when there are no
/// more), as a count has to show. The shift lies below the spectrum; `residual_products` are
/// R^T A^-1 R with A = K - shift M and R = K X - M X Theta, X^T M X = 1. Infinite where the
/// residuals are too large for the gap.
///
/// With A = L L^T, C = L^-1 M L^-T has the eigenvalues nu = 1 / (lambda - shift). In an orthonormal
/// basis that begins with L^T X it is [T E^T; E B], T = diag(t_j), t_j = 1 / (theta_j - shift),
/// E^T E = T^(3/2) R^T A^-1 R T^(3/2). As C and T have n eigenvalues above g = 1 / (gap - shift)
/// each, the Schur complement B - g - E (T - g)^-1 E^T has none above 0 (Haynsworth's inertia
/// formula): B <= b = g + |(T - g)^(-1/2) E^T E (T - g)^(-1/2)|. The other complement says that
/// nu_j, which is at least t_j, is at most the j-th eigenvalue of T + E^T E / (nu_j - b). By
/// Courant and Fischer that is at most the largest one of its rows and columns from j on, and this,
/// by Ostrowski's theorem, at most t_j (1 + |T^(-1/2) E^T E T^(-1/2)| / (t_j - b)) with the norm of
/// these rows and columns. For one eigenvalue it is the theorem of Kato and Temple; multiple ones
/// need no care (mathias1998).
Vector quadratic_bounds(const Vector &values, double shift, double gap,
                        const Matrix &residual_products);

} // namespace vibroimpact::modes
