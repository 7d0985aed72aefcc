#include "motion/steps/motion_ts.h"

#include "motion/steps/petsc_check.h"

#include <petsc/private/tsimpl.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <limits>
#include <utility>

namespace vibroimpact::motion {

struct MotionTs::Data {
  TS ts = nullptr;
  Vec solution = nullptr;
  Settings settings;
  const std::function<const Vector &()> *advance = nullptr;
  double end = 0;             ///< of the present step [s]
  std::exception_ptr failure; ///< exceptions must not pass through PETSc
  bool seen = false;          ///< the view was printed

  void load(const Vector &state) const {
    PetscScalar *array = nullptr;
    check_petsc(VecGetArrayWrite(solution, &array), "VecGetArrayWrite");
    std::copy(state.data(), state.data() + state.size(), array);
    check_petsc(VecRestoreArrayWrite(solution, &array), "VecRestoreArrayWrite");
  }

  static PetscErrorCode step(TS ts) {
    auto &data = *static_cast<Data *>(ts->data);
    try {
      data.load((*data.advance)());
      ts->ptime = data.end;
    } catch (...) {
      data.failure = std::current_exception();
      ts->reason = TS_CONVERGED_USER; // no failure of PETSc
    }
    return 0;
  }

  static PetscErrorCode view(TS ts, PetscViewer viewer) {
    const auto &data = *static_cast<Data *>(ts->data);
    PetscViewerASCIIPrintf(viewer, "  method within phases: %s\n", data.settings.method.c_str());
    PetscViewerASCIIPrintf(viewer, "  relative tolerance: %g, event tolerance: %g s\n",
                           data.settings.relative_tolerance, data.settings.event_tolerance);
    return 0;
  }

  static PetscErrorCode nothing(TS /*ts*/) { return 0; }

  static PetscErrorCode make(TS ts) {
    ts->ops->step = step;
    ts->ops->view = view;
    ts->ops->destroy = nothing;
    ts->usessnes = PETSC_FALSE;
    return 0;
  }
};

namespace {

constexpr const char *type = "motion";

bool wanted() {
  PetscBool ready = PETSC_FALSE;
  PetscInitialized(&ready);
  if (!ready) // motions by the exact method need no PETSc
    return false;
  char *all = nullptr;
  check_petsc(PetscOptionsGetAll(nullptr, &all), "PetscOptionsGetAll");
  const bool found = all && std::strstr(all, "-ts_") != nullptr;
  PetscFree(all);
  return found;
}

} // namespace

std::unique_ptr<MotionTs> MotionTs::create(const Settings &settings, Index size) {
  return wanted() ? std::unique_ptr<MotionTs>(new MotionTs(settings, size)) : nullptr;
}

MotionTs::MotionTs(const Settings &settings, Index size) : data_(std::make_unique<Data>()) {
  data_->settings = settings;
  check_petsc(TSRegister(type, Data::make), "TSRegister");
  check_petsc(VecCreateSeq(PETSC_COMM_SELF, static_cast<PetscInt>(size), &data_->solution),
              "VecCreateSeq");
  check_petsc(TSCreate(PETSC_COMM_SELF, &data_->ts), "TSCreate");
  check_petsc(TSSetProblemType(data_->ts, TS_NONLINEAR), "TSSetProblemType");
  check_petsc(TSSetType(data_->ts, type), "TSSetType");
  data_->ts->data = data_.get();
  check_petsc(TSSetSolution(data_->ts, data_->solution), "TSSetSolution");
  check_petsc(TSSetTolerances(data_->ts, settings.absolute_tolerance, nullptr,
                              settings.relative_tolerance, nullptr),
              "TSSetTolerances");
  check_petsc(TSSetExactFinalTime(data_->ts, TS_EXACTFINALTIME_STEPOVER), "TSSetExactFinalTime");
  check_petsc(TSSetMaxSteps(data_->ts, std::numeric_limits<PetscInt>::max() - 1), "TSSetMaxSteps");
  check_petsc(TSSetMaxTime(data_->ts, std::numeric_limits<double>::max()), "TSSetMaxTime");
  check_petsc(TSSetFromOptions(data_->ts), "TSSetFromOptions");
  TSType chosen = nullptr;
  check_petsc(TSGetType(data_->ts, &chosen), "TSGetType");
  if (std::strcmp(chosen, type) != 0)
    throw InputError("--petsc -ts_type " + std::string(chosen) +
                     ": the integrator of motions is always " + type +
                     "; that within phases is set by Method or -sub_ts_type.");
}

MotionTs::~MotionTs() {
  TSDestroy(&data_->ts);
  VecDestroy(&data_->solution);
}

void MotionTs::step(double start, const Vector &state, double end,
                    const std::function<const Vector &()> &advance) {
  TS ts = data_->ts;
  data_->advance = &advance;
  data_->end = end;
  data_->load(state);
  check_petsc(TSSetTime(ts, start), "TSSetTime");
  check_petsc(TSSetTimeStep(ts, end - start), "TSSetTimeStep");
  check_petsc(TSSetConvergedReason(ts, TS_CONVERGED_ITERATING), "TSSetConvergedReason");
  PetscInt number = 0;
  check_petsc(TSGetStepNumber(ts, &number), "TSGetStepNumber");
  if (number == 0)
    check_petsc(TSMonitor(ts, number, start, data_->solution), "TSMonitor");
  const PetscErrorCode code = TSStep(ts);
  if (data_->failure)
    std::rethrow_exception(std::exchange(data_->failure, nullptr));
  check_petsc(code, "TSStep");
  check_petsc(TSMonitor(ts, number + 1, end, data_->solution), "TSMonitor");
  if (!std::exchange(data_->seen, true))
    check_petsc(TSViewFromOptions(ts, nullptr, "-ts_view"), "TSViewFromOptions");
}

} // namespace vibroimpact::motion
