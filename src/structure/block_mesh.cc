#include "structure/block_mesh.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace vibroimpact::structure {

namespace {

using Place = std::array<int, 3>; // along the edges

/// By axis, at its begin and at its end.
constexpr std::array<std::array<const char *, 2>, 3> face_names = {
    {{"left", "right"}, {"bottom", "top"}, {"back", "front"}}};

/// A regular grid of nodes.
class BlockGrid {
public:
  explicit BlockGrid(const Place &elements) : elements_(elements) {}

  int last(int axis) const { return elements_[axis]; }
  int node(const Place &at) const {
    return (at[2] * (elements_[1] + 1) + at[1]) * (elements_[0] + 1) + at[0];
  }
  /// Corners around a rectangle of one element along `first` and `second`.
  std::vector<int> around(Place at, int first, int second) const {
    std::vector<int> corners = {node(at)};
    ++at[first];
    corners.push_back(node(at));
    ++at[second];
    corners.push_back(node(at));
    --at[first];
    corners.push_back(node(at));
    return corners;
  }
  /// Calls visit(place) for all from 0 to `ends`, these included.
  template <class Visit> static void each(const Place &ends, Visit visit) {
    for (int k = 0; k <= ends[2]; ++k)
      for (int j = 0; j <= ends[1]; ++j)
        for (int i = 0; i <= ends[0]; ++i)
          visit(Place{i, j, k});
  }

private:
  Place elements_;
};

Place elements_less_one(const Block &block) {
  return {block.elements[0] - 1, block.elements[1] - 1, block.elements[2] - 1};
}

void add_block_nodes(const Block &block, Mesh &mesh) {
  BlockGrid::each(block.elements, [&](const Place &at) {
    Vector3 position = block.corner;
    for (int axis = 0; axis < 3; ++axis)
      position +=
          static_cast<double>(at[axis]) / block.elements[axis] * (block.ends[axis] - block.corner);
    mesh.nodes.push_back(position);
  });
}

/// `mirrored`: the edges are left-handed, and what was around goes the other way.
void add_hexahedra(const Block &block, const BlockGrid &grid, bool mirrored, Mesh &mesh) {
  BlockGrid::each(elements_less_one(block), [&](const Place &at) {
    std::vector<int> corners = grid.around(at, mirrored ? 1 : 0, mirrored ? 0 : 1);
    const std::vector<int> above =
        grid.around({at[0], at[1], at[2] + 1}, mirrored ? 1 : 0, mirrored ? 0 : 1);
    corners.insert(corners.end(), above.begin(), above.end());
    mesh.cells.push_back(cell_of(CellShape::hexahedron, corners));
  });
}

void add_face(const Block &block, const BlockGrid &grid, int axis, bool end, bool mirrored,
              Mesh &mesh) {
  const std::string name = face_names[axis][end];
  const bool forward = end != mirrored;
  const int first = (axis + (forward ? 1 : 2)) % 3;
  const int second = (axis + (forward ? 2 : 1)) % 3;
  Place ends = elements_less_one(block);
  ends[axis] = 0;
  BlockGrid::each(ends, [&](Place at) {
    at[axis] = end ? grid.last(axis) : 0;
    mesh.cell_groups[name].push_back(static_cast<int>(mesh.cells.size()));
    mesh.cells.push_back(cell_of(CellShape::quadrilateral, grid.around(at, first, second)));
  });
}

/// The faces on which a place of the grid lies, by their names.
std::vector<std::string> faces_at(const BlockGrid &grid, const Place &at) {
  std::vector<std::string> names;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool end : {false, true})
      if (at[axis] == (end ? grid.last(axis) : 0))
        names.emplace_back(face_names[axis][end]);
  return names;
}

void add_node_groups(const Block &block, const BlockGrid &grid, Mesh &mesh) {
  BlockGrid::each(block.elements, [&](const Place &at) {
    const std::vector<std::string> faces = faces_at(grid, at);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      mesh.groups[faces[i]].push_back(grid.node(at));
      for (std::size_t j = i + 1; j < faces.size(); ++j)
        mesh.groups[faces[i] + " " + faces[j]].push_back(grid.node(at));
    }
  });
}

} // namespace

Mesh generate_block(const Block &block) {
  const auto fail = [](const char *key, const char *problem) {
    throw DefinitionError("Geometry", "", key, problem);
  };
  if (*std::min_element(block.elements.begin(), block.elements.end()) < 1)
    fail("Divisions", "must be at least 1 in each direction");
  Eigen::Matrix3d edges;
  for (int axis = 0; axis < 3; ++axis)
    edges.col(axis) = block.ends[axis] - block.corner;
  if (!(std::abs(edges.determinant()) > 1e-6 * edges.colwise().norm().prod()))
    fail("Block", "must have three edges that have a length and do not lie in one plane");
  const BlockGrid grid(block.elements);
  const bool mirrored = edges.determinant() < 0;
  Mesh mesh;
  add_block_nodes(block, mesh);
  add_hexahedra(block, grid, mirrored, mesh);
  for (int axis = 0; axis < 3; ++axis)
    for (const bool end : {false, true})
      add_face(block, grid, axis, end, mirrored, mesh);
  add_node_groups(block, grid, mesh);
  return mesh;
}

} // namespace vibroimpact::structure
