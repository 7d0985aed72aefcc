// Stages of a run in the table that PETSc prints for -log_view.
#pragma once

namespace vibroimpact {

/// From now on PETSc measures, where one of its options asks for it. After the options are set.
void begin_petsc_log();

/// What PETSc does during the life of the object counts for the stage of this name. All ranks go
/// through the same stages in the same order.
class PetscStage {
public:
  explicit PetscStage(const char *name);
  ~PetscStage();
  PetscStage(const PetscStage &) = delete;
  PetscStage &operator=(const PetscStage &) = delete;
};

} // namespace vibroimpact
