// Pairs of matrices whose eigenvalues are known, distributed over the ranks.
#pragma once

#include "modes/rayleigh_ritz.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace vibroimpact::examples {

/// Symmetric matrix with entries where |i - j| <= width, also where they are 0.
inline structure::petsc::Matrix band_matrix(int size, int width,
                                            const std::function<double(int, int)> &entry) {
  structure::petsc::Matrix matrix;
  MatCreateAIJ(MPI_COMM_WORLD, PETSC_DECIDE, PETSC_DECIDE, size, size, 2 * width + 1, nullptr,
               2 * width, nullptr, matrix.address());
  int begin = 0;
  int end = 0;
  MatGetOwnershipRange(matrix.get(), &begin, &end);
  for (int i = begin; i < end; ++i)
    for (int j = std::max(0, i - width); j <= std::min(size - 1, i + width); ++j)
      MatSetValue(matrix.get(), i, j, entry(i, j), INSERT_VALUES);
  MatAssemblyBegin(matrix.get(), MAT_FINAL_ASSEMBLY);
  MatAssemblyEnd(matrix.get(), MAT_FINAL_ASSEMBLY);
  MatSetOption(matrix.get(), MAT_SYMMETRIC, PETSC_TRUE);
  return matrix;
}

struct SmallProblem {
  structure::petsc::Matrix stiffness;
  structure::petsc::Matrix mass;
  int mass_rank = 0;

  modes::EigenProblem problem() const {
    return {stiffness.get(), mass.get(), stiffness.get(), mass_rank};
  }
};

/// Single masses 1 + i mod 3 on springs of their own: the eigenvalues are those given.
inline SmallProblem single_masses(const std::vector<double> &eigenvalues) {
  const auto size = static_cast<int>(eigenvalues.size());
  const auto mass = [](int i) { return 1.0 + i % 3; };
  return {band_matrix(size, 0, [&](int i, int) { return eigenvalues[i] * mass(i); }),
          band_matrix(size, 0, [&](int i, int) { return mass(i); }), size};
}

/// Unit masses in a row between walls, joined by unit springs: 4 sin^2(j pi / (2 (size + 1))).
inline SmallProblem chain(int size) {
  return {band_matrix(size, 1, [](int i, int j) { return i == j ? 2.0 : -1.0; }),
          band_matrix(size, 1, [](int i, int j) { return i == j ? 1.0 : 0.0; }), size};
}

inline double chain_eigenvalue(int size, int j) {
  const double sine = std::sin((j + 1) * M_PI / (2.0 * (size + 1)));
  return 4 * sine * sine;
}

} // namespace vibroimpact::examples
