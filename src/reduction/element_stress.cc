#include "reduction/element_stress.h"

#include <algorithm>
#include <map>

namespace vibroimpact::reduction {

using structure::BodyModel;
using structure::Element;

namespace {

/// The shapes at the nodes of an element, in its order.
Matrix own_rows(const Element &element, const Matrix &shapes) {
  const auto nodes = element.nodes();
  const Index components = element.components();
  Matrix own(components * static_cast<Index>(nodes.size()), shapes.cols());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    own.middleRows(components * static_cast<Index>(i), components) =
        shapes.middleRows(Index{6} * nodes[i], components);
  return own;
}

Matrix stacked(const std::vector<Matrix> &parts, Index columns) {
  Index rows = 0;
  for (const Matrix &part : parts)
    rows += part.rows();
  Matrix all(rows, columns);
  rows = 0;
  for (const Matrix &part : parts) {
    all.middleRows(rows, part.rows()) = part;
    rows += part.rows();
  }
  return all;
}

/// The elements on the cells with so many nodes, by these in ascending order.
using ElementsByNodes = std::multimap<std::vector<int>, const Element *>;

std::vector<int> ascending(std::span<const int> nodes) {
  std::vector<int> sorted(nodes.begin(), nodes.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

ElementsByNodes elements_by_nodes(const BodyModel &model) {
  ElementsByNodes found;
  for (const auto &element : model.elements)
    found.emplace(ascending(element->nodes()), element.get());
  return found;
}

/// Stress at a node of the mesh that is one of the element's; none when it is not known.
Matrix stress_of(const Element &element, int node) {
  const auto nodes = element.nodes();
  return element.stress(
      static_cast<int>(std::find(nodes.begin(), nodes.end(), node) - nodes.begin()));
}

/// Plane stress as stress of all axes: xx, yy, xy, the others 0.
Matrix with_all_components(const Matrix &stress) {
  Matrix all = Matrix::Zero(2 * stress.rows(), stress.cols());
  for (Index place = 0; place < stress.rows() / 3; ++place) {
    all.middleRows(6 * place, 2) = stress.middleRows(3 * place, 2);
    all.row(6 * place + 3) = stress.row(3 * place + 2);
  }
  return all;
}

/// Of all elements of a body.
Index components_of(const BodyModel &model) {
  int components = 3;
  for (const auto &element : model.elements)
    components = std::max(components, element->stress_components());
  return components;
}

/// Collects the places of elements, with equally many components.
class Collector {
public:
  explicit Collector(const BodyModel &model) : components_(components_of(model)) {}

  /// `stress`: of the element, per unit coordinate.
  void add(const Element &element, const Matrix &stress) {
    parts_.push_back(element.stress_components() == components_ ? stress
                                                                : with_all_components(stress));
    places_ += static_cast<int>(parts_.back().rows() / components_);
  }
  void begin_cell() { first_.push_back(places_); }
  CellStress result(Index columns) {
    begin_cell();
    return {stacked(parts_, columns), std::move(first_), components_};
  }

private:
  Index components_;
  std::vector<Matrix> parts_;
  std::vector<int> first_;
  int places_ = 0;
};

} // namespace

CellStress stress_at_node(const BodyModel &model, int node, const Matrix &shapes) {
  Collector collector(model);
  collector.begin_cell();
  for (const auto &element : model.elements) {
    const auto nodes = element->nodes();
    if (std::find(nodes.begin(), nodes.end(), node) == nodes.end())
      continue;
    if (const Matrix stress = stress_of(*element, node); stress.rows() > 0)
      collector.add(*element, stress * own_rows(*element, shapes));
  }
  return collector.result(shapes.cols());
}

CellStress line_stress(const BodyModel &model, const Matrix &shapes) {
  const ElementsByNodes elements = elements_by_nodes(model);
  Collector collector(model);
  for (const std::array<int, 2> &line : model.mesh.lines) {
    collector.begin_cell();
    const auto [begin, end] = elements.equal_range(ascending(line));
    for (const int node : line)
      for (auto at = begin; at != end; ++at)
        if (const Matrix stress = stress_of(*at->second, node); stress.rows() > 0)
          collector.add(*at->second, stress * own_rows(*at->second, shapes));
  }
  return collector.result(shapes.cols());
}

CellStress cell_stress(const BodyModel &model, const Matrix &shapes) {
  const ElementsByNodes elements = elements_by_nodes(model);
  Collector collector(model);
  for (const structure::Cell &cell : model.mesh.cells) {
    collector.begin_cell();
    const auto [begin, end] = elements.equal_range(ascending(cell.nodes()));
    for (auto at = begin; at != end; ++at) {
      const Element &element = *at->second;
      Matrix mean = element.stress(0);
      for (int node = 1; node < cell.size; ++node)
        mean += element.stress(node);
      collector.add(element, mean / cell.size * own_rows(element, shapes));
    }
  }
  return collector.result(shapes.cols());
}

} // namespace vibroimpact::reduction
