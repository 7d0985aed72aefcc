// The velocities of a body right after an impulse.
#pragma once

#include "modes/vector_block.h"

namespace vibroimpact::modes {

/// The diagonal of a matrix, this rank's rows.
Vector own_diagonal(Mat matrix);
/// All rows on every rank. Collective.
Vector diagonal(Mat matrix);

/// v with M v = impulse for each column, rows as in the matrix, the same on every rank. A degree of
/// freedom without mass (zero on the diagonal, and so in its row) has no velocity of its own: its
/// impulse must be zero, and so is its velocity. Collective. Throws NumericalError when MUMPS
/// fails.
Matrix impulse_response(Mat mass, const Matrix &impulses);

/// Eigenvalues of a mass matrix, made dimensionless by its diagonal, that count as zero or are
/// negative, besides those of rows without mass. Elements with reduced integration leave zeros.
struct MassSigns {
  int zero = 0;
  int negative = 0;
};

/// From the inertia of M -+ 1e-10 diag(M). Collective. Throws NumericalError when MUMPS fails.
MassSigns mass_signs(Mat mass);

} // namespace vibroimpact::modes
