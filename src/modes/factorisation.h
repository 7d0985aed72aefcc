// K - shift M, factorised by MUMPS as L D L^T: solutions, and the number of eigenvalues below the
// shift from the signs of D (Sylvester's law of inertia).
#pragma once

#include "modes/vector_block.h"

#include <utility>

namespace vibroimpact::modes {

class Factorisation {
public:
  /// Collective. Both matrices are symmetric and have the same pattern of entries. Throws
  /// NumericalError when MUMPS fails.
  Factorisation(Mat stiffness, Mat mass, double shift);
  /// Takes over what MUMPS has made for somebody else.
  explicit Factorisation(structure::petsc::Matrix factor) : factor_(std::move(factor)) {}

  /// (K - shift M)^-1 x for all columns of x. Collective.
  Block solve(Block x) const;
  /// Number of eigenvalues below the shift.
  int eigenvalues_below() const;

private:
  structure::petsc::Matrix factor_;
};

/// Makes `solver` a direct one: MUMPS, symmetric indefinite.
void use_mumps(KSP solver);

/// What such a solver has factorised; it outlives the solver.
Factorisation factorisation_of(KSP solver);

} // namespace vibroimpact::modes
