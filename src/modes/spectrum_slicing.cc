#include "modes/spectrum_slicing.h"

#include <slepceps.h>

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

/// MUMPS, symmetric indefinite.
void use_mumps(KSP solver) {
  PC preconditioner = nullptr;
  check(KSPSetType(solver, KSPPREONLY), "Setting up MUMPS");
  check(KSPGetPC(solver, &preconditioner), "Setting up MUMPS");
  check(PCSetType(preconditioner, PCCHOLESKY), "Setting up MUMPS");
  check(PCFactorSetMatSolverType(preconditioner, MATSOLVERMUMPS), "Setting up MUMPS");
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

Block eigenvectors_between(Mat stiffness, Mat mass, double lower, double upper) {
  default_option("-st_mat_mumps_icntl_14", "100"); // per cent of extra workspace for pivoting
  default_option("-st_mat_mumps_icntl_13", "1");
  default_option("-st_mat_mumps_icntl_24", "1");
  const Layout layout(stiffness);
  const Eigensolver solver = make_solver(stiffness, mass);
  check(EPSSetInterval(solver.get(), lower, upper), "Setting up SLEPc");
  check(EPSSetWhichEigenpairs(solver.get(), EPS_ALL), "Setting up SLEPc");
  return solve(solver.get(), layout);
}

} // namespace vibroimpact::modes
