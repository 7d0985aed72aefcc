// What PETSc and SLEPc say when one of their calls fails.
#pragma once

#include <string>

namespace vibroimpact::petsc {

/// From now on the libraries print no trace of a failed call; its reason is kept instead. After
/// PetscInitialize().
void keep_errors();

/// The reason of the newest failed call, "" when none is kept; forgotten by this.
std::string taken_error();

} // namespace vibroimpact::petsc
