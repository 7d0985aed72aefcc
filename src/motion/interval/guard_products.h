// Guards in linear phases that are sums of squares of linear forms: of circular gaps, and of
// friction along two directions.
//
// Of a guard a g + b with the gap g = s (c - |u|), b a constant or a form of internal states,
//
//   a s ((c + s b / a)^2 - u_1^2 - u_2^2) / (2 c)
//
// has the zeros and the signs, as long as the first term is not negative. A margin of friction is
// r^2 - f_1^2 - f_2^2 itself. The three factors are linear forms of what a linear phase computes.
#pragma once

#include "motion/system/equations.h"

#include <array>
#include <optional>
#include <vector>

namespace vibroimpact::motion {

struct GuardProduct {
  Index guard = 0;   ///< its place among the guards of the present modes
  Index factors = 0; ///< the place of the first form among the rows of GuardForms
  std::size_t contact = 0;
  std::array<contact::AffineForm, 3> forms{}; ///< the first counts positive, the others negative
  double scale = 0;                           ///< of their squares: a s / (2 c), or 1
};

/// Is it of a circular gap alone?
bool is_product(const contact::AffineForm &form);

/// Those of the present modes; empty where there are none. std::nullopt where a guard of a circular
/// gap is of another kind.
std::optional<std::vector<GuardProduct>> guard_products(const Equations &equations);

/// c + s b / a as a form of the local state: of a constant and internal states.
contact::AffineForm touching_radius(const contact::CircularGap &circle,
                                    const contact::AffineForm &form);

} // namespace vibroimpact::motion
