// Eigenvalues of a dense symmetric matrix with a high relative accuracy of the small ones.
#pragma once

#include "common/linear_algebra.h"

namespace vibroimpact::modes {

struct DenseEigenpairs {
  Vector values;  ///< ascending
  Matrix vectors; ///< orthonormal columns
};

/// Cyclic Jacobi rotations until |a_ij| <= eps sqrt(|a_ii a_jj|). Unlike the QR algorithm, whose
/// error is relative to the largest eigenvalue, it keeps each eigenvalue of a graded positive
/// definite matrix to nearly full precision (Demmel and Veselic, SIAM J. Matrix Anal. Appl. 13
/// (1992) 1204). Off-diagonal entries count as zero when also below eps `floor`.
DenseEigenpairs relative_jacobi(Matrix a, double floor);

} // namespace vibroimpact::modes
