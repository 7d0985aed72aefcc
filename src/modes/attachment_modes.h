// Residual attachment modes: what the kept normal modes lack of the static answer to forces at
// given places.
#pragma once

#include "modes/normal_modes.h"

namespace vibroimpact::modes {

struct AttachmentModes {
  Vector eigenvalues; ///< omega^2 [rad^2/s^2] of the shapes among themselves, ascending
  Matrix shapes;      ///< rows as in the matrices; M-orthonormal, also to the kept modes
};

/// `loads`: a force in each column. The static answer of the body (of a free body: to the force
/// with the inertia forces of its rigid motion) less its part in the kept modes; the answers that
/// are left are made M-orthonormal and K-orthogonal. Those that the kept modes contain already are
/// left out. Together with the kept modes they answer a static force of the columns exactly.
/// Collective. Throws NumericalError.
AttachmentModes residual_attachment_modes(const EigenProblem &problem, const NormalModes &modes,
                                          const Matrix &loads);

} // namespace vibroimpact::modes
