// The lowest eigenpairs up to a gap in the spectrum: found by block Lanczos, freed of the round-off
// of the stiffness matrix, their errors bounded, and counted.
#pragma once

#include "modes/block_lanczos.h"
#include "modes/rayleigh_ritz.h"

namespace vibroimpact::modes {

/// Eigenpairs that are all there are below a gap.
struct CompletePairs {
  Eigenpairs pairs;
  Vector error_bounds; ///< of (value - exact) / (exact - shift); see eigenvalue_bounds.h
};

class ModeSearch {
public:
  /// Collective, as everything here. The matrices outlive this object.
  explicit ModeSearch(const EigenProblem &problem);

  double shift() const { return shift_; }
  /// Largest eigenvalue, estimated: max K_ii / M_ii.
  double largest() const { return largest_; }

  /// From the inertia of K - eigenvalue M.
  int count_below(double eigenvalue);
  /// The lowest pairs up to a gap at or after number `count`. Throws NumericalError.
  CompletePairs lowest(int count);
  /// Made of approximate vectors, M-orthonormal, of the eigenvalues below a gap whose other side is
  /// `found.next`: what is missing among them is found. Throws NumericalError.
  CompletePairs completed(LowestVectors found);

private:
  struct Refined {
    Eigenpairs pairs;
    Vector error_bounds; ///< hold when no eigenvalue is missing
    double gap = 0;      ///< behind the last one
    Vector rounding;     ///< part of the bounds that the rounding of the entries explains
  };

  Refined refined(LowestVectors found);
  Refined complete(Refined found);
  Refined sliced(double gap, int expected);
  Vector rounding_of(const Eigenpairs &pairs) const;
  CompletePairs group(Refined all, int count) const;

  EigenProblem problem_;
  double largest_;
  double shift_;
};

} // namespace vibroimpact::modes
