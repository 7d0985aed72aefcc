// What laws see of a motion, as linear forms of what a linear phase computes.
#pragma once

#include "motion/interval/guard_products.h"
#include "motion/system/linear_system.h"

namespace vibroimpact::motion {

/// A form of the local state of a contact whose present mode is affine, or that sees no forces.
LinearRow linear_row(const Equations &equations, std::size_t contact,
                     const contact::AffineForm &form);

/// A form with the partial derivatives of the margin at a state in place of the margin; its
/// constant is that of no value.
contact::AffineForm without_margin(const Equations &equations, std::size_t contact,
                                   const contact::AffineForm &form, double time,
                                   const Vector &state);

/// The gradient of such a form in any modes, at a state; its constant is that of no value.
LinearRow tangent_row(const Equations &equations, std::size_t contact,
                      const contact::AffineForm &form, double time, const Vector &state);

/// The force along a direction in a mode that is affine: that of the law, or the one that holds it.
contact::AffineForm force_along(const contact::Mode &mode, int direction);

/// The guards of the contacts' present modes: constants + rows * [y, sources]. Those that are sums
/// of squares have the forms of these behind all guards, and rows of no value.
struct GuardForms {
  Matrix rows;      ///< forms x (physical size + 3 sources)
  Vector constants; ///< forms
  /// None: a guard of a circular gap is of another kind.
  std::optional<std::vector<GuardProduct>> products = std::vector<GuardProduct>{};

  Index n_guards() const;
};

GuardForms guard_forms(const Equations &equations);

} // namespace vibroimpact::motion
