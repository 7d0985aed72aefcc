// What a run will cost, estimated before it starts.
#pragma once

#include "analyses/analysis.h"

#include <string>

namespace vibroimpact {

/// "12 coordinates, 240 points, at most 2512 s of motion, about 35 s of computing": by the first
/// stretch of the motion, integrated on the spot for a moment. Recording costs more than that.
std::string cost_sentence(const Analysis &analysis, const System &system, std::size_t repetitions);

/// "5 modes from 2.95 Hz to 351.4 Hz, 3 points"
std::string body_sentence(const ReducedBody &body);

} // namespace vibroimpact
