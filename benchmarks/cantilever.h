// Modes of a clamped Euler-Bernoulli beam with a lumped mass at its free end, in closed form.
//
// With m the lumped mass over that of the beam, the eigenvalues beta L solve
//   1 + cos b cosh b + m b (cos b sinh b - sin b cosh b) = 0,
// and scaled to a unit tip displacement the modal mass over that of the beam is
//   m_j = (1 + m + 2 m s) / 4,   s = b tanh b sin b / (sin b - cos b tanh b),
// s being the slope of the mode at its tip times L.
#pragma once

#include "common/linear_algebra.h"

namespace vibroimpact::benchmarks {

struct Cantilever {
  double length = 0;          ///< [m]
  double bending = 0;         ///< E I [N m^2]
  double mass_per_length = 0; ///< [kg/m]
  double tip_mass = 0;        ///< [kg]
};

struct CantileverModes {
  Vector angular_frequency; ///< [rad/s]
  Vector tip_displacement;  ///< of modes with unit modal mass [kg^-1/2]
};

CantileverModes cantilever_modes(const Cantilever &beam, int count);

} // namespace vibroimpact::benchmarks
