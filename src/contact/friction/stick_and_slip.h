// What laws with true stick have in common: two sides stick until the force that this takes reaches
// a limit, and slip one way or the other until the slip rate is zero.
#pragma once

#include "contact/friction/tangential_law.h"

namespace vibroimpact::contact {

/// The mode that holds the slip rate until the force that does it reaches `most`; then the sides
/// slip in mode `forward` or `backward`.
TangentialMode stick_until(const AffineForm &most, int forward, int backward);

/// Slip with sigma = +-1 the sign of the slip rate, without a force yet; it ends in mode `stick`.
TangentialMode slip_along(double sigma, int stick);

} // namespace vibroimpact::contact
