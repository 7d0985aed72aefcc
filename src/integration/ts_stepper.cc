#include "integration/ts_stepper.h"

#include "common/error.h"

#include <petscts.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace vibroimpact {

namespace {

std::string error_text(PetscErrorCode code) {
  const char *text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  return text ? text : "unknown error";
}

// PETSc's own handler would print a stack trace; the code it returns says enough.
void check(PetscErrorCode code, const char *call) {
  if (code != 0)
    throw NumericalError(std::string(call) + " failed: " + error_text(code));
}

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

// The largest component decides about a step; the ledger, which never counts, must not dilute it.
void default_to_maximum_norm() {
  PetscBool given = PETSC_FALSE;
  PetscOptionsHasName(nullptr, nullptr, "-ts_adapt_wnormtype", &given);
  if (!given)
    PetscOptionsSetValue(nullptr, "-ts_adapt_wnormtype", "INFINITY");
}

} // namespace

TsStepper::TsStepper(Equations &equations, const IntegrationSettings &settings)
    : equations_(equations),
      maximum_step_(settings.maximum_step > 0 ? settings.maximum_step
                                              : std::numeric_limits<double>::infinity()) {
  const PetscInt size = static_cast<PetscInt>(equations.layout().size());
  check(VecCreateSeq(PETSC_COMM_SELF, size, &solution_), "VecCreateSeq");
  check(TSCreate(PETSC_COMM_SELF, &ts_), "TSCreate");
  check(TSSetProblemType(ts_, TS_NONLINEAR), "TSSetProblemType");
  check(TSSetRHSFunction(ts_, nullptr, evaluate_rates, &equations_), "TSSetRHSFunction");
  check(MatCreateSeqDense(PETSC_COMM_SELF, size, size, nullptr, &jacobian_), "MatCreateSeqDense");
  check(TSSetRHSJacobian(ts_, jacobian_, jacobian_, evaluate_jacobian, &equations_),
        "TSSetRHSJacobian");
  check(TSSetSolution(ts_, solution_), "TSSetSolution");
  set_method(settings.method);
  set_tolerances(settings);
  default_to_maximum_norm();
  check(TSSetFromOptions(ts_), "TSSetFromOptions");
  check(TSSetUp(ts_), "TSSetUp");
}

TsStepper::~TsStepper() {
  TSDestroy(&ts_);
  MatDestroy(&jacobian_);
  VecDestroy(&solution_);
}

void TsStepper::set_method(const std::string &method) {
  check(TSSetType(ts_, method.c_str()), "TSSetType");
  if (method == TSRK)
    check(TSRKSetType(ts_, TSRK5DP), "TSRKSetType");
  if (method == TSARKIMEX)
    check(TSARKIMEXSetFullyImplicit(ts_, PETSC_TRUE), "TSARKIMEXSetFullyImplicit");
  if (method == TSTHETA)
    check(TSThetaSetTheta(ts_, 0.5), "TSThetaSetTheta");
  TSAdapt adapt = nullptr;
  check(TSGetAdapt(ts_, &adapt), "TSGetAdapt");
  check(TSAdaptSetType(adapt, TSADAPTBASIC), "TSAdaptSetType");
  check(TSSetExactFinalTime(ts_, TS_EXACTFINALTIME_STEPOVER), "TSSetExactFinalTime");
  check(TSSetMaxSteps(ts_, std::numeric_limits<PetscInt>::max() - 1), "TSSetMaxSteps");
  check(TSSetMaxTime(ts_, std::numeric_limits<double>::max() / 4), "TSSetMaxTime");
  check(TSSetMaxStepRejections(ts_, 100), "TSSetMaxStepRejections");
  check(TSSetMaxSNESFailures(ts_, -1), "TSSetMaxSNESFailures");
  check(TSSetErrorIfStepFails(ts_, PETSC_FALSE), "TSSetErrorIfStepFails");
  SNES snes = nullptr;
  KSP ksp = nullptr;
  PC pc = nullptr;
  check(TSGetSNES(ts_, &snes), "TSGetSNES");
  check(SNESGetKSP(snes, &ksp), "SNESGetKSP");
  check(KSPSetType(ksp, KSPPREONLY), "KSPSetType");
  check(KSPGetPC(ksp, &pc), "KSPGetPC");
  check(PCSetType(pc, PCLU), "PCSetType");
}

// A tolerance in metres at the points becomes one for the coordinates of a body by the largest
// displacement that a unit coordinate gives at a point, the same for all of them: a mode the points
// hardly see still holds energy. Velocities follow by the natural frequencies.
void TsStepper::set_tolerances(const IntegrationSettings &settings) {
  const StateLayout &layout = equations_.layout();
  const Model &model = equations_.model();
  const double huge = std::numeric_limits<double>::max() / 16;
  Vector absolute = Vector::Constant(layout.size(), huge);
  // Where nothing oscillates, a second is as good as any scale.
  const double highest = model.highest_frequency() > 0 ? model.highest_frequency() : 1;
  for (std::size_t b = 0; b < model.bodies().size(); ++b) {
    const ReducedBody &body = *model.bodies()[b];
    const Vector omega = body.omega();
    double reach = 0;
    for (const BodyPoint &point : body.points)
      reach = std::max(reach, point.rows.topRows(3).cwiseAbs().maxCoeff());
    const double tolerance = settings.absolute_tolerance / (reach > 0 ? reach : 1);
    for (Index j = 0; j < body.size(); ++j) {
      absolute[model.offset(b) + j] = tolerance;
      absolute[layout.velocity() + model.offset(b) + j] =
          tolerance * (omega[j] > 0 ? omega[j] : highest);
    }
  }
  absolute.segment(layout.internal(), layout.n_internal).setConstant(settings.absolute_tolerance);
  // A motor's torque counts by the metre per starting torque, as an angle counts as a length.
  for (const Rotor &rotor : model.rotors().list())
    if (rotor.motor)
      absolute[layout.drive() + rotor.motor->drive] =
          settings.absolute_tolerance * std::max(1.0, std::abs(rotor.motor->starting_torque));
  Vec tolerances = nullptr;
  check(VecDuplicate(solution_, &tolerances), "VecDuplicate");
  PetscScalar *array = nullptr;
  VecGetArrayWrite(tolerances, &array);
  std::copy(absolute.data(), absolute.data() + absolute.size(), array);
  VecRestoreArrayWrite(tolerances, &array);
  check(TSSetTolerances(ts_, settings.absolute_tolerance, tolerances, settings.relative_tolerance,
                        nullptr),
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
  state_ = ConstVectorView(array, equations_.layout().size());
  VecRestoreArrayRead(solution_, &array);
}

void TsStepper::restart(double time, const Vector &x, double first_step) {
  load(x);
  check(TSSetTime(ts_, time), "TSSetTime");
  check(TSRestartStep(ts_), "TSRestartStep");
  time_ = previous_time_ = time;
  state_ = previous_state_ = x;
  natural_step_ = first_step;
}

void TsStepper::attempt(double end) {
  check(TSSetTimeStep(ts_, end - previous_time_), "TSSetTimeStep");
  const PetscErrorCode code = TSStep(ts_);
  TSConvergedReason reason = TS_CONVERGED_ITERATING;
  TSGetConvergedReason(ts_, &reason);
  if (code != 0 || reason < 0)
    throw NumericalError("the time integrator gave up at t = " + std::to_string(previous_time_) +
                         " s: " + (reason < 0 ? TSConvergedReasons[reason] : error_text(code)));
  check(TSGetTime(ts_, &time_), "TSGetTime");
}

// The Runge-Kutta methods undo a rejected attempt by subtraction, which spoils the state when the
// attempt was far too long. A step that had rejections is therefore taken again from the exact
// start with the length that was accepted.
void TsStepper::take(double end) {
  const QuietErrors quiet;
  long rejected = rejected_steps();
  attempt(end);
  while (rejected_steps() > rejected) {
    rejected = rejected_steps();
    const double accepted = time_;
    undo();
    attempt(accepted);
  }
  unload();
  if (!state_.allFinite())
    throw NumericalError("the state is no longer finite at t = " + std::to_string(time_) + " s");
}

void TsStepper::step(double limit) {
  previous_time_ = time_;
  previous_state_ = state_;
  const double wanted = std::min(natural_step_, maximum_step_);
  // A last sliver shorter than the rounding of the step before would be no step at all.
  const bool limited = previous_time_ + wanted * (1 + 1e-9) >= limit;
  take(limited ? limit : previous_time_ + wanted);
  double proposed = 0;
  check(TSGetTimeStep(ts_, &proposed), "TSGetTimeStep");
  // After a step that was cut short the old proposal is the better one, if it was not rejected.
  natural_step_ = limited && time_ >= limit ? std::max(proposed, natural_step_) : proposed;
  if (limited && std::abs(time_ - limit) <= 4e-16 * std::abs(limit))
    time_ = limit;
}

void TsStepper::undo() {
  check(TSRollBack(ts_), "TSRollBack");
  // The methods undo a step by subtraction; the copy is exact.
  load(previous_state_);
  time_ = previous_time_;
  state_ = previous_state_;
}

void TsStepper::shorten(double time) {
  const double natural = natural_step_;
  undo();
  take(time);
  natural_step_ = natural;
}

long TsStepper::rejected_steps() const {
  PetscInt rejected = 0;
  TSGetStepRejections(ts_, &rejected);
  return rejected;
}

} // namespace vibroimpact
