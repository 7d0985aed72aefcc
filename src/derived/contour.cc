// Level lines of a field over two axes: marching squares with straight lines between the points.
//
// Each line runs through the edges of the grid on which the field passes the level. An edge knows
// at most two cells, and a cell passes a line on from edge to edge, so that lines end at the
// border, at missing points, or close. A value equal to the level counts as above it. In a saddle
// the mean of the four corners says which of them hang together.
#include "derived/contour.h"

#include "derived/operation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace vibroimpact::derived {

namespace {

/// The edge that leaves a grid point towards larger coordinates.
struct Edge {
  std::size_t i;
  std::size_t j;
  bool along_first;

  auto operator<=>(const Edge &) const = default;
};

class LevelLines {
public:
  LevelLines(const Grid &grid, double level) : grid_(grid), level_(level) {
    for (std::size_t i = 0; i + 1 < grid.first.size(); ++i)
      for (std::size_t j = 0; j + 1 < grid.second.size(); ++j)
        join_cell(i, j);
  }

  std::vector<Polyline> lines() {
    std::vector<Polyline> lines;
    for (const std::size_t wanted : {1, 2}) // open lines begin at their ends
      for (const auto &[edge, neighbours] : neighbours_)
        if (!used_[edge] && neighbours.size() == wanted)
          lines.push_back(follow(edge));
    return lines;
  }

private:
  double value(std::size_t i, std::size_t j) const {
    return grid_.values[i * grid_.second.size() + j] - level_;
  }

  void join(const Edge &one, const Edge &other) {
    neighbours_[one].push_back(other);
    neighbours_[other].push_back(one);
  }

  void join_cell(std::size_t i, std::size_t j) {
    const std::array corners{value(i, j), value(i + 1, j), value(i + 1, j + 1), value(i, j + 1)};
    const double sum = std::accumulate(corners.begin(), corners.end(), 0.0);
    if (std::isnan(sum))
      return;
    const std::array edges{Edge{i, j, true}, Edge{i + 1, j, false}, Edge{i, j + 1, true},
                           Edge{i, j, false}};
    std::vector<Edge> crossed; // edge e lies between corners e and e + 1
    for (std::size_t e = 0; e < 4; ++e)
      if ((corners[e] >= 0) != (corners[(e + 1) % 4] >= 0))
        crossed.push_back(edges[e]);
    if (crossed.size() == 2) {
      join(crossed[0], crossed[1]);
    } else if (crossed.size() == 4) {
      // The corners on the other side than the middle are cut off.
      const std::size_t shift = (corners[0] >= 0) == (sum >= 0) ? 0 : 1;
      join(crossed[shift], crossed[1 + shift]);
      join(crossed[2 + shift], crossed[(3 + shift) % 4]);
    }
  }

  Vertex vertex(const Edge &edge) const {
    const std::size_t i = edge.i + (edge.along_first ? 1 : 0);
    const std::size_t j = edge.j + (edge.along_first ? 0 : 1);
    const double begin = value(edge.i, edge.j);
    const double part = begin / (begin - value(i, j));
    const double x = grid_.first[edge.i];
    const double y = grid_.second[edge.j];
    return {x + part * (grid_.first[i] - x), y + part * (grid_.second[j] - y)};
  }

  Polyline follow(Edge edge) {
    const Edge start = edge;
    Polyline line;
    while (!used_[edge]) {
      used_[edge] = true;
      line.push_back(vertex(edge));
      const std::vector<Edge> &neighbours = neighbours_[edge];
      for (const Edge &next : neighbours)
        if (!used_[next]) {
          edge = next;
          break;
        }
    }
    const std::vector<Edge> &last = neighbours_[edge];
    if (line.size() > 2 && neighbours_[start].size() == 2 &&
        std::find(last.begin(), last.end(), start) != last.end())
      line.push_back(line.front());
    return line;
  }

  const Grid &grid_;
  double level_;
  std::map<Edge, std::vector<Edge>> neighbours_;
  std::map<Edge, bool> used_;
};

} // namespace

std::vector<Polyline> level_lines(const Grid &grid, double level) {
  return LevelLines(grid, level).lines();
}

namespace {

/// Vertices of all lines, rows of NaN between them; one such row when there is no line.
std::vector<double> rows(const Grid &grid, const std::vector<double> &levels) {
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> rows;
  for (const double level : levels)
    for (const Polyline &line : level_lines(grid, level)) {
      if (!rows.empty())
        rows.insert(rows.end(), {gap, gap, gap});
      for (const Vertex &vertex : line)
        rows.insert(rows.end(), {vertex.first, vertex.second, level});
    }
  if (rows.empty())
    rows = {gap, gap, gap};
  return rows;
}

} // namespace

DerivedArray contour(const Request &request) {
  const LabelledArray array = request.array("Field");
  if (array.dimensions.size() != 2)
    request.section().reject("Field", "must be a field over two axes; this one goes over " +
                                          std::to_string(array.dimensions.size()) + ".");
  const Axis first = request.axis("Field", array.dimensions[0], array);
  const Axis second = request.axis("Field", array.dimensions[1], array);
  if (!first.labels.empty() || !second.labels.empty())
    request.section().reject("Field", "must be a field over two axes with numbers");
  const std::vector<double> levels = request.numbers("Levels", array.unit);
  std::vector<double> values = rows({first.values, second.values, array.values}, levels);
  const std::size_t vertices = values.size() / 3;
  Axis vertex{"vertex_" + request.name(), std::vector<double>(vertices), {}, "1", "index from 1"};
  std::iota(vertex.values.begin(), vertex.values.end(), 1);
  const Axis coordinate{
      "coordinate", {}, {"first axis", "second axis", "level"}, "1", "what a column holds"};
  DerivedArray result = request.result(array.unit, "level lines of " + array.name,
                                       {vertex.name, coordinate.name}, {vertices, 3});
  result.values = std::move(values);
  result.axes = {first.name, second.name};
  result.own_dimensions = {vertex, coordinate};
  return result;
}

} // namespace vibroimpact::derived
