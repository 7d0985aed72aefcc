#include "modes/factorisation.h"

namespace vibroimpact::modes {

using petsc::check;

namespace {

constexpr PetscInt workspace_control = 14;     // per cent of extra workspace for pivoting
constexpr PetscInt parallel_root_control = 13; // 1: the root front too reports its signs

Mat factor_of(KSP solver) {
  PC preconditioner = nullptr;
  Mat factor = nullptr;
  check(KSPGetPC(solver, &preconditioner), "Setting up MUMPS");
  check(PCFactorGetMatrix(preconditioner, &factor), "Setting up MUMPS");
  return factor;
}

} // namespace

void use_mumps(KSP solver) {
  PC preconditioner = nullptr;
  check(KSPSetType(solver, KSPPREONLY), "Setting up MUMPS");
  check(KSPGetPC(solver, &preconditioner), "Setting up MUMPS");
  check(PCSetType(preconditioner, PCCHOLESKY), "Setting up MUMPS");
  check(PCFactorSetMatSolverType(preconditioner, MATSOLVERMUMPS), "Setting up MUMPS");
}

Factorisation::Factorisation(Mat stiffness, Mat mass, double shift) {
  check(MatDuplicate(stiffness, MAT_COPY_VALUES, matrix_.address()), "Copying a matrix");
  check(MatAXPY(matrix_.get(), -shift, mass, SAME_NONZERO_PATTERN), "Shifting a matrix");
  check(MatSetOption(matrix_.get(), MAT_SYMMETRIC, PETSC_TRUE), "Marking a matrix symmetric");
  MPI_Comm communicator = PetscObjectComm(reinterpret_cast<PetscObject>(stiffness));
  check(KSPCreate(communicator, solver_.address()), "Setting up MUMPS");
  check(KSPSetOperators(solver_.get(), matrix_.get(), matrix_.get()), "Setting up MUMPS");
  use_mumps(solver_.get());
  PC preconditioner = nullptr;
  check(KSPGetPC(solver_.get(), &preconditioner), "Setting up MUMPS");
  check(PCFactorSetUpMatSolverType(preconditioner), "Setting up MUMPS");
  check(MatMumpsSetIcntl(factor_of(solver_.get()), parallel_root_control, 1), "Setting up MUMPS");
  check(MatMumpsSetIcntl(factor_of(solver_.get()), workspace_control, 100), "Setting up MUMPS");
  check(KSPSetUp(solver_.get()), "Factorising the shifted stiffness matrix with MUMPS");
}

Block Factorisation::solve(Block x) const {
  const Layout layout(matrix_.get());
  Block y = Block::Zero(x.rows(), x.cols());
  petsc::Matrix in;
  petsc::Matrix out;
  for (auto [block, matrix] : {std::pair(&x, &in), std::pair(&y, &out)})
    check(MatCreateDense(layout.communicator, layout.own, PETSC_DECIDE, layout.size,
                         static_cast<PetscInt>(x.cols()), block->data(), matrix->address()),
          "Wrapping vectors");
  check(KSPMatSolve(solver_.get(), in.get(), out.get()), "Solving with MUMPS");
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  check(KSPGetConvergedReason(solver_.get(), &reason), "Solving with MUMPS");
  if (reason < 0)
    throw NumericalError("MUMPS could not factorise the shifted stiffness matrix");
  return y;
}

int Factorisation::eigenvalues_below() const {
  PetscInt negative = 0;
  check(MatGetInertia(factor_of(solver_.get()), &negative, nullptr, nullptr), "Counting modes");
  return static_cast<int>(negative);
}

} // namespace vibroimpact::modes
