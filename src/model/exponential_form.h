// Functions of time in closed form: what an exact solution of linear equations can be made of.
#pragma once

#include <complex>
#include <vector>

namespace vibroimpact::model {

/// A function as exponentials and a polynomial, in closed form:
///   s(t) = Re sum_k amplitude_k exp(exponent_k (t - origin)) + sum_j polynomial_j (t - origin)^j
struct ExponentialForm {
  struct Term {
    std::complex<double> amplitude;
    std::complex<double> exponent; ///< [1/s]
  };
  double origin = 0; ///< [s]
  std::vector<Term> terms;
  std::vector<double> polynomial;

  double value(double time) const;
  double rate(double time) const;
  double acceleration(double time) const;

  /// The same function with another origin.
  ExponentialForm about(double new_origin) const;
  /// The integral that is `constant` at the origin. Exponents must not be zero.
  ExponentialForm integral(double constant) const;
};

} // namespace vibroimpact::model
