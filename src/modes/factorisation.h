// K - shift M, factorised by MUMPS as L D L^T: solutions, and the number of eigenvalues below the
// shift from the signs of D (Sylvester's law of inertia).
#pragma once

#include "modes/vector_block.h"

namespace vibroimpact::modes {

class Factorisation {
public:
  /// Collective. Both matrices are symmetric and have the same pattern of entries.
  Factorisation(Mat stiffness, Mat mass, double shift);

  /// (K - shift M)^-1 x for all columns of x. Collective. Throws NumericalError when MUMPS fails.
  Block solve(Block x) const;
  /// Number of eigenvalues below the shift.
  int eigenvalues_below() const;

private:
  petsc::Matrix matrix_;
  petsc::Solver solver_;
};

/// Makes `solver` a direct one: MUMPS, symmetric indefinite.
void use_mumps(KSP solver);

} // namespace vibroimpact::modes
