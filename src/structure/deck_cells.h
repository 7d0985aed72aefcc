// Cells that show the elements of an input deck.
#pragma once

#include "structure/mesh.h"

#include <optional>

namespace vibroimpact::structure {

/// How an element type is shown.
struct DeckElement {
  const CellType *type = nullptr;
  std::size_t nodes = 0; ///< that stand in the deck: the corners, then those between them
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
  std::vector<std::array<int, 2>> lines_;
  std::vector<std::vector<int>> shells_; ///< corners, then the nodes between them
  OuterFaces solids_;
};

} // namespace vibroimpact::structure
