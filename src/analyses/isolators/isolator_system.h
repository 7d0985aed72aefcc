// The isolator that a parameter file describes, in the numbers of isolator_unfolding.h.
#pragma once

#include "analyses/isolators/isolator_unfolding.h"
#include "analyses/run/system.h"

#include <string>

namespace vibroimpact::analyses {

/// One mass on a spring and a dashpot under a harmonic force, between two equal bilinear stops.
struct IsolatorSystem {
  double mass = 0;           ///< m [kg]
  double stiffness = 0;      ///< k_0 [N/m]
  double damping = 0;        ///< c_0 [N s/m]
  double stop_stiffness = 0; ///< k_1 [N/m]
  double stop_damping = 0;   ///< c_1 [N s/m]
  double clearance = 0;      ///< d [m]
  double force = 0;          ///< F, amplitude [N]
  std::string point;         ///< that meets the stops, "isolator.mass"
  char axis = 'x';           ///< along which it does

  double natural_frequency() const; ///< [rad/s]
  /// c/(2 sqrt(m k_0)) of both dashpots
  IsolatorDamping damping_ratios() const;
  /// k_1/k_0 and F/(k_0 d)
  StopChoice stop() const;
  double clearance_of(const StopChoice &choice) const; ///< [m]
};

/// InputError where the system is another one.
IsolatorSystem read_isolator(const System &system, const std::string &excitation);

} // namespace vibroimpact::analyses
