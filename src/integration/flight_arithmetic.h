// The arithmetic of the flight kernel.
//
// The files that use it fuse no multiplication with an addition, so that contact changes are the
// same to the last bit on every machine.
#pragma once

#include <algorithm>
#include <cmath>

namespace vibroimpact::integration::flight_arithmetic {

constexpr double value_error = 1.0 / 384;
constexpr double slope_error = 1.7320508075688772 / 216;
constexpr double epsilon = 0x1p-52;
constexpr double rounding_factor = 64 * epsilon;
/// Parts of what rounding may hide: a guard below the first must change by the second in a piece.
constexpr double near_zero = 4;
constexpr double least_change = 0.25;
constexpr double halvings = 24;
constexpr double corrections = 60;
/// A zero is found when the value left is this part of what rounding may hide.
constexpr double negligible_part = 0.02;
/// Largest |exponent| times time of a short move: the cube over 6 is far below rounding.
constexpr double short_reach = 4e-6;

/// Value and slope of a guard.
struct Height {
  double value, slope;
};

/// One group's part of a guard.
inline void add_group(double coefficient_real, double coefficient_imaginary, double amplitude_real,
                      double amplitude_imaginary, double rate, double frequency, Height &height) {
  const double x = coefficient_real * amplitude_real - coefficient_imaginary * amplitude_imaginary;
  const double y = coefficient_real * amplitude_imaginary + coefficient_imaginary * amplitude_real;
  height.value = height.value + x;
  height.slope = height.slope + (x * rate - y * frequency);
}

/// Turns and shrinks an amplitude.
inline void rotate(double real, double imaginary, double factor, double sine, double cosine,
                   double &to_real, double &to_imaginary) {
  const double c = factor * cosine;
  const double s = factor * sine;
  to_real = real * c - imaginary * s;
  to_imaginary = real * s + imaginary * c;
}

/// The same over a time so short that two terms of the exponential's series do.
inline void rotate_little(double rate, double frequency, double time, double &real,
                          double &imaginary, double &size) {
  const double x = rate * time;
  const double y = frequency * time;
  const double c = 1 + (x + 0.5 * (x * x - y * y));
  const double s = y + x * y;
  const double turned = real * c - imaginary * s;
  imaginary = real * s + imaginary * c;
  real = turned;
  size = size + size * x;
}

/// Longest piece that is worth trying, found from all guards: where the error is a third of the
/// value of one, and a little beyond the zero of the straight line, further than rounding can hide.
class Trial {
public:
  explicit Trial(double limit) : longest_(limit) {}

  void add(const Height &start, double bound, double margin) {
    ratio_ = std::min(ratio_, start.value / bound);
    if (!(start.slope < 0))
      return;
    const double by_slope = (-1.2 * start.value - 8 * margin) / start.slope;
    longest_ = std::min(longest_, by_slope);
    if (start.value < near_zero * margin)
      shortest_ = std::max(shortest_, least_change * margin / std::abs(start.slope));
  }
  /// Where a guard falls near zero, shorter pieces change nothing, by rounding, and many of them
  /// would lead past a zero.
  double shortest() const { return shortest_; }
  double length() const {
    return std::min(longest_, std::sqrt(std::sqrt((0.3 / value_error) * ratio_)));
  }

private:
  double longest_;
  double shortest_ = 0;
  double ratio_ = 1e300; ///< least value over bound of the fourth derivative
};

/// Length of a piece with what judging needs of it.
struct Span {
  double third, value_error, slope_error; ///< h / 3; error per bound of the fourth derivative
  explicit Span(double h) : third(h / 3), value_error(), slope_error() {
    const double square = h * h;
    const double fourth = square * square;
    value_error = flight_arithmetic::value_error * fourth;
    slope_error = flight_arithmetic::slope_error * fourth;
  }
};

/// True: proven positive in the piece.
inline bool positive(const Height &start, const Height &end, const Span &span, double bound,
                     double margin) {
  const double b1 = start.value + span.third * start.slope;
  const double b2 = end.value - span.third * end.slope;
  const double lowest = std::min(std::min(start.value, b1), std::min(b2, end.value));
  return lowest > span.value_error * bound + margin;
}

/// The same for a guard that rises from an exact zero at the start: near it the error
/// t^2 (h - t)^2 / 24 max|f''''| vanishes faster than f.
inline bool positive_from_zero(const Height &start, const Height &end, const Span &span,
                               double bound, double margin) {
  const double b1 = start.value + span.third * start.slope;
  const double b2 = end.value - span.third * end.slope;
  return b1 > 0 && 3 * b2 > 16 * (span.value_error * bound) + margin && end.value > margin;
}

/// True: proven to fall all along, to below zero.
inline bool falling(const Height &start, const Height &end, const Span &span, double bound,
                    double margin) {
  const double b1 = start.value + span.third * start.slope;
  const double b2 = end.value - span.third * end.slope;
  const double steepest = std::max(b1 - start.value, std::max(b2 - b1, end.value - b2)) * 3;
  return end.value < -margin && steepest + span.slope_error * bound + margin < 0;
}

/// Near the zero of the cubic of a piece [s] in which a guard falls from above zero to below it.
inline double zero_of_cubic(const Height &start, const Height &end, double h) {
  const double a = h * start.slope;
  const double drop = end.value - start.value;
  const double quadratic = 3 * drop - (a + a) - h * end.slope;
  const double cubic = drop - a - quadratic;
  double u = start.value / (start.value - end.value);
  for (int i = 0; i < 3; ++i) {
    const double value = start.value + u * (a + u * (quadratic + u * cubic));
    const double slope = a + u * ((quadratic + quadratic) + u * (3 * cubic));
    const double next = u - value / slope;
    if (next > 0 && next < 1)
      u = next;
  }
  return u * h;
}

/// What is known of a zero.
struct Bracket {
  double low, high;

  /// Narrows at `instant` and says where to look next.
  double next(double instant, const Height &there) {
    (there.value > 0 ? low : high) = instant;
    const double wanted = instant - there.value / there.slope;
    return wanted > low && wanted < high ? wanted : 0.5 * (low + high);
  }
};

} // namespace vibroimpact::integration::flight_arithmetic
