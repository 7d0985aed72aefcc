// Bodies that several tests use.
#pragma once

#include "structure/assembly.h"
#include "structure/beam_definition.h"

#include <cmath>

namespace vibroimpact::examples {

using structure::BeamDefinition;

/// The spring-steel beam of the impacting-beams experiment (30 mm x 0.75 mm, 0.3 m long along z);
/// its weak axis bends along x.
inline BeamDefinition thin_beam(int elements) {
  BeamDefinition beam;
  beam.line = {Vector3::Zero(), Vector3(0, 0, 0.3), elements};
  beam.section.width = 0.03;
  beam.section.thickness = 0.00075;
  beam.material = {206e9, 0.3, 7850};
  return beam;
}

inline double bending_stiffness(const BeamDefinition &beam) {
  return beam.material.young_modulus * beam.section.width * std::pow(beam.section.thickness, 3) /
         12;
}

inline double mass_per_length(const BeamDefinition &beam) {
  return beam.material.density * beam.section.width * beam.section.thickness;
}

inline double beam_length(const BeamDefinition &beam) {
  return (beam.line.end - beam.line.start).norm();
}

inline double beam_mass(const BeamDefinition &beam) {
  return mass_per_length(beam) * beam_length(beam);
}

/// sqrt(EI / (rho A L^4)): omega = (beta L)^2 of it [rad/s].
inline double frequency_scale(const BeamDefinition &beam) {
  return std::sqrt(bending_stiffness(beam) / mass_per_length(beam)) /
         std::pow(beam_length(beam), 2);
}

/// Leaves bending along x alone: x and ry.
inline void hold_plane(BeamDefinition &beam) {
  beam.supports.push_back({"plane", {"all", {}}, {false, true, true, true, false, true}, {}});
}

inline void clamp_start(BeamDefinition &beam) {
  beam.supports.push_back({"root", {"start", {}}, {true, true, true, true, true, true}, {}});
}

/// Clamped, bending in one plane, with a lumped mass at the free end.
inline BeamDefinition cantilever(int elements, double tip_mass = 0) {
  BeamDefinition beam = thin_beam(elements);
  hold_plane(beam);
  clamp_start(beam);
  beam.points.push_back({"head", {"end", {}}, tip_mass, Vector3::Zero()});
  return beam;
}

/// Case S: the tip mass, 57.7114 g, that tunes the first mode to 2.95 Hz.
inline BeamDefinition tuned_cantilever(int elements) {
  return cantilever(elements, 1.089150276093259 * beam_mass(thin_beam(1)));
}

} // namespace vibroimpact::examples
