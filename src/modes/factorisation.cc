#include "modes/factorisation.h"

namespace vibroimpact::modes {

using structure::petsc::check;

namespace {

constexpr PetscInt workspace_control = 14;     // per cent of extra workspace for pivoting
constexpr PetscInt parallel_root_control = 13; // 1: the root front too reports its signs
constexpr PetscInt least_workspace = 20;
constexpr PetscInt most_workspace = 1000;
constexpr PetscInt workspace_too_small = -9;

structure::petsc::Matrix shifted(Mat stiffness, Mat mass, double shift) {
  structure::petsc::Matrix matrix;
  check(MatDuplicate(stiffness, MAT_COPY_VALUES, matrix.address()), "Copying a matrix");
  if (shift != 0)
    check(MatAXPY(matrix.get(), -shift, mass, SAME_NONZERO_PATTERN), "Shifting a matrix");
  check(MatSetOption(matrix.get(), MAT_SYMMETRIC, PETSC_TRUE), "Marking a matrix symmetric");
  return matrix;
}

/// Whether it succeeded; false when MUMPS asks for more workspace. The information is the default.
bool factorise(Mat factor, Mat matrix) {
  MatFactorInfo information;
  check(MatFactorInfoInitialize(&information), "Setting up MUMPS");
  check(MatCholeskyFactorNumeric(factor, matrix, &information),
        "Factorising the shifted stiffness matrix with MUMPS");
  MatFactorError error = MAT_FACTOR_NOERROR;
  check(MatFactorGetError(factor, &error), "Factorising with MUMPS");
  if (error == MAT_FACTOR_NOERROR)
    return true;
  PetscInt reason = 0;
  check(MatMumpsGetInfog(factor, 1, &reason), "Factorising with MUMPS");
  if (reason != workspace_too_small)
    throw NumericalError("MUMPS could not factorise the shifted stiffness matrix");
  return false;
}

structure::petsc::Matrix analysed(Mat matrix, PetscInt workspace) {
  structure::petsc::Matrix factor;
  MatFactorInfo information;
  check(MatFactorInfoInitialize(&information), "Setting up MUMPS");
  check(MatGetFactor(matrix, MATSOLVERMUMPS, MAT_FACTOR_CHOLESKY, factor.address()),
        "Setting up MUMPS");
  check(MatMumpsSetIcntl(factor.get(), parallel_root_control, 1), "Setting up MUMPS");
  check(MatMumpsSetIcntl(factor.get(), workspace_control, workspace), "Setting up MUMPS");
  // The order of elimination is left to MUMPS.
  check(MatCholeskyFactorSymbolic(factor.get(), matrix, nullptr, &information),
        "Factorising the shifted stiffness matrix with MUMPS");
  return factor;
}

structure::petsc::Matrix factorised(Mat matrix) {
  for (PetscInt workspace = least_workspace; workspace <= most_workspace; workspace *= 2) {
    structure::petsc::Matrix factor = analysed(matrix, workspace);
    if (factorise(factor.get(), matrix))
      return factor;
  }
  throw NumericalError("MUMPS needs too much memory for its pivots to factorise the shifted "
                       "stiffness matrix");
}

} // namespace

Factorisation::Factorisation(Mat stiffness, Mat mass, double shift)
    : stiffness_(stiffness), mass_(mass), shift_(shift),
      factor_(factorised(shifted(stiffness, mass, shift).get())) {}

void Factorisation::shift_to(double shift) {
  if (shift == shift_)
    return;
  const structure::petsc::Matrix matrix = shifted(stiffness_, mass_, shift);
  shift_ = shift;
  if (factorise(factor_.get(), matrix.get()))
    return;
  factor_ = {}; // one at a time: they are what takes the memory
  factor_ = factorised(matrix.get());
}

const Factorisation &FactorisedPencil::at(Mat stiffness, Mat mass, double shift) {
  if (factorisation_)
    factorisation_->shift_to(shift);
  else
    factorisation_.emplace(stiffness, mass, shift);
  return *factorisation_;
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
