// Which lines of a mesh belong to which member, and where on the member they lie.
#pragma once

#include "structure/mesh.h"

namespace vibroimpact::structure {

/// Where nodes of the generated line must be, from its start [m]: ends of members, and the
/// positions of supports, points, hinges and loads that lie on it. Ascending.
std::vector<double> needed_places(const BeamDefinition &definition);

/// Position of its member in the definition for each line of the mesh, -1 for those of no member.
/// Throws DefinitionError for a group or part that is not there, and for lines of two members.
std::vector<int> members_of_lines(const Mesh &mesh, const BeamDefinition &definition);

/// For each of these lines the fractions of the length at which it begins and ends, of the chain of
/// lines that it belongs to. Throws DefinitionError of the section `kind` `name` when the lines
/// branch, close or do not run in one direction.
std::vector<std::array<double, 2>> places_on_chains(const Mesh &mesh, const std::vector<int> &lines,
                                                    const std::string &kind,
                                                    const std::string &name);

} // namespace vibroimpact::structure
