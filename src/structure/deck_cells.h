// Cells that show the elements of an input deck.
#pragma once

#include "structure/mesh.h"

#include <map>
#include <optional>

namespace vibroimpact::structure {

/// How an element type is shown: a polygon or polyhedron by its faces, or a line.
struct DeckElement {
  std::size_t nodes = 0;               ///< that stand in the deck
  std::vector<std::vector<int>> faces; ///< corners, then the nodes between them; empty for a line
  bool solid = false;                  ///< only its outer faces are seen
};

/// Of a type in capitals ("C3D8I", "S8R", "B31"); nothing when its elements are not shown.
std::optional<DeckElement> deck_element(const std::string &type);

/// Collects elements, and makes the cells of a mesh of them.
class DeckCells {
public:
  /// `nodes`: positions in the list of the mesh's nodes.
  void add(const DeckElement &element, const std::vector<int> &nodes);
  void give(Mesh &mesh) const;

private:
  struct Face {
    std::vector<int> nodes;
    int count = 0;
  };
  std::vector<std::array<int, 2>> lines_;
  std::vector<Face> shells_;
  std::map<std::vector<int>, Face> solids_; ///< by their corners in ascending order
};

} // namespace vibroimpact::structure
