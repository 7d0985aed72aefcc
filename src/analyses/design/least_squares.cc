#include "analyses/design/least_squares.h"

#include "common/error.h"
#include "common/petsc_error.h"

#include <exception>
#include <petsctao.h>

namespace vibroimpact::analyses {

namespace {

/// Destroys a PETSc object with its own function.
template <class Object, PetscErrorCode (*destroy)(Object *)> class Owned {
public:
  Owned() = default;
  ~Owned() { destroy(&object_); }
  Owned(const Owned &) = delete;
  Owned &operator=(const Owned &) = delete;
  operator Object() const { return object_; }
  Object *place() { return &object_; }

private:
  Object object_ = nullptr;
};
using OwnedVec = Owned<Vec, VecDestroy>;
using OwnedMat = Owned<Mat, MatDestroy>;
using OwnedTao = Owned<Tao, TaoDestroy>;

/// C++ exceptions must not pass through PETSc, which is C.
struct Calls {
  const LeastSquaresProblem &problem;
  std::exception_ptr error{};
  Vector last{}; ///< coordinates of the iteration before
  double last_sum = 0;
};

template <class Work> PetscErrorCode guarded(Calls &calls, Work work) {
  try {
    work();
    return 0;
  } catch (...) {
    calls.error = std::current_exception();
    return PETSC_ERR_USER;
  }
}

Vector values_of(Vec x) {
  PetscInt size = 0;
  const PetscScalar *values = nullptr;
  VecGetSize(x, &size);
  VecGetArrayRead(x, &values);
  const Vector copy = Eigen::Map<const Vector>(values, size);
  VecRestoreArrayRead(x, &values);
  return copy;
}

void set_values(Vec x, const Vector &values) {
  PetscScalar *place = nullptr;
  VecGetArray(x, &place);
  Eigen::Map<Vector>(place, values.size()) = values;
  VecRestoreArray(x, &place);
}

PetscErrorCode residuals(Tao, Vec x, Vec r, void *data) {
  Calls &calls = *static_cast<Calls *>(data);
  return guarded(calls, [&] { set_values(r, calls.problem.residuals(values_of(x))); });
}

PetscErrorCode jacobian(Tao, Vec x, Mat j, Mat, void *data) {
  Calls &calls = *static_cast<Calls *>(data);
  return guarded(calls, [&] {
    const Matrix matrix = calls.problem.jacobian(values_of(x));
    PetscScalar *place = nullptr;
    MatDenseGetArray(j, &place);
    Eigen::Map<Matrix>(place, matrix.rows(), matrix.cols()) = matrix; // both by columns
    MatDenseRestoreArray(j, &place);
    MatAssemblyBegin(j, MAT_FINAL_ASSEMBLY);
    MatAssemblyEnd(j, MAT_FINAL_ASSEMBLY);
  });
}

/// Far below what the noise of any data makes of the sum of squares.
constexpr double least_decrease = 1e-9; // relative

/// PETSc's own test by the gradient, and those by the step and the sum of squares.
PetscErrorCode converged(Tao tao, void *data) {
  Calls &calls = *static_cast<Calls *>(data);
  Vec x = nullptr;
  TaoGetSolution(tao, &x);
  const Vector now = values_of(x);
  if (calls.last.size() == now.size() &&
      (now - calls.last).cwiseAbs().maxCoeff() < calls.problem.tolerance &&
      (now - calls.last).cwiseAbs().maxCoeff() > 0)
    return TaoSetConvergedReason(tao, TAO_CONVERGED_STEPTOL);
  PetscReal sum = 0;
  TaoGetSolutionStatus(tao, nullptr, &sum, nullptr, nullptr, nullptr, nullptr);
  if (calls.last.size() == now.size() && calls.last_sum - sum < least_decrease * sum &&
      calls.last != now)
    return TaoSetConvergedReason(tao, TAO_CONVERGED_USER);
  calls.last = now;
  calls.last_sum = sum;
  return TaoDefaultConvergenceTest(tao, nullptr);
}

SearchEnd end_of(TaoConvergedReason reason) {
  switch (reason) {
  case TAO_CONVERGED_STEPTOL:
    return SearchEnd::tolerance;
  case TAO_CONVERGED_GATOL:
  case TAO_CONVERGED_GRTOL:
  case TAO_CONVERGED_GTTOL:
  case TAO_CONVERGED_USER:
    return SearchEnd::objective_tolerance;
  case TAO_DIVERGED_MAXITS:
  case TAO_DIVERGED_MAXFCN:
    return SearchEnd::evaluations;
  case TAO_DIVERGED_LS_FAILURE:
  case TAO_DIVERGED_TR_REDUCTION:
    return SearchEnd::rounding;
  default:
    return SearchEnd::other;
  }
}

} // namespace

SearchEnd least_squares(const LeastSquaresProblem &problem) {
  const auto n = static_cast<PetscInt>(problem.start.size());
  const auto m = static_cast<PetscInt>(problem.size);
  Calls calls{.problem = problem};
  OwnedVec x, lower, upper, r;
  OwnedMat j;
  OwnedTao tao;
  VecCreateSeq(PETSC_COMM_SELF, n, x.place());
  VecCreateSeq(PETSC_COMM_SELF, n, lower.place());
  VecCreateSeq(PETSC_COMM_SELF, n, upper.place());
  VecCreateSeq(PETSC_COMM_SELF, m, r.place());
  MatCreateSeqDense(PETSC_COMM_SELF, m, n, nullptr, j.place());
  set_values(x, problem.start);
  set_values(lower, problem.lower.cwiseMax(PETSC_NINFINITY));
  set_values(upper, problem.upper.cwiseMin(PETSC_INFINITY));

  TaoCreate(PETSC_COMM_SELF, tao.place());
  TaoSetType(tao, TAOBRGN);
  TaoSetSolution(tao, x);
  TaoSetVariableBounds(tao, lower, upper);
  TaoSetResidualRoutine(tao, r, residuals, &calls);
  TaoSetJacobianResidualRoutine(tao, j, j, jacobian, &calls);
  TaoSetMaximumIterations(tao, problem.most_iterations);
  Tao inner = nullptr;
  TaoBRGNGetSubsolver(tao, &inner);
  TaoSetConvergenceTest(inner, converged, &calls);
  TaoLineSearch line_search = nullptr;
  TaoGetLineSearch(inner, &line_search);
  if (line_search != nullptr) // by values alone: a gradient takes an evaluation for each key
    TaoLineSearchSetType(line_search, TAOLINESEARCHARMIJO);
  const PetscErrorCode failed = TaoSolve(tao);
  if (calls.error)
    std::rethrow_exception(calls.error);
  if (failed != 0)
    throw NumericalError("the least squares failed: " + taken_petsc_error());
  TaoConvergedReason reason = TAO_CONTINUE_ITERATING;
  TaoGetConvergedReason(inner, &reason);
  return end_of(reason);
}

} // namespace vibroimpact::analyses
