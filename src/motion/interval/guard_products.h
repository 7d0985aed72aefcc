// Guards of circular gaps in linear phases: products of linear forms.
//
// Of a guard a g + b with the gap g = s (c - |u|), b a constant or a form of internal states,
//
//   a s ((c + s b / a)^2 - u_1^2 - u_2^2) / (2 c)
//
// has the zeros and the signs, as long as the first term is not negative. Its three factors are
// linear forms of what a linear phase computes.
#pragma once

#include "motion/system/equations.h"

#include <vector>

namespace vibroimpact::motion {

struct GuardProduct {
  Index guard = 0;   ///< its place among the guards of the present modes
  Index factors = 0; ///< the place of c + s b / a among the rows of GuardForms; u_1 and u_2 follow
  std::size_t contact = 0;
  contact::AffineForm form{}; ///< a g + b
  double scale = 0;           ///< a s / (2 c)
};

/// Is it of that kind?
bool is_product(const contact::AffineForm &form);

/// Those of the present modes; empty where there is no circular gap. std::nullopt where a guard of
/// a circular gap is of another kind.
std::optional<std::vector<GuardProduct>> guard_products(const Equations &equations);

/// c + s b / a as a form of the local state: of a constant and internal states.
contact::AffineForm touching_radius(const contact::CircularGap &circle,
                                    const contact::AffineForm &form);

} // namespace vibroimpact::motion
