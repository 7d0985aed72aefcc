// The elements of a beam body: frame elements on the lines of its mesh, by members.
#pragma once

#include "structure/body_model.h"
#include "structure/frame_element.h"

namespace vibroimpact::structure {

/// From the file, or the generated line. Throws DefinitionError.
Mesh frame_mesh(const BeamDefinition &definition);

/// What the lines of the mesh are, apart from their sections.
struct FrameLines {
  std::vector<int> members; ///< positions in the definition; -1: the body's own section
  std::vector<ElementFrame> frames;
  std::vector<Releases> releases;
};

/// Throws DefinitionError.
FrameLines frame_lines(const Mesh &mesh, const BeamDefinition &definition);

/// Of each line of the mesh, in its order.
std::vector<PropertiesAlong> properties_of_lines(const Mesh &mesh, const BeamDefinition &definition,
                                                 const FrameLines &lines);
/// The member that a line belongs to, by its position; of -1 the body's own section.
Member member_at(const BeamDefinition &definition, int position);

/// One element for each line of the mesh, in its order. Throws DefinitionError for sections and
/// materials out of range, and for hinges that leave a line loose.
void add_frame_elements(BodyModel &model, const BeamDefinition &definition,
                        const FrameLines &lines);

/// From the nodes to the axis of the member, in global axes [m].
Vector3 offset_of(const Member &member, const ElementFrame &frame);

/// Throws DefinitionError for a line under an axial force that is part of a rigid body: what it
/// does there is not part of the program.
void check_rigid_lines(const BodyModel &model, const BeamDefinition &definition,
                       const std::vector<int> &members);

} // namespace vibroimpact::structure
