// Nodes, lines, surfaces and solids between them and named groups of both: everything a body needs
// to know about its geometry, whether it was generated or read from a file.
#pragma once

#include "structure/beam_definition.h"
#include "structure/cell.h"

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace vibroimpact::structure {

struct Mesh {
  std::vector<Vector3> nodes;                          ///< [m]
  std::vector<std::array<int, 2>> lines;               ///< node pairs
  std::vector<Cell> cells;                             ///< surfaces and solids
  std::map<std::string, std::vector<int>> groups;      ///< nodes
  std::map<std::string, std::vector<int>> line_groups; ///< positions in lines
  std::map<std::string, std::vector<int>> cell_groups; ///< positions in cells
  int unused_nodes = 0;         ///< nodes of a file that no cell uses; they are left out
  std::map<int, int> numbers{}; ///< of the nodes in their file -> position, where they count
  /// That many at the end of the list are no places: they carry coordinates of given matrices that
  /// no node with a position has.
  int internal_nodes = 0;

  /// The nodes that are places.
  std::span<const Vector3> places() const {
    return std::span(nodes).first(nodes.size() - static_cast<std::size_t>(internal_nodes));
  }

  /// Diagonal of the box around all nodes [m].
  double extent() const;
  int nearest_node(const Vector3 &position) const;
  double line_length(std::size_t line) const;
};

/// "(0, 1, 0.5) m", for messages.
std::string coordinates(const Vector3 &position);

/// Elements along a straight line, with the groups "start" and "end".
/// Throws DefinitionError for a line without length or elements.
Mesh generate_line(const Line &line);

/// The nodes a location means, ascending. `kind` and `name` are those of the section that asks,
/// for the message. Throws DefinitionError when there is no such group or no node at the position.
std::vector<int> find_nodes(const Mesh &mesh, const Location &at, const std::string &kind,
                            const std::string &name);

/// The cells of a group, or all `count` of them for "all". Throws DefinitionError for another name.
std::vector<int> find_cells(const std::map<std::string, std::vector<int>> &groups,
                            const std::string &group, std::size_t count, const std::string &kind,
                            const std::string &name);

} // namespace vibroimpact::structure
