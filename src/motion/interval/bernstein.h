// Polynomials on [0, 1] in the Bernstein basis: the dense output of a time step, up to degree 9,
// and products of two.
//
// The coefficients bound the polynomial, and their sign changes bound the number of its zeros, so
// that zeros are isolated safely by subdivision: none is skipped, whatever their distance.
#pragma once

#include <array>
#include <optional>
#include <span>

namespace vibroimpact::motion {

class Bernstein {
public:
  static constexpr int dense_degree = 9;
  static constexpr int maximum_degree = 2 * dense_degree;

  Bernstein() = default;
  /// A constant.
  explicit Bernstein(double value) { coefficients_[0] = value; }

  /// Degree 2 p - 1 from value and derivatives at both ends of a step of length h: p <= 5 each.
  static Bernstein hermite(double h, std::span<const double> start, std::span<const double> end);
  /// Derivative by time of that polynomial, exact to the last digit at both ends: where h is short,
  /// the differences of the coefficients of hermite() would be noise.
  static Bernstein hermite_rate(double h, std::span<const double> start,
                                std::span<const double> end);
  /// Quintic with value, rate and acceleration of a motion at both ends of a step of length h.
  static Bernstein quintic(double h, const std::array<double, 3> &start,
                           const std::array<double, 3> &end);
  /// Cubic with value and rate at both ends.
  static Bernstein cubic(double h, const std::array<double, 2> &start,
                         const std::array<double, 2> &end);

  /// From its coefficients, at most maximum_degree + 1.
  static Bernstein of_coefficients(std::span<const double> coefficients);

  /// Straight line between the values at both ends.
  static Bernstein line(double start, double end);

  /// The j-th polynomial of a degree.
  static Bernstein basis(int degree, int j);

  int degree() const { return degree_; }
  std::span<const double> coefficients() const {
    return {coefficients_.data(), static_cast<std::size_t>(degree_) + 1};
  }
  double operator()(double tau) const;
  double start() const { return coefficients_[0]; }
  double end() const { return coefficients_[degree_]; }
  /// Derivative by tau (divide by h for a rate).
  Bernstein derivative() const;

  Bernstein &operator*=(double factor);
  /// Sum; the lower degree is raised.
  Bernstein &operator+=(const Bernstein &other);

  Bernstein &operator+=(double constant);

  /// Product, of the sum of both degrees.
  Bernstein operator*(const Bernstein &other) const;

  /// Of odd degree n < maximum_degree: with `amount` times the middle Bernstein polynomial of
  /// degree n + 1.
  Bernstein with_middle(double amount) const;

  /// The part from tau to 1, as a polynomial on [0, 1].
  Bernstein behind(double tau) const;
  /// The part from `from` to `to`, likewise: 0 <= from <= to <= 1.
  Bernstein between(double from, double to) const;

  /// Takes the value at the start for an exact zero, and with it all leading coefficients up to the
  /// size `negligible`: the sign right after the start is not decided by errors of that size.
  void clear_start(double negligible = 0);

  /// Smallest tau in [0, 1] at which the polynomial passes from positive to negative; 0 when it is
  /// negative from the start on (also right after a zero at the start).
  std::optional<double> first_down_crossing() const;

  /// Safe bounds on [0, 1], attained at the ends or not at all.
  double lower_bound() const;
  double upper_bound() const;

  /// Largest value on [0, 1].
  double maximum() const;
  double minimum() const;

private:
  void set_ends(double h, std::span<const double> start, std::span<const double> end);
  Bernstein raised() const;
  void split(Bernstein &left, Bernstein &right) const;
  std::optional<double> first_down_crossing_by_subdivision() const;
  int sign_after_start() const;
  int sign_changes() const;
  Bernstein without_zero_at_start() const;
  double falling_zero() const;
  void collect_maximum(double &best) const;

  int degree_ = 0;
  std::array<double, maximum_degree + 1> coefficients_{};
};

} // namespace vibroimpact::motion
