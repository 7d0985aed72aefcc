// Zeros of functions of one variable.
#pragma once

#include <functional>

namespace vibroimpact {

/// A zero between `low` and `high`, where the function has values of different sign, to rounding
/// (Alefeld, Potra and Shi's method, by Boost).
double zero_between(const std::function<double(double)> &function, double low, double high);

} // namespace vibroimpact
