#include "integration/flight.h"

#include "integration/petsc_check.h"

#include <petsc/private/tsimpl.h>

namespace vibroimpact::integration {

namespace {

struct FlightData {
  FlightPropagator *propagator = nullptr;
  Vec start = nullptr; // state at the start of the last step
  PetscReal start_time = 0;
};

FlightData &data_of(TS ts) { return *static_cast<FlightData *>(ts->data); }

// The state at `time` after the start of the last step.
PetscErrorCode propagate(TS ts, PetscReal time, Vec result) {
  FlightData &data = data_of(ts);
  const PetscScalar *from = nullptr;
  PetscScalar *to = nullptr;
  PetscInt size = 0;
  PetscCall(VecGetSize(result, &size));
  PetscCall(VecGetArrayRead(data.start, &from));
  PetscCall(VecGetArrayWrite(result, &to));
  data.propagator->propagate(time - data.start_time, ConstVectorView(from, size),
                             VectorView(to, size));
  PetscCall(VecRestoreArrayWrite(result, &to));
  PetscCall(VecRestoreArrayRead(data.start, &from));
  return 0;
}

PetscErrorCode set_up(TS ts) {
  PetscCheck(data_of(ts).propagator, PetscObjectComm(reinterpret_cast<PetscObject>(ts)),
             PETSC_ERR_ORDER, "TS type flight needs a propagator");
  if (!data_of(ts).start)
    PetscCall(VecDuplicate(ts->vec_sol, &data_of(ts).start));
  return 0;
}

PetscErrorCode take_step(TS ts) {
  FlightData &data = data_of(ts);
  PetscCall(VecCopy(ts->vec_sol, data.start));
  data.start_time = ts->ptime;
  const PetscReal end = ts->ptime + ts->time_step;
  PetscCall(propagate(ts, end, ts->vec_sol));
  ts->ptime = end;
  return 0;
}

PetscErrorCode roll_back(TS ts) {
  PetscCall(VecCopy(data_of(ts).start, ts->vec_sol));
  return 0;
}

PetscErrorCode interpolate(TS ts, PetscReal time, Vec result) {
  return propagate(ts, time, result);
}

PetscErrorCode reset(TS ts) { return VecDestroy(&data_of(ts).start); }

PetscErrorCode destroy(TS ts) {
  PetscCall(reset(ts));
  delete static_cast<FlightData *>(ts->data);
  ts->data = nullptr;
  return 0;
}

PetscErrorCode view(TS /*ts*/, PetscViewer viewer) {
  return PetscViewerASCIIPrintf(viewer, "  exact propagation of linear phases\n");
}

PetscErrorCode create(TS ts) {
  ts->data = new FlightData;
  ts->ops->setup = set_up;
  ts->ops->step = take_step;
  ts->ops->rollback = roll_back;
  ts->ops->interpolate = interpolate;
  ts->ops->reset = reset;
  ts->ops->destroy = destroy;
  ts->ops->view = view;
  ts->default_adapt_type = TSADAPTNONE;
  return 0;
}

} // namespace

void register_flight() { check_petsc(TSRegister(flight_type, create), "TSRegister"); }

void set_flight_propagator(TS ts, FlightPropagator *propagator) {
  data_of(ts).propagator = propagator;
}

} // namespace vibroimpact::integration
