// The arithmetic of the flight kernel, once for a number and for packs of numbers.
//
// Lanes and the scalar kernel must agree to the last bit: both are made of these functions, none of
// which fuses a multiplication with an addition (the files that use them are compiled so), and of
// exp, sin and cos that are the same in all widths. A pack (in the files lane_kernel_*) brings the
// same operations as a number, and masks for truth values.
#pragma once

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

inline double select(bool condition, double a, double b) { return condition ? a : b; }
inline double square_root(double a) { return std::sqrt(a); }
inline double absolute(double a) { return std::abs(a); }

// The first where they cannot be compared.
template <class V> V smaller(V a, V b) { return select(b < a, b, a); }
template <class V> V larger(V a, V b) { return select(a < b, b, a); }

/// A guard, or several of them in lanes: value and slope.
template <class V> struct Height { V value, slope; };

/// One group's part of a guard.
template <class V>
void add_group(V coefficient_real, V coefficient_imaginary, V amplitude_real, V amplitude_imaginary,
               V rate, V frequency, Height<V> &height) {
  const V x = coefficient_real * amplitude_real - coefficient_imaginary * amplitude_imaginary;
  const V y = coefficient_real * amplitude_imaginary + coefficient_imaginary * amplitude_real;
  height.value = height.value + x;
  height.slope = height.slope + (x * rate - y * frequency);
}

/// Turns and shrinks an amplitude.
template <class V>
void rotate(V real, V imaginary, V factor, V sine, V cosine, V &to_real, V &to_imaginary) {
  const V c = factor * cosine;
  const V s = factor * sine;
  to_real = real * c - imaginary * s;
  to_imaginary = real * s + imaginary * c;
}

/// The same over a time so short that two terms of the exponential's series do.
template <class V> void rotate_little(V rate, V frequency, V time, V &real, V &imaginary, V &size) {
  const V x = rate * time;
  const V y = frequency * time;
  const V c = V(1.0) + (x + V(0.5) * (x * x - y * y));
  const V s = y + x * y;
  const V turned = real * c - imaginary * s;
  imaginary = real * s + imaginary * c;
  real = turned;
  size = size + size * x;
}

/// Longest piece that is worth trying, found from all guards: where the error is a third of the
/// value of one, and a little beyond the zero of the straight line, further than rounding can hide.
template <class V> class Trial {
public:
  explicit Trial(V limit) : longest_(limit), shortest_(0.0), ratio_(1e300) {}

  void add(const Height<V> &start, V bound, V margin) {
    ratio_ = smaller(ratio_, start.value / bound);
    const V by_slope = (V(-1.2) * start.value - V(8.0) * margin) / start.slope;
    longest_ = select(start.slope < V(0.0), smaller(longest_, by_slope), longest_);
    const auto creeps = (start.slope < V(0.0)) & (start.value < V(near_zero) * margin);
    const V least = V(least_change) * margin / absolute(start.slope);
    shortest_ = select(creeps, larger(shortest_, least), shortest_);
  }
  /// Where a guard falls near zero, shorter pieces change nothing, by rounding, and many of them
  /// would lead past a zero.
  V shortest() const { return shortest_; }
  V length() const {
    return smaller(longest_, square_root(square_root(V(0.3 / value_error) * ratio_)));
  }

private:
  V longest_, shortest_;
  V ratio_; ///< least value over bound of the fourth derivative
};

/// Length of a piece with what judging needs of it.
template <class V> struct Span {
  V third, value_error, slope_error; ///< h / 3; error per bound of the fourth derivative
  explicit Span(V h) : third(h / V(3.0)), value_error(), slope_error() {
    const V square = h * h;
    const V fourth = square * square;
    value_error = V(flight_arithmetic::value_error) * fourth;
    slope_error = V(flight_arithmetic::slope_error) * fourth;
  }
};

/// True: proven positive in the piece.
template <class V>
auto positive(const Height<V> &start, const Height<V> &end, const Span<V> &span, V bound,
              V margin) {
  const V b1 = start.value + span.third * start.slope;
  const V b2 = end.value - span.third * end.slope;
  const V lowest = smaller(smaller(start.value, b1), smaller(b2, end.value));
  return lowest > span.value_error * bound + margin;
}

/// The same for a guard that rises from an exact zero at the start: near it the error
/// t^2 (h - t)^2 / 24 max|f''''| vanishes faster than f.
template <class V>
auto positive_from_zero(const Height<V> &start, const Height<V> &end, const Span<V> &span, V bound,
                        V margin) {
  const V b1 = start.value + span.third * start.slope;
  const V b2 = end.value - span.third * end.slope;
  return (b1 > V(0.0)) & (V(3.0) * b2 > V(16.0) * (span.value_error * bound) + margin) &
         (end.value > margin);
}

/// True: proven to fall all along, to below zero.
template <class V>
auto falling(const Height<V> &start, const Height<V> &end, const Span<V> &span, V bound, V margin) {
  const V b1 = start.value + span.third * start.slope;
  const V b2 = end.value - span.third * end.slope;
  const V steepest = larger(b1 - start.value, larger(b2 - b1, end.value - b2)) * V(3.0);
  return (end.value < V(0.0) - margin) & (steepest + span.slope_error * bound + margin < V(0.0));
}

/// Near the zero of the cubic of a piece [s] in which a guard falls from above zero to below it.
template <class V> V zero_of_cubic(const Height<V> &start, const Height<V> &end, V h) {
  const V a = h * start.slope;
  const V drop = end.value - start.value;
  const V quadratic = V(3.0) * drop - (a + a) - h * end.slope;
  const V cubic = drop - a - quadratic;
  V u = start.value / (start.value - end.value);
  for (int i = 0; i < 3; ++i) {
    const V value = start.value + u * (a + u * (quadratic + u * cubic));
    const V slope = a + u * ((quadratic + quadratic) + u * (V(3.0) * cubic));
    const V next = u - value / slope;
    u = select((next > V(0.0)) & (next < V(1.0)), next, u);
  }
  return u * h;
}

/// What is known of a zero.
template <class V> struct Bracket {
  V low, high;

  /// Narrows at `instant` and says where to look next.
  V next(V instant, const Height<V> &there) {
    const auto above = there.value > V(0.0);
    low = select(above, instant, low);
    high = select(above, high, instant);
    const V wanted = instant - there.value / there.slope;
    return select((wanted > low) & (wanted < high), wanted, V(0.5) * (low + high));
  }
};

} // namespace vibroimpact::integration::flight_arithmetic
