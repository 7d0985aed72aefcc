// A small complete run with known figures: two cantilevers and a damper, their free collision, and
// response curves with and without a grid around them.
#pragma once

#include "common/result_sink.h"
#include "output/hdf5_results.h"
#include "reduction/reduced_body.h"

#include <vector>

namespace vibroimpact::testing {

/// "left" and "right": slender cantilevers along z with their first three bending modes in x, each
/// with a point "head" at the free end; "damper": one mass, a point "mass".
std::vector<reduction::ReducedBody> example_bodies();

/// An analysis with all its points in order.
struct Example {
  AnalysisHeader header;
  std::vector<PointResult> points;
};

Example modal_example();
/// Two oscillators collide; history, table and shape of the impacts, motion.
Example transient_example();
/// A hardening resonance swept up and down; the last point of the way down failed.
Example sweep_example();
/// The same over three clearances.
Example grid_example();

std::vector<Example> all_examples();

output::RunInformation example_information();

} // namespace vibroimpact::testing
