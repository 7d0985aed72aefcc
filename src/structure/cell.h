// The cells of meshes. Each shape is one entry of a list (cell.cc), which says how files name it,
// what is seen of it and which element stands on it: nothing else asks for a shape by its number of
// nodes.
#pragma once

#include "common/bytes.h"

#include <array>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace vibroimpact::structure {

class Element;
struct CellPart;

/// VTK's numbers of cell types; those that the program itself makes have names here.
enum class CellShape : int { line = 3, triangle = 5, quadrilateral = 9, hexahedron = 12 };

/// A cell's nodes: in order around a surface; the base of a solid around, then what lies above.
struct Cell {
  CellShape shape = CellShape::triangle;
  int size = 3;
  std::array<int, 8> corners{}; ///< the first `size` count

  std::span<const int> nodes() const { return {corners.data(), static_cast<std::size_t>(size)}; }
  bool operator==(const Cell &) const = default;
};

void members(auto &visit, As<Cell> auto &cell) { visit(cell.shape, cell.size, cell.corners); }

struct CellType {
  /// The beginning of names of element types in input decks, and how many nodes these have there.
  struct DeckName {
    const char *head;
    std::size_t nodes;
  };
  CellShape shape;
  const char *name;
  int dimension;
  std::size_t nodes;          ///< corners
  int gmsh;                   ///< element type in Gmsh's files
  std::vector<DeckName> deck; ///< behind the corners there may be nodes between them
  /// Corners around what is seen of it, as positions among its own: a surface itself, outward the
  /// faces of a solid.
  std::vector<std::vector<int>> faces;
  /// Components of the stress in it: of plane stress (see Element::stress), or of all axes.
  std::span<const char *const> stress;
  /// Makes the element on a cell; none where only other programs have one, and for lines, which
  /// are beams with members of their own.
  std::shared_ptr<const Element> (*make)(const CellPart &) = nullptr;
};

const std::vector<CellType> &cell_types();
/// Throws std::logic_error for a shape without an entry.
const CellType &cell_type(CellShape shape);
/// `nodes`: as many as the shape has.
Cell cell_of(CellShape shape, const std::vector<int> &nodes);

/// The faces of solids that no other solid shares.
class OuterFaces {
public:
  /// Its corners first.
  void add(std::vector<int> face, std::size_t corners);
  /// In the order of their corners.
  std::vector<std::vector<int>> faces() const;

private:
  struct Face {
    std::vector<int> nodes;
    int count = 0;
  };
  std::map<std::vector<int>, Face> faces_; ///< by their corners in ascending order
};

/// What is seen of cells: surfaces, and the outer faces of solids.
std::vector<std::vector<int>> visible_faces(std::span<const Cell> cells);

} // namespace vibroimpact::structure
