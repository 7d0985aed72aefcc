// PETSc and SLEPc objects that clean up after themselves, and error codes as exceptions.
#pragma once

#include "common/error.h"
#include "common/petsc_error.h"

#include <petscksp.h>

#include <string>
#include <utility>

namespace vibroimpact::structure::petsc {

/// Throws NumericalError when a PETSc call failed; `what` says what was being done.
inline void check(PetscErrorCode code, const char *what) {
  if (code == 0)
    return;
  const std::string reason = taken_petsc_error();
  throw NumericalError(std::string(what) + " failed" + (reason.empty() ? "" : ": " + reason) +
                       " (PETSc error " + std::to_string(code) + ")");
}

/// Owns one object, e.g. Object<Mat, MatDestroy>.
template <class Handle, PetscErrorCode (*destroy)(Handle *)> class Object {
public:
  Object() = default;
  explicit Object(Handle handle) : handle_(handle) {}
  Object(Object &&other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Object &operator=(Object &&other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  Object(const Object &) = delete;
  Object &operator=(const Object &) = delete;
  ~Object() {
    if (handle_ != nullptr)
      destroy(&handle_);
  }

  Handle get() const { return handle_; }
  /// For PETSc's create functions.
  Handle *address() { return &handle_; }

private:
  Handle handle_ = nullptr;
};

using Matrix = Object<Mat, MatDestroy>;
using Vector = Object<Vec, VecDestroy>;
using Solver = Object<KSP, KSPDestroy>;
using Scatter = Object<VecScatter, VecScatterDestroy>;
using IndexSet = Object<IS, ISDestroy>;

} // namespace vibroimpact::structure::petsc
