// A function that is a polynomial of degree two, as a matrix.
#pragma once

#include "common/linear_algebra.h"

#include <functional>
#include <optional>

namespace vibroimpact::motion {

/// The symmetric D for which f(x) = [x, 1] D [x, 1]^T, from values of f: size (n + 1) x (n + 1).
/// None when f is no such polynomial.
std::optional<Matrix> quadratic_form(const std::function<double(const Vector &)> &f, Index n);

} // namespace vibroimpact::motion
