// The modes of bodies as tables of text, which a body of Type = modes reads.
#pragma once

#include "output/run_folder.h"
#include "reduction/reduced_body.h"

namespace vibroimpact::output {

/// A line for each mode: frequency [Hz; angular if dimensionless], damping ratio, modal mass [kg],
/// participation in a motion of the base [kg] and the mode shape at each point, with all digits.
/// Components that no mode moves are left out.
std::string mode_table(const reduction::ReducedBody &body, bool dimensionless);

/// modes/NAME.csv for each body whose coordinates are modes. Throws std::runtime_error.
void write_mode_tables(RunFolder &folder, const std::vector<reduction::ReducedBody> &bodies,
                       bool dimensionless);

} // namespace vibroimpact::output
