#include "motion/steps/ts_stepper.h"

#include "motion/steps/petsc_check.h"
#include "motion/system/tolerances.h"

#include <petscts.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace vibroimpact::motion {

namespace {

// Silences PETSc's error output for the life of the object.
class QuietErrors {
public:
  QuietErrors() { PetscPushErrorHandler(PetscReturnErrorHandler, nullptr); }
  ~QuietErrors() { PetscPopErrorHandler(); }
  QuietErrors(const QuietErrors &) = delete;
  QuietErrors &operator=(const QuietErrors &) = delete;
};

PetscErrorCode evaluate_rates(TS /*ts*/, PetscReal time, Vec x, Vec dxdt, void *context) {
  const auto &equations = *static_cast<Equations *>(context);
  const PetscScalar *in = nullptr;
  PetscScalar *out = nullptr;
  VecGetArrayRead(x, &in);
  VecGetArray(dxdt, &out);
  const Index size = equations.layout().size();
  equations.rates(time, ConstVectorView(in, size), VectorView(out, size));
  VecRestoreArray(dxdt, &out);
  VecRestoreArrayRead(x, &in);
  return 0;
}

PetscErrorCode evaluate_jacobian(TS /*ts*/, PetscReal time, Vec x, Mat jacobian,
                                 Mat /*preconditioner*/, void *context) {
  const auto &equations = *static_cast<Equations *>(context);
  const PetscScalar *in = nullptr;
  PetscScalar *out = nullptr;
  Matrix dense;
  VecGetArrayRead(x, &in);
  equations.jacobian(time, ConstVectorView(in, equations.layout().size()), dense);
  VecRestoreArrayRead(x, &in);
  MatDenseGetArrayWrite(jacobian, &out);
  std::copy(dense.data(), dense.data() + dense.size(), out);
  MatDenseRestoreArrayWrite(jacobian, &out);
  MatAssemblyBegin(jacobian, MAT_FINAL_ASSEMBLY);
  MatAssemblyEnd(jacobian, MAT_FINAL_ASSEMBLY);
  return 0;
}

// What PETSc's error control takes for nothing where no absolute tolerance is set [m]: a state that
// passes zero needs some.
double negligible_length(const Settings &settings) {
  return settings.absolute_tolerance > 0 ? settings.absolute_tolerance : 1e-12;
}

// The largest component decides about a step; the work integrals, which never counts, must not
// dilute it.
void default_to_maximum_norm() {
  PetscBool given = PETSC_FALSE;
  PetscOptionsHasName(nullptr, nullptr, "-sub_ts_adapt_wnormtype", &given);
  if (!given)
    PetscOptionsSetValue(nullptr, "-sub_ts_adapt_wnormtype", "INFINITY");
}

} // namespace

TsStepper::TsStepper(Equations &equations, const Settings &settings, const std::string &method,
                     int order)
    : equations_(equations),
      maximum_step_(settings.maximum_step > 0 ? settings.maximum_step
                                              : std::numeric_limits<double>::infinity()),
      measure_(equations, settings.relative_tolerance, negligible_length(settings)),
      source_step_(equations, settings.relative_tolerance) {
  const PetscInt size = static_cast<PetscInt>(equations.layout().size());
  check_petsc(VecCreateSeq(PETSC_COMM_SELF, size, &solution_), "VecCreateSeq");
  check_petsc(TSCreate(PETSC_COMM_SELF, &ts_), "TSCreate");
  check_petsc(TSSetOptionsPrefix(ts_, "sub_"), "TSSetOptionsPrefix");
  check_petsc(TSSetProblemType(ts_, TS_NONLINEAR), "TSSetProblemType");
  check_petsc(TSSetRHSFunction(ts_, nullptr, evaluate_rates, &equations_), "TSSetRHSFunction");
  check_petsc(MatCreateSeqDense(PETSC_COMM_SELF, size, size, nullptr, &jacobian_),
              "MatCreateSeqDense");
  check_petsc(TSSetRHSJacobian(ts_, jacobian_, jacobian_, evaluate_jacobian, &equations_),
              "TSSetRHSJacobian");
  check_petsc(TSSetSolution(ts_, solution_), "TSSetSolution");
  set_method(method, order);
  set_tolerances(settings);
  default_to_maximum_norm();
  check_petsc(TSSetFromOptions(ts_), "TSSetFromOptions");
  check_petsc(TSSetUp(ts_), "TSSetUp");
}

TsStepper::~TsStepper() {
  TSDestroy(&ts_);
  MatDestroy(&jacobian_);
  VecDestroy(&solution_);
}

void TsStepper::set_method(const std::string &method, int order) {
  check_petsc(TSSetType(ts_, method.c_str()), "TSSetType");
  if (method == TSRK)
    check_petsc(TSRKSetType(ts_, TSRK5DP), "TSRKSetType");
  if (method == TSARKIMEX)
    check_petsc(TSARKIMEXSetFullyImplicit(ts_, PETSC_TRUE), "TSARKIMEXSetFullyImplicit");
  if (order > 0)
    check_petsc(TSARKIMEXSetType(ts_, std::to_string(order).c_str()), "TSARKIMEXSetType");
  if (method == TSTHETA)
    check_petsc(TSThetaSetTheta(ts_, 0.5), "TSThetaSetTheta");
  TSAdapt adapt = nullptr;
  check_petsc(TSGetAdapt(ts_, &adapt), "TSGetAdapt");
  check_petsc(TSAdaptSetType(adapt, TSADAPTBASIC), "TSAdaptSetType");
  check_petsc(TSSetExactFinalTime(ts_, TS_EXACTFINALTIME_STEPOVER), "TSSetExactFinalTime");
  check_petsc(TSSetMaxSteps(ts_, std::numeric_limits<PetscInt>::max() - 1), "TSSetMaxSteps");
  check_petsc(TSSetMaxTime(ts_, std::numeric_limits<double>::max() / 4), "TSSetMaxTime");
  check_petsc(TSSetMaxStepRejections(ts_, 30), "TSSetMaxStepRejections");
  check_petsc(TSSetMaxSNESFailures(ts_, -1), "TSSetMaxSNESFailures");
  check_petsc(TSSetErrorIfStepFails(ts_, PETSC_FALSE), "TSSetErrorIfStepFails");
  SNES snes = nullptr;
  KSP ksp = nullptr;
  PC pc = nullptr;
  check_petsc(TSGetSNES(ts_, &snes), "TSGetSNES");
  // By the residual alone: the last change, relative to the whole state, is ruled by the work
  // integrals.
  check_petsc(SNESSetTolerances(snes, PETSC_DEFAULT, 1e-11, 1e-16, PETSC_DEFAULT, PETSC_DEFAULT),
              "SNESSetTolerances");
  check_petsc(SNESGetKSP(snes, &ksp), "SNESGetKSP");
  check_petsc(KSPSetType(ksp, KSPPREONLY), "KSPSetType");
  check_petsc(KSPGetPC(ksp, &pc), "KSPGetPC");
  check_petsc(PCSetType(pc, PCLU), "PCSetType");
}

void TsStepper::set_tolerances(const Settings &settings) {
  const Vector absolute = absolute_tolerances(equations_, negligible_length(settings));
  Vec tolerances = nullptr;
  check_petsc(VecDuplicate(solution_, &tolerances), "VecDuplicate");
  PetscScalar *array = nullptr;
  VecGetArrayWrite(tolerances, &array);
  std::copy(absolute.data(), absolute.data() + absolute.size(), array);
  VecRestoreArrayWrite(tolerances, &array);
  check_petsc(TSSetTolerances(ts_, negligible_length(settings), tolerances,
                              settings.relative_tolerance, nullptr),
              "TSSetTolerances");
  VecDestroy(&tolerances);
}

void TsStepper::load(const Vector &x) {
  PetscScalar *array = nullptr;
  VecGetArrayWrite(solution_, &array);
  std::copy(x.data(), x.data() + x.size(), array);
  VecRestoreArrayWrite(solution_, &array);
}

void TsStepper::unload() {
  const PetscScalar *array = nullptr;
  VecGetArrayRead(solution_, &array);
  end_.state = ConstVectorView(array, equations_.layout().size());
  VecRestoreArrayRead(solution_, &array);
}

void TsStepper::complete(EndPoint &point) const {
  point.rates.resize(point.state.size());
  equations_.rates(point.time, ConstVectorView(point.state.data(), point.state.size()),
                   VectorView(point.rates.data(), point.rates.size()));
  equations_.source_values(point.time, point.sources);
}

void TsStepper::forget() {
  phase_modes_.reset();
  measure_.forget();
  step_of_modes_.clear();
}

double TsStepper::first_step() const {
  const auto known = step_of_modes_.find(equations_.modes());
  if (known != step_of_modes_.end())
    return known->second;
  const double highest = equations_.model().highest_frequency();
  return highest > 0 ? 0.01 / highest : 1e-6;
}

void TsStepper::restart(double time, const Vector &x) {
  if (phase_modes_)
    step_of_modes_[*phase_modes_] = natural_step_;
  phase_modes_ = equations_.modes();
  load(x);
  check_petsc(TSSetTime(ts_, time), "TSSetTime");
  check_petsc(TSRestartStep(ts_), "TSRestartStep");
  end_.time = time;
  end_.state = x;
  complete(end_);
  start_ = end_;
  measure_.begin(end_);
  natural_step_ = first_step();
}

void TsStepper::attempt(double end) {
  check_petsc(TSSetTimeStep(ts_, end - start_.time), "TSSetTimeStep");
  const PetscErrorCode code = TSStep(ts_);
  TSConvergedReason reason = TS_CONVERGED_ITERATING;
  TSGetConvergedReason(ts_, &reason);
  if (code != 0 || reason < 0)
    throw NumericalError("time integration stopped at t = " + std::to_string(start_.time) + " s: " +
                         (reason < 0 ? TSConvergedReasons[reason] : petsc_error_text(code)));
  check_petsc(TSGetTime(ts_, &end_.time), "TSGetTime");
}

// The Runge-Kutta methods undo a rejected attempt by subtraction, which spoils the state when the
// attempt was far too long. A step that had rejections is therefore taken again from the exact
// start with the length that was accepted.
void TsStepper::take(double end) {
  const QuietErrors quiet;
  constexpr int most_attempts = 5; // the first one finds the length
  long rejected = rejected_steps();
  attempt(end);
  for (int i = 1; rejected_steps() > rejected; ++i) {
    if (i == most_attempts)
      throw NumericalError("time integration stopped at t = " + std::to_string(start_.time) +
                           " s: no step is short enough for the tolerance");
    rejected = rejected_steps();
    const double accepted = end_.time;
    roll_back();
    attempt(accepted);
  }
  unload();
  if (!end_.state.allFinite())
    throw NumericalError("the state is no longer finite at t = " + std::to_string(end_.time) +
                         " s");
}

void TsStepper::step(double limit) {
  if (end_.time > start_.time) {
    measure_.set_step(start_, end_);
    measure_.accept();
  }
  std::swap(start_, end_);
  const double free_step = std::min({natural_step_, maximum_step_, limit - start_.time});
  const double wanted =
      source_step_.limited(start_.time, free_step, measure_.source_tolerances(free_step));
  // A last sliver shorter than the rounding of the step before would be no step at all.
  const bool limited = start_.time + wanted * (1 + 1e-9) >= limit;
  take(limited ? limit : start_.time + wanted);
  double proposed = 0;
  check_petsc(TSGetTimeStep(ts_, &proposed), "TSGetTimeStep");
  // After a step that was cut short the old proposal is the better one, if it was not rejected.
  natural_step_ = limited && end_.time >= limit ? std::max(proposed, natural_step_) : proposed;
  if (limited && std::abs(end_.time - limit) <= 4e-16 * std::abs(limit))
    end_.time = limit;
  complete(end_);
}

// The methods undo a step by subtraction; the copy is exact.
void TsStepper::roll_back() {
  check_petsc(TSRollBack(ts_), "TSRollBack");
  load(start_.state);
}

void TsStepper::undo() {
  roll_back();
  end_ = start_;
}

void TsStepper::shorten(double time) {
  const double natural = natural_step_;
  roll_back();
  take(time);
  natural_step_ = natural;
  complete(end_);
}

long TsStepper::rejected_steps() const {
  PetscInt rejected = 0;
  TSGetStepRejections(ts_, &rejected);
  return rejected;
}

} // namespace vibroimpact::motion
