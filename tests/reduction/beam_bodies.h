// Reduced bodies that several tests use.
#pragma once

#include "reduction/reduce.h"
#include "structure/beam_examples.h"

namespace vibroimpact::examples {

inline reduction::BodyDefinition body_of(const BeamDefinition &beam, int number) {
  reduction::BodyDefinition definition;
  definition.name = "left";
  definition.beam = beam;
  definition.selection.number = number;
  return definition;
}

inline reduction::ReducedBody reduced(const BeamDefinition &beam, int number) {
  return reduction::reduce(body_of(beam, number), MPI_COMM_WORLD);
}

/// Square, so that each bending frequency is double, skew in space and with an odd head.
inline BeamDefinition square_beam(int elements) {
  BeamDefinition beam = thin_beam(elements);
  beam.line.end = {0.1, 0.2, 0.2};
  beam.section.width = beam.section.thickness = 0.005;
  clamp_start(beam);
  beam.points.push_back({"head", {"end", {}}, 0.02, Vector3::Zero()});
  return beam;
}

} // namespace vibroimpact::examples
