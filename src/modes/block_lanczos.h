// Approximate eigenvectors of K phi = lambda M phi by the block Lanczos method with
// shift-and-invert (grimes1994): MUMPS solves for six vectors at once, in a third of the time
// that six single solutions take.
#pragma once

#include "modes/factorisation.h"

namespace vibroimpact::modes {

/// Neighbours among the eigenvalues lambda - shift that are closer than this, relative, are not
/// separated.
inline constexpr double least_relative_gap = 1e-6;

/// Ritz vectors of the lowest eigenvalues, up to a gap in the spectrum.
struct LowestVectors {
  Block vectors; ///< M-orthonormal, of ascending eigenvalues
  /// The eigenvalue behind the gap, as far as it is known: its relative distance from the others is
  /// ten times its error at least. Infinity when the vectors are as many as there are finite
  /// eigenvalues.
  double next = 0;
};

/// Vectors of at least `count` eigenvalues above the shift of `shifted`, which must lie below the
/// spectrum; `mass_rank` finite ones there are. With `known` M-orthonormal Ritz vectors the search
/// goes on in what they leave out, from a start orthogonal to them. The start is the same in every
/// run, on any number of ranks. Collective. Throws NumericalError when the iteration does not
/// converge, Interrupted.
LowestVectors lowest_eigenvectors(const Factorisation &shifted, Mat mass, int count, int mass_rank,
                                  const Block &known = {});

} // namespace vibroimpact::modes
