#include "structure/deck_cells.h"

#include <algorithm>

namespace vibroimpact::structure {

namespace {

/// Node between two corners of a solid: behind the corners stand those of the base, then those of
/// the top, then those of the edges between them; a tetrahedron has its three edges to the top
/// last.
int between(std::size_t corners, int a, int b) {
  const auto count = static_cast<int>(corners);
  if (count == 4) {
    if (std::max(a, b) == 3)
      return 7 + std::min(a, b);
    return 4 + (std::abs(a - b) == 2 ? 2 : std::min(a, b));
  }
  const int ring = count / 2;
  const int low = std::min(a, b);
  if (std::abs(a - b) == ring)
    return 2 * count + low;
  const bool closes = std::abs(a - b) == ring - 1 && ring > 2;
  return count + (closes ? std::max(a, b) : low);
}

/// The nodes of a face of an element, as positions among its own.
std::vector<int> face_nodes(const DeckElement &element, std::vector<int> face) {
  const std::size_t corners = face.size();
  for (std::size_t i = 0; element.nodes > element.type->nodes && i < corners; ++i)
    face.push_back(element.type->dimension == 3
                       ? between(element.type->nodes, face[i], face[(i + 1) % corners])
                       : static_cast<int>(corners + i));
  return face;
}

void add_surface(const std::vector<int> &nodes, Mesh &mesh) {
  const std::size_t corners = nodes.size() % 3 == 0 ? 3 : 4;
  const auto add = [&](const std::vector<int> &of) {
    mesh.cells.push_back(
        cell_of(of.size() == 3 ? CellShape::triangle : CellShape::quadrilateral, of));
  };
  const std::vector<int> &n = nodes;
  if (nodes.size() == corners)
    return corners == 3 ? add({n[0], n[1], n[2]}) : add({n[0], n[1], n[2], n[3]});
  for (std::size_t i = 0; i < corners; ++i)
    add({n[i], n[corners + i], n[corners + (i + corners - 1) % corners]});
  return corners == 3 ? add({n[3], n[4], n[5]}) : add({n[4], n[5], n[6], n[7]});
}

} // namespace

std::optional<DeckElement> deck_element(const std::string &name) {
  const auto is_digit = [](char letter) { return letter >= '0' && letter <= '9'; };
  for (const CellType &type : cell_types())
    for (const auto &[head, nodes] : type.deck)
      if (const std::string_view rest =
              std::string_view(name).substr(std::min(name.size(), std::string_view(head).size()));
          name.starts_with(head) && (rest.empty() || !is_digit(rest.front())))
        return DeckElement{&type, nodes};
  return std::nullopt;
}

void DeckCells::add(const DeckElement &element, const std::vector<int> &nodes) {
  for (std::size_t i = 0; element.type->dimension == 1 && i + 1 < nodes.size(); ++i)
    lines_.push_back({nodes[i], nodes[i + 1]});
  for (const std::vector<int> &face : element.type->faces) {
    std::vector<int> own;
    for (const int at : face_nodes(element, face))
      own.push_back(nodes[static_cast<std::size_t>(at)]);
    if (element.type->dimension == 3)
      solids_.add(std::move(own), face.size());
    else
      shells_.push_back(std::move(own));
  }
}

void DeckCells::give(Mesh &mesh) const {
  mesh.lines = lines_;
  for (const std::vector<int> &face : shells_)
    add_surface(face, mesh);
  for (const std::vector<int> &face : solids_.faces())
    add_surface(face, mesh);
}

} // namespace vibroimpact::structure
