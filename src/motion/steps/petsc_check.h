// PETSc's error codes as NumericalError.
#pragma once

#include "common/error.h"

#include <petscsys.h>

#include <string>

namespace vibroimpact::motion {

inline std::string petsc_error_text(PetscErrorCode code) {
  const char *text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  return text ? text : "unknown error";
}

// PETSc's own handler would print a stack trace; the code it returns says enough.
inline void check_petsc(PetscErrorCode code, const char *call) {
  if (code != 0)
    throw NumericalError(std::string(call) + " failed: " + petsc_error_text(code));
}

} // namespace vibroimpact::motion
