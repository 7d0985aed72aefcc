// Guards of a linear phase as sums of complex exponentials.
//
//   f_g(t) = constant_g + sum over j of Re(coefficient_gj a_j exp(e_j t))
#pragma once

#include "motion/segment/guard_curves.h"

#include <complex>
#include <span>
#include <vector>

namespace vibroimpact::motion {

class ExponentialSums : public GuardCurves {
public:
  using Complex = std::complex<double>;

  /// coefficients: functions x terms. `sizes`, of the same shape: what the coefficients were summed
  /// up from, by absolute value, to which their rounding is relative.
  void set(const Eigen::MatrixXcd &coefficients, const Matrix &sizes, const Vector &constants,
           std::vector<Complex> exponents);

  /// From now on with these amplitudes a_j.
  void start(std::span<const Complex> amplitudes);

  /// The interval [0, end] that the curves are asked for; factors: exp(e_j end), which must stay
  /// where they are as long as the curves are used.
  void end_at(double end, std::span<const Complex> factors);

  Index size() const override { return constants_.size(); }
  Jet at(Index guard, double time) const override;
  double sixth_derivative(Index guard, double from, double to) const override;
  double rounding(Index guard) const override;

private:
  Eigen::MatrixXcd coefficients_; // terms x functions, as all below
  Vector constants_;
  std::vector<Complex> exponents_;
  double fastest_growth_ = 0;          // largest positive real part of an exponent
  Eigen::MatrixXcd terms_;             // coefficient times amplitude
  Eigen::ArrayXXd magnitudes_, sizes_; // of coefficients and terms
  Eigen::ArrayXd sixth_;               // |e|^6
  Eigen::ArrayXd amplitude_sizes_;
  Matrix rounded_sizes_; // of what the coefficients were summed up from
  Vector totals_;        // sums of the sizes of all terms
  double end_ = 0;
  double end_growth_ = 1;
  std::span<const Complex> end_factors_;
};

} // namespace vibroimpact::motion
