#include "modes/factorisation.h"

namespace vibroimpact::modes {

using structure::petsc::check;

namespace {

constexpr PetscInt workspace_control = 14;     // per cent of extra workspace for pivoting
constexpr PetscInt parallel_root_control = 13; // 1: the root front too reports its signs

structure::petsc::Matrix shifted(Mat stiffness, Mat mass, double shift) {
  structure::petsc::Matrix matrix;
  check(MatDuplicate(stiffness, MAT_COPY_VALUES, matrix.address()), "Copying a matrix");
  check(MatAXPY(matrix.get(), -shift, mass, SAME_NONZERO_PATTERN), "Shifting a matrix");
  check(MatSetOption(matrix.get(), MAT_SYMMETRIC, PETSC_TRUE), "Marking a matrix symmetric");
  return matrix;
}

void require_success(Mat factor) {
  MatFactorError error = MAT_FACTOR_NOERROR;
  check(MatFactorGetError(factor, &error), "Factorising with MUMPS");
  if (error != MAT_FACTOR_NOERROR)
    throw NumericalError("MUMPS could not factorise the shifted stiffness matrix");
}

} // namespace

void use_mumps(KSP solver) {
  PC preconditioner = nullptr;
  check(KSPSetType(solver, KSPPREONLY), "Setting up MUMPS");
  check(KSPGetPC(solver, &preconditioner), "Setting up MUMPS");
  check(PCSetType(preconditioner, PCCHOLESKY), "Setting up MUMPS");
  check(PCFactorSetMatSolverType(preconditioner, MATSOLVERMUMPS), "Setting up MUMPS");
}

Factorisation factorisation_of(KSP solver) {
  PC preconditioner = nullptr;
  Mat factor = nullptr;
  check(KSPGetPC(solver, &preconditioner), "Taking over a factorisation");
  check(PCFactorGetMatrix(preconditioner, &factor), "Taking over a factorisation");
  check(PetscObjectReference(reinterpret_cast<PetscObject>(factor)), "Taking over a factorisation");
  return Factorisation(structure::petsc::Matrix(factor));
}

Factorisation::Factorisation(Mat stiffness, Mat mass, double shift) {
  const structure::petsc::Matrix matrix = shifted(stiffness, mass, shift);
  MatFactorInfo information;
  check(MatFactorInfoInitialize(&information), "Setting up MUMPS");
  check(MatGetFactor(matrix.get(), MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, factor_.address()),
        "Setting up MUMPS");
  check(MatMumpsSetIcntl(factor_.get(), parallel_root_control, 1), "Setting up MUMPS");
  check(MatMumpsSetIcntl(factor_.get(), workspace_control, 100), "Setting up MUMPS");
  // The order of elimination is left to MUMPS.
  check(MatCholeskyFactorSymbolic(factor_.get(), matrix.get(), nullptr, &information),
        "Factorising the shifted stiffness matrix with MUMPS");
  check(MatCholeskyFactorNumeric(factor_.get(), matrix.get(), &information),
        "Factorising the shifted stiffness matrix with MUMPS");
  require_success(factor_.get());
}

Block Factorisation::solve(Block x) const {
  const Layout layout(factor_.get());
  Block y = Block::Zero(x.rows(), x.cols());
  const structure::petsc::Matrix in = wrap(layout, x);
  const structure::petsc::Matrix out = wrap(layout, y);
  check(MatMatSolve(factor_.get(), in.get(), out.get()), "Solving with MUMPS");
  return y;
}

int Factorisation::eigenvalues_below() const {
  PetscInt negative = 0;
  check(MatGetInertia(factor_.get(), &negative, nullptr, nullptr), "Counting modes");
  return static_cast<int>(negative);
}

} // namespace vibroimpact::modes
