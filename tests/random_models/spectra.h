// Are the multipliers of two matrices the same, as far as multipliers are determined?
#pragma once

#include "common/linear_algebra.h"

#include <Eigen/Core>

#include <string>

namespace vibroimpact::testing {

/// Verdicts:
///   equal                   to 1e-7 of the largest multiplier
///   equal as a polynomial   not one by one, but the polynomials that they are the zeros of agree
///                           to 1e-7 on the circle of twice the spectral radius: equal or nearly
///                           equal multipliers with one eigenvector move by roots of a change of
///                           the matrix, their polynomial by the change itself
///   equal but for rounding  within the bound of Bauer and Fike (1960), cond(V) |A - B|, of the
///                           difference of the matrices themselves
///   different
struct SpectraVerdict {
  std::string word;
  double apart = 0;      ///< largest distance over the largest multiplier
  double polynomial = 0; ///< relative, on the circle
  double bound = 0;      ///< of Bauer and Fike, over the largest multiplier
};

/// `own`: multipliers of `a`; they are compared with the eigenvalues of `b`. Both matrices in
/// comparable coordinates.
SpectraVerdict compare_spectra(const Eigen::VectorXcd &own, const Matrix &a, const Matrix &b);

} // namespace vibroimpact::testing
