// What a run will cost, estimated from the model before anything is integrated.
#pragma once

#include "analyses/analysis.h"

#include <string>

namespace vibroimpact {

/// "12 coordinates, 240 points, at most 2512 s of motion, about 35 s of computing": steps from the
/// highest frequency and the tolerance, time per step measured on the equations.
std::string cost_sentence(const Analysis &analysis, const System &system, std::size_t repetitions);

/// "5 modes from 2.95 Hz to 351.4 Hz, 3 points"
std::string body_sentence(const ReducedBody &body);

} // namespace vibroimpact
