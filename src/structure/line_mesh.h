// Nodes, line cells between them and named groups of nodes: everything a beam needs to know about
// its geometry, whether it was generated or read from a file.
#pragma once

#include "structure/beam_definition.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace vibroimpact::structure {

struct LineMesh {
  std::vector<Vector3> nodes;            ///< [m]
  std::vector<std::array<int, 2>> cells; ///< node pairs
  std::map<std::string, std::vector<int>> groups;

  /// Diagonal of the box around all nodes [m].
  double extent() const;
  int nearest_node(const Vector3 &position) const;
  double cell_length(std::size_t cell) const;
};

/// Equal elements along a straight line, with the groups "start" and "end".
/// Throws DefinitionError for a line without length or elements.
LineMesh generate_line(const Line &line);

/// Throws DefinitionError when the mesh has no cells, cells without length, or separate parts.
void check_mesh(const LineMesh &mesh);

/// The nodes a location means, ascending. `kind` and `name` are those of the section that asks,
/// for the message. Throws DefinitionError when there is no such group or no node at the position.
std::vector<int> find_nodes(const LineMesh &mesh, const Location &at, const std::string &kind,
                            const std::string &name);

} // namespace vibroimpact::structure
