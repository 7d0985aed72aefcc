// How a meshed body answers at its points before it is reduced: to static forces, and to impulses.
#pragma once

#include "modes/rayleigh_ritz.h"
#include "structure/assembly.h"

namespace vibroimpact::reduction {

struct PointResponse {
  Vector deflection;               ///< of the mesh under the loads of the body; empty without loads
  std::vector<Matrix> flexibility; ///< of each point, see BodyPoint; empty for a free body
  std::vector<Matrix> inverse_mass; ///< of each point, see BodyPoint; empty where it has none
};

/// `problem`: of the body; what it has factorised is given back. `held`: supports hold the body
/// against every rigid motion. Collective. Throws NumericalError.
PointResponse point_response(const structure::AssembledBody &body,
                             const modes::EigenProblem &problem, bool held);

} // namespace vibroimpact::reduction
