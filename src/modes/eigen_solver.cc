#include "modes/eigen_solver.h"

#include <slepceps.h>

#include <algorithm>
#include <cmath>

namespace vibroimpact::modes {

using structure::petsc::check;

namespace {

using Eigensolver = structure::petsc::Object<EPS, EPSDestroy>;

constexpr double tolerance = 1e-12;
constexpr int most_restarts = 1000;

// Parallel MUMPS reports the signs of its root front only when asked to, and spectrum slicing makes
// its solvers inside SLEPc, out of reach of MatMumpsSetIcntl. The user's own option goes first.
void default_option(const char *name, const char *value) {
  PetscBool given = PETSC_FALSE;
  check(PetscOptionsHasName(nullptr, nullptr, name, &given), "Setting an option");
  if (given == PETSC_FALSE)
    check(PetscOptionsSetValue(nullptr, name, value), "Setting an option");
}

// Fractional parts of multiples of the golden ratio: no structure that a mode could be orthogonal
// to, and the same in every run.
structure::petsc::Vector start_vector(Mat matrix) {
  structure::petsc::Vector owner;
  check(MatCreateVecs(matrix, owner.address(), nullptr), "Making a start vector");
  Vec start = owner.get();
  PetscInt begin = 0;
  PetscInt end = 0;
  double *values = nullptr;
  check(VecGetOwnershipRange(start, &begin, &end), "Making a start vector");
  check(VecGetArray(start, &values), "Making a start vector");
  for (PetscInt i = begin; i < end; ++i)
    values[i - begin] = 0.5 + std::fmod(0.6180339887498949 * (i + 1), 1.0);
  check(VecRestoreArray(start, &values), "Making a start vector");
  return owner;
}

Eigensolver make_solver(Mat stiffness, Mat mass) {
  Eigensolver solver;
  ST transformation = nullptr;
  KSP linear = nullptr;
  const Layout layout(stiffness);
  check(EPSCreate(layout.communicator, solver.address()), "Setting up SLEPc");
  check(EPSSetOperators(solver.get(), stiffness, mass), "Setting up SLEPc");
  check(EPSSetProblemType(solver.get(), EPS_GHEP), "Setting up SLEPc");
  check(EPSSetType(solver.get(), EPSKRYLOVSCHUR), "Setting up SLEPc");
  check(EPSSetTolerances(solver.get(), tolerance, most_restarts), "Setting up SLEPc");
  check(EPSGetST(solver.get(), &transformation), "Setting up SLEPc");
  check(STSetType(transformation, STSINVERT), "Setting up SLEPc");
  check(STSetMatStructure(transformation, SAME_NONZERO_PATTERN), "Setting up SLEPc");
  check(STGetKSP(transformation, &linear), "Setting up SLEPc");
  use_mumps(linear);
  return solver;
}

Block solve(EPS solver, const Layout &layout) {
  check(EPSSetFromOptions(solver), "Setting up SLEPc");
  check(EPSSolve(solver), "The eigen-solution with SLEPc");
  PetscInt converged = 0;
  check(EPSGetConverged(solver, &converged), "The eigen-solution with SLEPc");
  Block vectors = Block::Zero(layout.own, converged);
  for (PetscInt j = 0; j < converged; ++j) {
    structure::petsc::Vector column;
    check(VecCreateMPIWithArray(layout.communicator, 1, layout.own, layout.size,
                                vectors.col(j).data(), column.address()),
          "Wrapping a vector");
    check(EPSGetEigenvector(solver, j, column.get(), nullptr), "The eigen-solution with SLEPc");
  }
  return vectors;
}

} // namespace

FoundVectors lowest_eigenvectors(Mat stiffness, Mat mass, double shift, int count) {
  default_option("-st_mat_mumps_icntl_14", "100"); // per cent of extra workspace for pivoting
  const Layout layout(stiffness);
  const Eigensolver solver = make_solver(stiffness, mass);
  const PetscInt subspace = std::min(layout.size, std::max(2 * count, count + 30));
  check(EPSSetTarget(solver.get(), shift), "Setting up SLEPc");
  check(EPSSetWhichEigenpairs(solver.get(), EPS_TARGET_MAGNITUDE), "Setting up SLEPc");
  check(EPSSetDimensions(solver.get(), count, subspace, PETSC_DEFAULT), "Setting up SLEPc");
  const structure::petsc::Vector start = start_vector(stiffness);
  Vec space = start.get();
  check(EPSSetInitialSpace(solver.get(), 1, &space), "Setting up SLEPc");
  Block vectors = solve(solver.get(), layout);
  if (vectors.cols() < count)
    throw NumericalError("The eigen-solution found only " + std::to_string(vectors.cols()) +
                         " of " + std::to_string(count) + " modes");
  ST transformation = nullptr;
  KSP linear = nullptr;
  check(EPSGetST(solver.get(), &transformation), "Taking over a factorisation");
  check(STGetKSP(transformation, &linear), "Taking over a factorisation");
  return {std::move(vectors), factorisation_of(linear)};
}

Block eigenvectors_between(Mat stiffness, Mat mass, double lower, double upper) {
  default_option("-st_mat_mumps_icntl_13", "1");
  default_option("-st_mat_mumps_icntl_24", "1");
  const Layout layout(stiffness);
  const Eigensolver solver = make_solver(stiffness, mass);
  check(EPSSetInterval(solver.get(), lower, upper), "Setting up SLEPc");
  check(EPSSetWhichEigenpairs(solver.get(), EPS_ALL), "Setting up SLEPc");
  return solve(solver.get(), layout);
}

} // namespace vibroimpact::modes
