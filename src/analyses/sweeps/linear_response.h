// Complex amplitudes of the linear model under one harmonic excitation, contacts open or tied.
//
// Tied sides keep the gap they have at rest: G Q + b S = 0 with the rows G and what the moving base
// adds to them, b. So Q = T P + Q_0 S with the basis T of model::AssembledSystem and
// Q_0 = -M^-1 G^T (G M^-1 G^T)^-1 b, and T^T times the equations of motion gives P.
#pragma once

#include "model/assembled_system.h"

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
  /// `tied`: gaps that do not change. InputError when the model has nonlinear parts or the source
  /// is not harmonic; NumericalError when the tied contacts hold everything.
  LinearResponse(const model::Model &model, std::size_t source,
                 const std::vector<model::Projection> &tied = {});

  /// NumericalError at an undamped resonance.
  ComplexAmplitudes at(double angular_frequency) const;
  /// Amplitude of an observed displacement.
  std::complex<double> observed(const model::Projection &projection,
                                const ComplexAmplitudes &amplitudes) const;

private:
  void tie(const std::vector<model::Projection> &tied);
  ComplexVector solved_tied(const ComplexMatrix &dynamic, const ComplexVector &load,
                            std::complex<double> source) const;

  const model::Model &model_;
  std::size_t source_;
  Matrix stiffness_;
  Matrix damping_;
  Matrix basis_; ///< T; empty where nothing is tied
  Vector moved_; ///< Q_0, likewise
};

} // namespace vibroimpact::analyses
