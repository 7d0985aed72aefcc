// Cross-sections of the beams of a body as they are drawn.
#pragma once

#include "common/linear_algebra.h"
#include "parameters/values.h"

#include <mpi.h>

#include <string>
#include <vector>

namespace vibroimpact::reduction {

/// Places around the cross-section of each of Recovery::lines, from the line in global axes: 3 x k
/// [m]. Of several beams on a line the first counts; empty for bodies without beams. Collective.
/// `body` is the subsection, `folder` that of the parameter file, as for reduce_body(), which must
/// have accepted them.
std::vector<Matrix> beam_outlines(const parameters::Values &body, const std::string &name,
                                  const std::string &folder, MPI_Comm communicator);

} // namespace vibroimpact::reduction
