// A cantilever with twenty modes, driven at its tip, against a linear spring: the equations of both
// sides of a comparison.
#pragma once

#include "equations_by_hand.h"
#include "vibroimpact_side.h"

namespace vibroimpact::benchmarks {

constexpr int modes_on_stop = 20;
using BeamOnStop = ModalBeams<modes_on_stop, modes_on_stop, LinearSpring>;

struct BeamOnStopEquations {
  Problem problem; ///< without its end
  BeamOnStop system;
};
BeamOnStopEquations beam_on_stop_equations();

} // namespace vibroimpact::benchmarks
