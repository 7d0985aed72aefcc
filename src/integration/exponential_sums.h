// Sums of complex exponentials, and how long they can be shown to stay positive.
//
//   f_g(t) = constant_g + sum over j of Re(coefficient_gj a_j exp(e_j t))
//
// Between two instants h apart a function differs from the cubic with its values and slopes there
// by at most h^4 / 384 times its largest fourth derivative, which the magnitudes of the terms
// bound. Where the smallest Bernstein coefficient of that cubic is larger, the function has no
// zero.
#pragma once

#include "common/linear_algebra.h"

#include <complex>
#include <span>
#include <vector>

namespace vibroimpact {

class ExponentialSums {
public:
  using Complex = std::complex<double>;

  /// coefficients: functions x terms.
  void set(const Eigen::MatrixXcd &coefficients, const Vector &constants,
           std::vector<Complex> exponents);

  Index size() const { return constants_.size(); }

  /// A time up to `limit` until which all functions stay positive from t = 0 on, with the given
  /// amplitudes; 0 when none was found in a few trials. Without functions it is `limit`.
  double positive_until(double limit, std::span<const Complex> amplitudes);

private:
  struct End {
    double value = 0, slope = 0;
  };
  void start(std::span<const Complex> amplitudes);
  double first_trial(double limit) const;
  bool positive(double h);

  Eigen::MatrixXcd coefficients_;
  Vector constants_;
  std::vector<Complex> exponents_;
  Eigen::MatrixXcd terms_;     // coefficient times amplitude
  std::vector<double> fourth_; // |e|^4
  Eigen::ArrayXXd sizes_;      // of the terms
  std::vector<End> starts_;
  Vector bounds_;  // of the fourth derivatives at the start
  Vector margins_; // what rounding may hide
  std::vector<Complex> factors_;
};

} // namespace vibroimpact
