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
  Matrix own(6 * static_cast<Index>(nodes.size()), shapes.cols());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    own.middleRows(static_cast<Index>(6 * i), 6) = shapes.middleRows(Index{6} * nodes[i], 6);
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

/// Appends the places of a cell.
class Collector {
public:
  void add(const Matrix &stress) {
    if (stress.rows() == 0)
      return;
    places_ += static_cast<int>(stress.rows() / 3);
    parts_.push_back(stress);
  }
  void begin_cell() { first_.push_back(places_); }
  CellStress result(Index columns) {
    begin_cell();
    return {.rows = stacked(parts_, columns), .first = std::move(first_)};
  }

private:
  std::vector<Matrix> parts_;
  std::vector<int> first_;
  int places_ = 0;
};

} // namespace

Matrix stress_at_node(const BodyModel &model, int node, const Matrix &shapes) {
  std::vector<Matrix> parts;
  for (const auto &element : model.elements) {
    const auto nodes = element->nodes();
    if (std::find(nodes.begin(), nodes.end(), node) == nodes.end())
      continue;
    if (const Matrix stress = stress_of(*element, node); stress.rows() > 0)
      parts.emplace_back(stress * own_rows(*element, shapes));
  }
  return stacked(parts, shapes.cols());
}

CellStress line_stress(const BodyModel &model, const Matrix &shapes) {
  const ElementsByNodes elements = elements_by_nodes(model);
  Collector collector;
  for (const std::array<int, 2> &line : model.mesh.lines) {
    collector.begin_cell();
    const auto [begin, end] = elements.equal_range(ascending(line));
    for (const int node : line)
      for (auto at = begin; at != end; ++at)
        if (const Matrix stress = stress_of(*at->second, node); stress.rows() > 0)
          collector.add(stress * own_rows(*at->second, shapes));
  }
  return collector.result(shapes.cols());
}

CellStress cell_stress(const BodyModel &model, const Matrix &shapes) {
  const ElementsByNodes elements = elements_by_nodes(model);
  Collector collector;
  for (const structure::Cell &surface : model.mesh.cells) {
    collector.begin_cell();
    const auto [begin, end] = elements.equal_range(ascending(surface.nodes()));
    for (auto at = begin; at != end; ++at) {
      const Element &element = *at->second;
      Matrix mean = element.stress(0);
      for (int node = 1; node < surface.size; ++node)
        mean += element.stress(node);
      collector.add(mean / surface.size * own_rows(element, shapes));
    }
  }
  return collector.result(shapes.cols());
}

} // namespace vibroimpact::reduction
