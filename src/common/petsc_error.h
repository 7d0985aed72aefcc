// What PETSc and SLEPc say when one of their calls fails.
#pragma once

#include <string>

namespace vibroimpact {

/// From now on the libraries print no trace of a failed call; its reason is kept instead. After
/// PetscInitialize().
void keep_petsc_errors();

/// The reason of the newest failed call, "" when none is kept; forgotten by this.
std::string taken_petsc_error();

} // namespace vibroimpact
