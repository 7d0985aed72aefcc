#include "structure/discretisation.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>

namespace vibroimpact::structure {

namespace {

std::vector<std::vector<int>> neighbours(std::size_t nodes, const Elements &elements) {
  std::vector<std::vector<int>> graph(nodes);
  for (const auto &element : elements)
    for (const int node : element->nodes())
      graph[node].insert(graph[node].end(), element->nodes().begin(), element->nodes().end());
  for (std::vector<int> &row : graph) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
  }
  return graph;
}

/// Place of each node in an order along the body, after Cuthill and McKee. Cutting that order into
/// equal parts needs no partitioner and gives the same parts on every machine.
std::vector<int> order(const std::vector<std::vector<int>> &graph) {
  dealii::DynamicSparsityPattern pattern(graph.size(), graph.size());
  for (std::size_t node = 0; node < graph.size(); ++node)
    for (const int neighbour : graph[node])
      pattern.add(node, neighbour);
  std::vector<dealii::DynamicSparsityPattern::size_type> places(graph.size());
  dealii::SparsityTools::reorder_Cuthill_McKee(pattern, places);
  return {places.begin(), places.end()};
}

} // namespace

Discretisation discretise(std::size_t nodes, const Elements &elements, MPI_Comm communicator) {
  int rank = 0;
  int ranks = 1;
  MPI_Comm_rank(communicator, &rank);
  MPI_Comm_size(communicator, &ranks);
  Discretisation result;
  result.neighbours = neighbours(nodes, elements);
  const std::vector<int> places = order(result.neighbours);
  result.dofs.resize(nodes);
  for (std::size_t node = 0; node < nodes; ++node)
    for (int component = 0; component < 6; ++component)
      result.dofs[node][component] = 6 * places[node] + component;
  const auto begin_of = [&](int r) { return static_cast<int>(nodes * r / ranks); };
  result.own_begin = 6 * begin_of(rank);
  result.own_end = 6 * begin_of(rank + 1);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    int first = static_cast<int>(nodes);
    for (const int node : elements[e]->nodes())
      first = std::min(first, places[node]);
    if (first >= begin_of(rank) && first < begin_of(rank + 1))
      result.own_elements.push_back(static_cast<int>(e));
  }
  return result;
}

} // namespace vibroimpact::structure
