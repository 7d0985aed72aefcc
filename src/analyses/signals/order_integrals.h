// Fourier coefficients of a motion by the integral over its polynomials, not from samples: nothing
// is aliased, and corners at contact changes are where they belong.
#pragma once

#include "analyses/recorders/observables.h"

#include <complex>
#include <functional>
#include <vector>

namespace vibroimpact::analyses {

/// c_j = 1/D * integral of x(t) exp(-i j w (t - t0)) dt over everything added, D its duration.
class OrderIntegrals {
public:
  /// t0 [s], w > 0 [rad/s]; orders 0 ... `orders` of `signals` quantities.
  OrderIntegrals(double origin, double angular_frequency, std::size_t orders, std::size_t signals);

  /// The next step: one function per quantity, each smooth inside. Gauss-Legendre quadrature with
  /// 15 points for each half turn of the highest order: exact to rounding for the polynomials of
  /// the dense output.
  void add(double start, double length, const std::vector<StepFunction> &functions);

  /// Mean value of a quantity.
  double mean(std::size_t signal) const;
  /// Amplitude a_j and phase p_j [rad] of order j >= 1 in a_j cos(j w (t - t0) + p_j).
  double amplitude(std::size_t signal, std::size_t order) const;
  double phase(std::size_t signal, std::size_t order) const;

private:
  void add_node(double time, double weight, double tau, const std::vector<StepFunction> &functions);

  double origin_, angular_frequency_;
  std::size_t orders_;
  double duration_ = 0;
  std::vector<std::vector<std::complex<double>>> sums_; ///< [signal][order]
};

} // namespace vibroimpact::analyses
