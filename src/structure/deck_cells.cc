#include "structure/deck_cells.h"

#include <algorithm>

namespace vibroimpact::structure {

namespace {

using Faces = std::vector<std::vector<int>>;

bool begins(const std::string &type, std::initializer_list<const char *> heads) {
  return std::any_of(heads.begin(), heads.end(),
                     [&](const char *head) { return type.starts_with(head); });
}

/// Corners of the faces of solids with so many corners, outward.
Faces corner_faces(std::size_t corners) {
  if (corners == 4)
    return {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  if (corners == 6)
    return {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  return {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
}

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

DeckElement solid(std::size_t corners, std::size_t nodes) {
  DeckElement element{.nodes = nodes, .faces = corner_faces(corners), .solid = true};
  if (nodes > corners)
    for (std::vector<int> &face : element.faces) {
      const std::size_t size = face.size();
      for (std::size_t i = 0; i < size; ++i)
        face.push_back(between(corners, face[i], face[(i + 1) % size]));
    }
  return element;
}

DeckElement shell(std::size_t nodes) {
  std::vector<int> face(nodes);
  for (std::size_t i = 0; i < nodes; ++i)
    face[i] = static_cast<int>(i);
  return {.nodes = nodes, .faces = {face}};
}

/// The number that follows the letters, of the letters and digits of a type.
int nodes_in_name(const std::string &type, std::size_t letters) {
  return std::atoi(type.c_str() + std::min(letters, type.size()));
}

std::size_t corner_count(std::size_t face_nodes) {
  return face_nodes == 3 || face_nodes == 6 ? 3 : 4;
}

void add_surface(const std::vector<int> &nodes, Mesh &mesh) {
  const std::size_t corners = corner_count(nodes.size());
  const auto add = [&](std::initializer_list<int> of) {
    Surface surface{.size = static_cast<int>(of.size())};
    std::copy(of.begin(), of.end(), surface.corners.begin());
    mesh.surfaces.push_back(surface);
  };
  const std::vector<int> &n = nodes;
  if (nodes.size() == corners)
    return corners == 3 ? add({n[0], n[1], n[2]}) : add({n[0], n[1], n[2], n[3]});
  for (std::size_t i = 0; i < corners; ++i)
    add({n[i], n[corners + i], n[corners + (i + corners - 1) % corners]});
  return corners == 3 ? add({n[3], n[4], n[5]}) : add({n[4], n[5], n[6], n[7]});
}

} // namespace

std::optional<DeckElement> deck_element(const std::string &type) {
  const std::map<int, std::size_t> corners = {{4, 4}, {6, 6}, {8, 8}, {10, 4}, {15, 6}, {20, 8}};
  if (begins(type, {"C3D"})) {
    const auto found = corners.find(nodes_in_name(type, 3));
    if (found != corners.end())
      return solid(found->second, static_cast<std::size_t>(found->first));
    return std::nullopt;
  }
  for (const auto &[head, letters] : std::initializer_list<std::pair<const char *, std::size_t>>{
           {"CPS", 3}, {"CPE", 3}, {"M3D", 3}, {"S", 1}})
    if (begins(type, {head}))
      if (const int nodes = nodes_in_name(type, letters);
          nodes == 3 || nodes == 4 || nodes == 6 || nodes == 8)
        return shell(static_cast<std::size_t>(nodes));
  if (begins(type, {"B31", "T3D2", "T2D2", "B21"}))
    return DeckElement{.nodes = 2, .faces = {}};
  if (begins(type, {"B32", "T3D3", "B22"}))
    return DeckElement{.nodes = 3, .faces = {}};
  return std::nullopt;
}

void DeckCells::add(const DeckElement &element, const std::vector<int> &nodes) {
  if (element.faces.empty())
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
      lines_.push_back({nodes[i], nodes[i + 1]});
  for (const std::vector<int> &face : element.faces) {
    std::vector<int> own;
    for (const int at : face)
      own.push_back(nodes[static_cast<std::size_t>(at)]);
    if (!element.solid) {
      shells_.push_back({own, 1});
      continue;
    }
    std::vector<int> corners(own.begin(),
                             own.begin() + static_cast<std::ptrdiff_t>(corner_count(own.size())));
    std::sort(corners.begin(), corners.end());
    Face &known = solids_[corners];
    known.nodes = std::move(own);
    ++known.count;
  }
}

void DeckCells::give(Mesh &mesh) const {
  mesh.lines = lines_;
  for (const Face &face : shells_)
    add_surface(face.nodes, mesh);
  for (const auto &[corners, face] : solids_)
    if (face.count == 1)
      add_surface(face.nodes, mesh);
}

} // namespace vibroimpact::structure
