#include "common/petsc_stage.h"

#include <petscsys.h>

namespace vibroimpact {

void begin_petsc_log() {
  PetscBool wanted = PETSC_FALSE;
  PetscOptionsHasName(nullptr, nullptr, "-log_view", &wanted);
  if (wanted)
    PetscLogDefaultBegin();
}

PetscStage::PetscStage(const char *name) {
  PetscLogStage stage = -1;
  PetscLogStageGetId(name, &stage);
  if (stage < 0)
    PetscLogStageRegister(name, &stage);
  PetscLogStagePush(stage);
}

PetscStage::~PetscStage() { PetscLogStagePop(); }

} // namespace vibroimpact
