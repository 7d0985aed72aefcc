// Lines of equal value on a rectangular grid.
#pragma once

#include <vector>

namespace vibroimpact::derived {

struct Grid {
  std::vector<double> first;  ///< coordinates
  std::vector<double> second; ///< coordinates
  const double *values;       ///< first x second, row-major; NaN where a point is missing
};

struct Vertex {
  double first;
  double second;
};

/// A closed line ends with its first vertex.
using Polyline = std::vector<Vertex>;

/// In an order that depends on the grid alone: open lines, then closed ones.
std::vector<Polyline> level_lines(const Grid &grid, double level);

} // namespace vibroimpact::derived
