#include "modes/impulse_response.h"

#include "modes/factorisation.h"

namespace vibroimpact::modes {

using structure::petsc::check;

namespace {

structure::petsc::Vector diagonal_vector(Mat matrix) {
  structure::petsc::Vector diagonal;
  check(MatCreateVecs(matrix, nullptr, diagonal.address()), "Making a vector");
  check(MatGetDiagonal(matrix, diagonal.get()), "Reading a matrix");
  return diagonal;
}

Vector own_entries(Vec vector) {
  PetscInt size = 0;
  const double *entries = nullptr;
  check(VecGetLocalSize(vector, &size), "Reading a vector");
  check(VecGetArrayRead(vector, &entries), "Reading a vector");
  Vector own = Eigen::Map<const Vector>(entries, size);
  check(VecRestoreArrayRead(vector, &entries), "Reading a vector");
  return own;
}

/// The matrix with 1 on the diagonal where there is 0, which leaves the others alone.
structure::petsc::Matrix regular(Mat mass) {
  const structure::petsc::Vector diagonal = diagonal_vector(mass);
  double *entries = nullptr;
  PetscInt size = 0;
  check(VecGetLocalSize(diagonal.get(), &size), "Reading a vector");
  check(VecGetArray(diagonal.get(), &entries), "Reading a vector");
  for (PetscInt i = 0; i < size; ++i)
    entries[i] = entries[i] == 0 ? 1 : 0;
  check(VecRestoreArray(diagonal.get(), &entries), "Writing a vector");
  structure::petsc::Matrix matrix;
  check(MatDuplicate(mass, MAT_COPY_VALUES, matrix.address()), "Copying a matrix");
  check(MatDiagonalSet(matrix.get(), diagonal.get(), ADD_VALUES), "Changing a matrix");
  return matrix;
}

// Rounding leaves zeros of some 1e-14, elements some 1e-6 at least.
constexpr double zero_mass = 1e-10;

/// The diagonal alone, with the pattern of the matrix.
structure::petsc::Matrix diagonal_matrix(Mat mass) {
  structure::petsc::Matrix matrix;
  check(MatDuplicate(mass, MAT_COPY_VALUES, matrix.address()), "Copying a matrix");
  check(MatZeroEntries(matrix.get()), "Copying a matrix");
  check(MatDiagonalSet(matrix.get(), diagonal_vector(mass).get(), INSERT_VALUES),
        "Changing a matrix");
  return matrix;
}

} // namespace

MassSigns mass_signs(Mat mass) {
  const structure::petsc::Matrix matrix = regular(mass);
  const structure::petsc::Matrix diagonal = diagonal_matrix(mass);
  Factorisation factorised(matrix.get(), diagonal.get(), zero_mass);
  const int small = factorised.eigenvalues_below();
  if (small == 0)
    return {};
  factorised.shift_to(-zero_mass);
  const int negative = factorised.eigenvalues_below();
  return {.zero = small - negative, .negative = negative};
}

Vector own_diagonal(Mat matrix) { return own_entries(diagonal_vector(matrix).get()); }

Vector diagonal(Mat matrix) { return gather(Layout(matrix), own_diagonal(matrix)); }

Matrix impulse_response(Mat mass, const Matrix &impulses) {
  const Layout layout(mass);
  const structure::petsc::Matrix matrix = regular(mass);
  const Factorisation factorised(matrix.get(), mass, 0);
  return gather(layout, factorised.solve(own_rows(layout, impulses)));
}

} // namespace vibroimpact::modes
