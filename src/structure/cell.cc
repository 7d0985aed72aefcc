#include "structure/cell.h"

#include "structure/hexahedron.h"
#include "structure/quadrilateral_shell.h"
#include "structure/triangle_shell.h"

#include <algorithm>
#include <stdexcept>

namespace vibroimpact::structure {

namespace {

constexpr std::array plane_stress = {"xx", "yy", "xy"};
constexpr std::array full_stress = {"xx", "yy", "zz", "xy", "yz", "zx"};

} // namespace

const std::vector<CellType> &cell_types() {
  static const std::vector<CellType> types = {
      {CellShape::line,
       "line",
       1,
       2,
       1,
       {{"B31", 2}, {"T3D2", 2}, {"T2D2", 2}, {"B21", 2}, {"B32", 3}, {"T3D3", 3}, {"B22", 3}},
       {},
       plane_stress},
      {CellShape::triangle,
       "triangle",
       2,
       3,
       2,
       {{"S3", 3},
        {"CPS3", 3},
        {"CPE3", 3},
        {"M3D3", 3},
        {"S6", 6},
        {"CPS6", 6},
        {"CPE6", 6},
        {"M3D6", 6}},
       {{0, 1, 2}},
       plane_stress,
       make_triangle_shell},
      {CellShape::quadrilateral,
       "quadrilateral",
       2,
       4,
       3,
       {{"S4", 4},
        {"CPS4", 4},
        {"CPE4", 4},
        {"M3D4", 4},
        {"S8", 8},
        {"CPS8", 8},
        {"CPE8", 8},
        {"M3D8", 8}},
       {{0, 1, 2, 3}},
       plane_stress,
       make_quadrilateral_shell},
      {CellShape{10},
       "tetrahedron",
       3,
       4,
       4,
       {{"C3D4", 4}, {"C3D10", 10}},
       {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
       {}},
      {CellShape{13},
       "wedge",
       3,
       6,
       6,
       {{"C3D6", 6}, {"C3D15", 15}},
       {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}},
       {}},
      {CellShape::hexahedron,
       "hexahedron",
       3,
       8,
       5,
       {{"C3D8", 8}, {"C3D20", 20}},
       {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
       full_stress,
       make_hexahedron}};
  return types;
}

const CellType &cell_type(CellShape shape) {
  for (const CellType &type : cell_types())
    if (type.shape == shape)
      return type;
  throw std::logic_error("a cell has a shape that is not in the list");
}

Cell cell_of(CellShape shape, const std::vector<int> &nodes) {
  Cell cell{.shape = shape, .size = static_cast<int>(nodes.size())};
  std::copy(nodes.begin(), nodes.end(), cell.corners.begin());
  return cell;
}

void OuterFaces::add(std::vector<int> face, std::size_t corners) {
  std::vector<int> key(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(corners));
  std::sort(key.begin(), key.end());
  Face &known = faces_[key];
  known.nodes = std::move(face);
  ++known.count;
}

std::vector<std::vector<int>> OuterFaces::faces() const {
  std::vector<std::vector<int>> outer;
  for (const auto &[corners, face] : faces_)
    if (face.count == 1)
      outer.push_back(face.nodes);
  return outer;
}

std::vector<std::vector<int>> visible_faces(std::span<const Cell> cells) {
  std::vector<std::vector<int>> visible;
  OuterFaces outer;
  for (const Cell &cell : cells)
    for (const std::vector<int> &face : cell_type(cell.shape).faces) {
      std::vector<int> nodes;
      for (const int corner : face)
        nodes.push_back(cell.corners[static_cast<std::size_t>(corner)]);
      if (cell_type(cell.shape).dimension == 3)
        outer.add(nodes, nodes.size());
      else
        visible.push_back(nodes);
    }
  for (std::vector<int> &face : outer.faces())
    visible.push_back(std::move(face));
  return visible;
}

} // namespace vibroimpact::structure
