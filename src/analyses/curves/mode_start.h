// Where a nonlinear mode begins: at a linear mode of the whole system, its contacts open.
#pragma once

#include "analyses/run/system.h"
#include "parameters/values.h"

#include <optional>

namespace vibroimpact::analyses {

struct ModeStart {
  long mode = 1;                      ///< among all of the assembled system, by rising frequency
  double energy = 0, last_energy = 0; ///< [J]
  std::optional<parameters::Values> section{}; ///< for messages
};

struct LinearMode {
  double period = 0; ///< [s]
  Vector rest;       ///< state at rest, 2n
  Vector motion;     ///< from there, at the energy where the mode begins; 2n
};

/// Its motion passes the position at rest where no contact touches there, and otherwise turns where
/// the smallest gap is larger. InputError where the system has no such mode, where it is one of a
/// rigid body, and where an excitation changes with time.
LinearMode linear_mode(const System &system, const ModeStart &start);

} // namespace vibroimpact::analyses
