// The guards of the contacts' present modes as linear forms of what a linear phase computes.
#pragma once

#include "integration/linear_system.h"

namespace vibroimpact {

/// constants + rows * [y, then s, s', s'' of each source]
struct GuardForms {
  Matrix rows;      ///< guards x (physical size + 3 sources)
  Vector constants; ///< guards
};

/// For the present modes; `system` is that of the same modes.
GuardForms guard_forms(const Equations &equations, const LinearSystem &system);

} // namespace vibroimpact
