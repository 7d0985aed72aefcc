// How much of the variance of a quantity each of its arguments brings about, when these are drawn
// at random and independently of each other: Sobol's indices [sobol2001global].
//
//   first order  S_i = V(E(f | x_i)) / V(f)      what x_i does by itself
//   total        T_i = E(V(f | all but x_i)) / V(f)      together with all its interactions
//
// from two matrices of samples, A and B, and for each argument A with the column of B, A_B^i, by
// the estimators of [saltelli2010variance]: S_i = mean f_B (f_ABi - f_A) / V, f less its mean, and
// T_i = mean (f_A - f_ABi)^2 / 2 V. Standard errors are those over samples drawn again from these
// with replacement.
#pragma once

#include "common/linear_algebra.h"

#include <cstdint>
#include <vector>

namespace vibroimpact::analyses {

/// The sample points, in [0, 1]. Each row is drawn by itself, when it is asked for.
struct SobolDesign {
  std::size_t rows = 0;
  Index arguments = 0;
  std::uint64_t seed = 0;

  /// rows * (arguments + 2)
  std::size_t points() const;
  /// Row by row: of A, of B, of A_B^i for each argument.
  Vector point(std::size_t number) const;
};

struct SobolIndex {
  double first = 0, first_error = 0; ///< with its standard error
  double total = 0, total_error = 0;
};

struct SobolIndices {
  double mean = 0, variance = 0;
  std::size_t rows = 0; ///< whose values are all finite, which alone count
  std::vector<SobolIndex> arguments;
};

/// `values` at the points of a design in their order, NaN where there is none. Fewer than two good
/// rows: all results NaN; the indices of a constant are NaN.
SobolIndices sobol_indices(const std::vector<double> &values, Index arguments, std::uint64_t seed);

} // namespace vibroimpact::analyses
