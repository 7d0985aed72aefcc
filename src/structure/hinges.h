// Hinges of members: which ends of which lines are released, and whether what is left holds.
#pragma once

#include "structure/body_model.h"
#include "structure/frame_element.h"

namespace vibroimpact::structure {

/// What is released at both ends of each line of the mesh. `members` are the members of the lines.
/// Throws DefinitionError for an unknown member and for places where it does not end.
std::vector<Releases> releases_of_lines(const Mesh &mesh, const BeamDefinition &definition,
                                        const std::vector<int> &members);

/// Throws DefinitionError when hinges leave a node loose that neither another element nor a support
/// holds. The supports of the model are there; `frames` are those of its lines.
void check_hinges(const BodyModel &model, const BeamDefinition &definition,
                  const std::vector<ElementFrame> &frames, const std::vector<Releases> &releases);

} // namespace vibroimpact::structure
