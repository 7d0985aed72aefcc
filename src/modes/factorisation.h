// K - shift M, factorised by MUMPS as L D L^T: solutions, and the number of eigenvalues below the
// shift from the signs of D (Sylvester's law of inertia).
#pragma once

#include "modes/vector_block.h"

#include <optional>

namespace vibroimpact::modes {

class Factorisation {
public:
  /// Collective. Both matrices are symmetric, have the same pattern of entries and outlive this
  /// object. Throws NumericalError when MUMPS fails.
  Factorisation(Mat stiffness, Mat mass, double shift);

  /// Factorises with another shift: the order of elimination and the memory are those there are.
  /// Collective. Throws NumericalError.
  void shift_to(double shift);
  double shift() const { return shift_; }

  /// (K - shift M)^-1 x for all columns of x. Collective.
  Block solve(Block x) const;
  /// Number of eigenvalues below the shift.
  int eigenvalues_below() const;

private:
  Mat stiffness_;
  Mat mass_;
  double shift_;
  structure::petsc::Matrix factor_;
};

/// The one factorisation of K - shift M that there is at a time: they are what takes the memory.
class FactorisedPencil {
public:
  /// Made when first asked for, made anew where the shift is another one. Collective.
  const Factorisation &at(Mat stiffness, Mat mass, double shift);
  void release() { factorisation_.reset(); }

private:
  std::optional<Factorisation> factorisation_;
};

} // namespace vibroimpact::modes
