#include "common/petsc_error.h"

#include <petscsys.h>

#include <utility>

namespace vibroimpact {

namespace {

std::string kept;

/// Called once where the failure is found, and again by each function that the error passes.
PetscErrorCode keep(MPI_Comm /*communicator*/, int /*line*/, const char * /*function*/,
                    const char * /*file*/, PetscErrorCode code, PetscErrorType type,
                    const char *message, void * /*context*/) {
  if (type == PETSC_ERROR_INITIAL)
    kept = message == nullptr ? "" : message;
  return code;
}

} // namespace

void keep_petsc_errors() { PetscPushErrorHandler(keep, nullptr); }

std::string taken_petsc_error() {
  std::string reason = std::exchange(kept, "");
  while (!reason.empty() && (reason.back() == '\n' || reason.back() == '.'))
    reason.pop_back();
  return reason;
}

} // namespace vibroimpact
