// Gauss-Legendre nodes on a step: exact for polynomials up to degree 19, and so for squares of what
// the dense output gives.
#pragma once

#include <array>

namespace vibroimpact::analyses {

struct QuadratureNode {
  double tau = 0;    ///< in the step, 0 ... 1
  double weight = 0; ///< the weights add up to 1
};

const std::array<QuadratureNode, 10> &step_nodes();

} // namespace vibroimpact::analyses
