// Complex amplitudes of the linear model under one harmonic excitation.
#pragma once

#include "model/model.h"

#include <Eigen/Core>
#include <complex>

namespace vibroimpact::analyses {

/// Coordinates and excitation at one frequency; time histories are Im(amplitude exp(i w t)).
struct ComplexAmplitudes {
  double angular_frequency = 0;
  std::complex<double> source; ///< of s(t)
  Eigen::VectorXcd coordinates;
};

class LinearResponse {
public:
  /// InputError when the model has nonlinear parts or the source is not harmonic.
  LinearResponse(const model::Model &model, std::size_t source);

  /// NumericalError at an undamped resonance.
  ComplexAmplitudes at(double angular_frequency) const;
  /// Amplitude of an observed displacement.
  std::complex<double> observed(const model::Projection &projection,
                                const ComplexAmplitudes &amplitudes) const;

private:
  const model::Model &model_;
  std::size_t source_;
  Matrix stiffness_;
  Matrix damping_;
};

} // namespace vibroimpact::analyses
