// Zeros and minima of functions of one variable, by Boost.
#pragma once

#include <functional>
#include <limits>

namespace vibroimpact {

/// A zero between `low` and `high`, where the function has values of different sign, to `bits` of
/// its place, at most to rounding (Alefeld, Potra and Shi's method).
double zero_between(const std::function<double(double)> &function, double low, double high,
                    int bits = std::numeric_limits<double>::digits);

struct Minimum {
  double place = 0, value = 0;
};
/// A minimum between `low` and `high`, which may be one of the two (Brent's method): to half of the
/// digits of the place, which give all of the value.
Minimum minimum_between(const std::function<double(double)> &function, double low, double high);

} // namespace vibroimpact
