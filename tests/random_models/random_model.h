// Models of vibrating and colliding bodies drawn at random, as parameter files.
#pragma once

#include <cstdint>
#include <string>

namespace vibroimpact::testing {

/// Models of these seeds have contacts with friction.
constexpr std::uint64_t first_with_friction = 1'000'000;
/// And of these, rigid sides with friction.
constexpr std::uint64_t first_with_rigid_friction = 2'000'000;
/// Models of these have friction along two directions.
constexpr std::uint64_t first_with_planar_friction = 3'000'000;
/// And of these, circular gaps.
constexpr std::uint64_t first_with_rings = 4'000'000;
/// And with rigid sides there.
constexpr std::uint64_t first_with_rigid_rings = 5'000'000;
/// Models of these have forces by tables and formulas, and no friction.
constexpr std::uint64_t first_with_written_laws = 6'000'000;

/// What a model is made from; equal numbers give equal text.
struct ModelChoice {
  std::uint64_t seed = 0;
  /// Relative change of the first mass or density: shows how sensitive the motion is.
  double nudge = 0;
};

/// A parameter file with one transient analysis "a" of 400 samples: one or two lumped, beam or
/// plate bodies, fixed or free, 1 to 4 contacts of any law between points, fixed and moving stops,
/// with positive, zero and negative clearances, any excitation, and starts at rest exactly on a
/// guard. Recorded excitations read the file that write_record() makes, by name.
std::string random_model(const ModelChoice &choice);

/// The record of an acceleration, velocity, force or displacement of the size of one in SI.
void write_record(const std::string &file);

/// Name of that file in the text.
constexpr const char *record_name = "record.csv";

} // namespace vibroimpact::testing
