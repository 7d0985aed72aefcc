// All instants at which a polynomial of the dense output changes its sign.
#pragma once

#include "motion/interval/bernstein.h"

#include <vector>

namespace vibroimpact::analyses {

/// Increasing tau in (0, 1] at which the polynomial changes its sign or arrives at zero; a zero at
/// the start belongs to what came before. Between neighbouring zeros of its derivative, found the
/// same way, a polynomial has one zero at most, so none is missed.
std::vector<double> sign_changes(const motion::Bernstein &polynomial);

} // namespace vibroimpact::analyses
