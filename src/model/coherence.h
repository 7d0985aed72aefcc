// Random excitations at several places that belong together.
//
// Lines at w of the excitations i and j, c = A - i B with the variance 1 of A and B, have
//
//   E[c_i conj(c_j)] / 2 = gamma(w, |x_i - x_j|) exp(-i w (t_i - t_j)),     t_i = x_i . n / v
//
// where a wave along n passes the places with the velocity v; without one t_i = 0. With the lower
// factor L of the matrix gamma (Cholesky), c_i = exp(-i w t_i) sum over j <= i of L_ij z_j, the z_j
// being independent (Shinozuka and Deodatis 1991).
#pragma once

#include "common/linear_algebra.h"
#include "parameters/values.h"

#include <complex>
#include <string>
#include <vector>

namespace vibroimpact::model {

/// What the lines of one excitation are made of.
struct CoherentPlaces {
  /// gamma(w [rad/s], distance [m]): 1 at no distance, falling.
  double (*law)(double argument) = nullptr; ///< of decay * w * distance / speed
  double decay_per_speed = 0;               ///< [s/m]
  Vector3 slowness = Vector3::Zero();       ///< n / v [s/m]
  std::vector<std::string> streams;         ///< of the excitations up to this one; empty: alone
  std::vector<Vector3> places;              ///< theirs [m]

  /// What the line at w takes of each stream: conj(c_i) as a sum over the streams.
  std::vector<std::complex<double>> shares(double omega) const;
};

/// Declares the section Coherence.
void declare_coherence(parameters::Section &root);
/// Declares the keys of a random excitation by which it takes part.
void declare_coherent_place(parameters::Section &random);

/// Of an excitation; alone where it names no Coherence. InputError.
CoherentPlaces read_coherence(const parameters::Values &root, const std::string &excitation);

} // namespace vibroimpact::model
