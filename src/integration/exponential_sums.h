// Sums of complex exponentials, and how long they can be shown to stay positive.
//
//   f_g(t) = constant_g + sum over j of Re(coefficient_gj a_j exp(e_j t))
//
// Between two instants h apart a function differs from the cubic with its values and slopes there
// by at most h^4 / 384 times its largest fourth derivative, which the magnitudes of the terms
// bound. Where the smallest Bernstein coefficient of that cubic is larger, the function has no
// zero.
#pragma once

#include "integration/guard_curves.h"

#include <complex>
#include <span>
#include <vector>

namespace vibroimpact {

class ExponentialSums : public GuardCurves {
public:
  using Complex = std::complex<double>;

  /// coefficients: functions x terms. `sizes`, of the same shape: what the coefficients were summed
  /// up from, by absolute value, to which their rounding is relative.
  void set(const Eigen::MatrixXcd &coefficients, const Matrix &sizes, const Vector &constants,
           std::vector<Complex> exponents);

  /// From now on with these amplitudes a_j.
  void start(std::span<const Complex> amplitudes);

  /// A time up to `limit` until which all functions stay positive from t = 0 on; 0 when none was
  /// found in a few trials. Without functions it is `limit`.
  double positive_until(double limit);

  /// The interval [0, end] that the curves are asked for; factors: exp(e_j end), which must stay
  /// where they are as long as the curves are used.
  void end_at(double end, std::span<const Complex> factors);

  Index size() const override { return constants_.size(); }
  Jet at(Index guard, double time) const override;
  double sixth_derivative(Index guard, double from, double to) const override;
  double rounding(Index guard) const override;

private:
  struct End {
    double value = 0, slope = 0;
  };
  double first_trial(double limit);
  bool positive(double h);

  Eigen::MatrixXcd coefficients_; // terms x functions, as all below
  Vector constants_;
  std::vector<Complex> exponents_;
  double fastest_growth_ = 0;          // largest positive real part of an exponent
  Eigen::MatrixXcd terms_;             // coefficient times amplitude
  Eigen::ArrayXXd magnitudes_, sizes_; // of coefficients and terms
  Eigen::ArrayXd fourth_, sixth_;      // |e|^4, |e|^6
  Eigen::ArrayXd amplitude_sizes_;
  Matrix rounded_sizes_; // of what the coefficients were summed up from
  Vector totals_;        // sums of the sizes of all terms
  std::vector<End> starts_;
  Vector bounds_; // of the fourth derivatives at the start
  std::vector<Complex> factors_;
  double end_ = 0;
  double end_growth_ = 1;
  std::span<const Complex> end_factors_;
};

} // namespace vibroimpact
