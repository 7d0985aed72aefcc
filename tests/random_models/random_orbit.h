// Are the multipliers that the analysis `periodic orbit` stores those of differences of the motion
// over a period?
#pragma once

#include "random_models/spectra.h"

#include <cstdint>
#include <set>
#include <string>

namespace vibroimpact::testing {

/// A parameter file with an analysis "a" of the type periodic orbit: bodies and contacts as of
/// random_model(), under one harmonic excitation and sometimes weight.
std::string random_orbit_model(std::uint64_t seed);

/// Verdicts: those of SpectraVerdict;
///   no orbit     the analysis finds none, by a reason, or only one that grazes
///   unresolved   the differences leave more than 1e-6 of a column open
///   refused      not a model
struct OrbitVerdict {
  std::string word;
  std::string detail{};
  SpectraVerdict spectra{};
  double open = 0; ///< what the differences leave open, at most
  bool stable = false, symmetric = false;
  long multiple = 0;
  int events = 0; ///< in a period of the orbit
  std::set<std::string> laws{};
};

OrbitVerdict judge_orbit(std::uint64_t seed, const std::string &folder);

} // namespace vibroimpact::testing
