// SUNDIALS CVODE, Adams or backward differentiation, contact changes and turning points of the
// recorded displacement as roots; the method is initialised anew at each contact change.
#pragma once

#include "measurement.h"

#include "common/error.h"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <limits>
#include <memory>

namespace vibroimpact::benchmarks {

inline void check_cvode(int flag, const char *call) {
  if (flag < 0)
    throw NumericalError(std::string(call) + " failed with " + std::to_string(flag));
}

template <class System> class CvodeMotion {
public:
  using State = typename System::State;
  enum Method { adams = CV_ADAMS, bdf = CV_BDF };

  CvodeMotion(Method method, const System &system, const State &start, double end,
              const Tolerance &tolerance, bool records)
      : begin_(system), system_(system), start_(start), end_(end), records_(records) {
    SUNContext_Create(nullptr, &context_);
    y_ = N_VMake_Serial(System::size, state_.data(), context_);
    state_ = start;
    cvode_ = CVodeCreate(method, context_);
    check_cvode(CVodeInit(cvode_, rates, 0, y_), "CVodeInit");
    check_cvode(CVodeSetUserData(cvode_, this), "CVodeSetUserData");
    check_cvode(CVodeSStolerances(cvode_, tolerance.relative, tolerance.absolute),
                "CVodeSStolerances");
    check_cvode(CVodeSetMaxNumSteps(cvode_, -1), "CVodeSetMaxNumSteps");
    if (method == adams) {
      nonlinear_ = SUNNonlinSol_FixedPoint(y_, 0, context_);
      check_cvode(CVodeSetNonlinearSolver(cvode_, nonlinear_), "CVodeSetNonlinearSolver");
    } else {
      matrix_ = SUNDenseMatrix(System::size, System::size, context_);
      linear_ = SUNLinSol_Dense(y_, matrix_, context_);
      check_cvode(CVodeSetLinearSolver(cvode_, linear_, matrix_), "CVodeSetLinearSolver");
    }
    const int n_roots = static_cast<int>(System::contacts) + records;
    if (n_roots == 0)
      return;
    check_cvode(CVodeRootInit(cvode_, n_roots, roots), "CVodeRootInit");
    std::array<int, System::contacts + 1> direction{};
    direction.fill(-1);
    direction[System::contacts] = 0;
    check_cvode(CVodeSetRootDirection(cvode_, direction.data()), "CVodeSetRootDirection");
    check_cvode(CVodeSetNoInactiveRootWarn(cvode_), "CVodeSetNoInactiveRootWarn");
  }

  ~CvodeMotion() {
    CVodeFree(&cvode_);
    if (nonlinear_)
      SUNNonlinSolFree(nonlinear_);
    if (linear_)
      SUNLinSolFree(linear_);
    if (matrix_)
      SUNMatDestroy(matrix_);
    N_VDestroy(y_);
    SUNContext_Free(&context_);
  }
  CvodeMotion(const CvodeMotion &) = delete;
  CvodeMotion &operator=(const CvodeMotion &) = delete;

  Outcome run() {
    system_ = begin_;
    state_ = start_;
    lowest_ = std::numeric_limits<double>::infinity();
    highest_ = -lowest_;
    steps_ = 0;
    double time = 0;
    restart(time);
    while (time < end_) {
      const int flag = CVode(cvode_, end_, y_, &time, CV_NORMAL);
      check_cvode(flag, "CVode");
      if (flag == CV_ROOT_RETURN)
        pass_roots(time);
    }
    count_steps();
    return {.excursion = records_ ? highest_ - lowest_ : 0,
            .contacts = {system_.begun.begin(), system_.begun.end()},
            .steps = steps_,
            .evaluations = system_.evaluations};
  }

private:
  static int rates(double time, N_Vector y, N_Vector dydt, void *self) {
    auto &motion = *static_cast<CvodeMotion *>(self);
    motion.system_(*reinterpret_cast<const State *>(N_VGetArrayPointer(y)),
                   *reinterpret_cast<State *>(N_VGetArrayPointer(dydt)), time);
    return 0;
  }
  static int roots(double time, N_Vector y, double *values, void *self) {
    const auto &motion = *static_cast<CvodeMotion *>(self);
    const State &x = *reinterpret_cast<const State *>(N_VGetArrayPointer(y));
    for (std::size_t i = 0; i < System::contacts; ++i)
      values[i] = motion.system_.guard(i, x);
    if (motion.records_)
      values[System::contacts] = motion.system_.recorded_rate(x, time);
    return 0;
  }

  void restart(double time) {
    check_cvode(CVodeReInit(cvode_, time, y_), "CVodeReInit");
    check_cvode(CVodeSetStopTime(cvode_, end_), "CVodeSetStopTime");
  }

  void count_steps() {
    long count = 0;
    CVodeGetNumSteps(cvode_, &count);
    steps_ += count;
  }

  void pass_roots(double time) {
    std::array<int, System::contacts + 1> found{};
    check_cvode(CVodeGetRootInfo(cvode_, found.data()), "CVodeGetRootInfo");
    if (found[System::contacts] != 0) {
      lowest_ = std::min(lowest_, system_.recorded(state_, time));
      highest_ = std::max(highest_, system_.recorded(state_, time));
    }
    bool changed = false;
    for (std::size_t i = 0; i < System::contacts; ++i)
      if (found[i] != 0) {
        system_.pass(i, state_);
        changed = true;
      }
    if (changed) {
      count_steps();
      restart(time);
    }
  }

  System begin_, system_;
  State start_, state_{};
  double end_;
  bool records_;
  SUNContext context_ = nullptr;
  void *cvode_ = nullptr;
  N_Vector y_ = nullptr;
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver linear_ = nullptr;
  SUNNonlinearSolver nonlinear_ = nullptr;
  double lowest_ = 0, highest_ = 0;
  long steps_ = 0;
};

template <class System>
Side cvode_side(const std::string &name, typename CvodeMotion<System>::Method method,
                const System &system, const typename System::State &start, double end) {
  return {.name = name, .prepare = [=](const Tolerance &tolerance, bool records) {
            auto motion = std::make_shared<CvodeMotion<System>>(method, system, start, end,
                                                                tolerance, records);
            return Motion([motion] { return motion->run(); });
          }};
}

} // namespace vibroimpact::benchmarks
