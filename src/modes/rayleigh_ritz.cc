#include "modes/rayleigh_ritz.h"

#include "modes/relative_jacobi.h"

#include <Eigen/Cholesky>

#include <vector>

namespace vibroimpact::modes {

namespace {

// x <- x L^-T with x^T M x = L L^T, twice because the first pass leaves the round-off of an
// ill-conditioned x.
Block orthonormalise_ritz(const EigenProblem &problem, Block x) {
  const Layout layout(problem.mass);
  for (int pass = 0; pass < 2; ++pass) {
    const Matrix gram = inner_products(layout, x, multiply(problem.mass, x));
    const Eigen::LLT<Matrix> cholesky(gram);
    if (cholesky.info() != Eigen::Success)
      throw NumericalError("The approximate modes are linearly dependent");
    if (x.rows() > 0) // a rank may have none
      cholesky.matrixU().solveInPlace<Eigen::OnTheRight>(x);
  }
  return x;
}

Block residuals(const EigenProblem &problem, const Eigenpairs &pairs) {
  return multiply(problem.accurate_stiffness, pairs.vectors) -
         multiply(problem.mass, pairs.vectors) * pairs.values.asDiagonal();
}

structure::petsc::Matrix squared_entries(Mat matrix) {
  using structure::petsc::check;
  structure::petsc::Matrix squares;
  check(MatDuplicate(matrix, MAT_COPY_VALUES, squares.address()), "Copying a matrix");
  const Layout layout(matrix);
  std::vector<double> row_squares;
  for (PetscInt row = layout.own_begin; row < layout.own_begin + layout.own; ++row) {
    PetscInt count = 0;
    const PetscInt *columns = nullptr;
    const double *values = nullptr;
    check(MatGetRow(matrix, row, &count, &columns, &values), "Reading a matrix");
    row_squares.assign(values, values + count);
    for (double &value : row_squares)
      value *= value;
    check(MatSetValues(squares.get(), 1, &row, count, columns, row_squares.data(), INSERT_VALUES),
          "Changing a matrix");
    check(MatRestoreRow(matrix, row, &count, &columns, &values), "Reading a matrix");
  }
  check(MatAssemblyBegin(squares.get(), MAT_FINAL_ASSEMBLY), "Changing a matrix");
  check(MatAssemblyEnd(squares.get(), MAT_FINAL_ASSEMBLY), "Changing a matrix");
  return squares;
}

} // namespace

Eigenpairs rayleigh_ritz(const EigenProblem &problem, Block x) {
  x = orthonormalise_ritz(problem, std::move(x));
  const Layout layout(problem.mass);
  const Matrix projected = inner_products(layout, x, multiply(problem.accurate_stiffness, x));
  const double largest = projected.diagonal().cwiseAbs().maxCoeff();
  const DenseEigenpairs dense =
      relative_jacobi((projected + projected.transpose()) / 2, 1e-20 * largest);
  return {dense.values, x * dense.vectors};
}

Correction inverse_iteration(const EigenProblem &problem, const Factorisation &shifted,
                             const Eigenpairs &pairs) {
  const Block r = residuals(problem, pairs);
  Correction correction{.step = shifted.solve(r), .residual_products = {}};
  correction.residual_products = inner_products(Layout(problem.mass), r, correction.step);
  return correction;
}

Vector rounding_of_quotients(const EigenProblem &problem, const Block &x) {
  if (problem.entry_error == 0)
    return Vector::Zero(x.cols());
  const structure::petsc::Matrix squares = squared_entries(problem.stiffness);
  const Layout layout(problem.stiffness);
  const Block square = x.array().square();
  const Block product = multiply(squares.get(), square);
  return problem.entry_error *
         (2 * inner_products(layout, square, product).diagonal().array()).max(0.0).sqrt();
}

double orthogonality_residual(const EigenProblem &problem, const Block &x) {
  const Layout layout(problem.mass);
  const Matrix gram = inner_products(layout, x, multiply(problem.mass, x));
  return (gram - Matrix::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff();
}

} // namespace vibroimpact::modes
