// The degrees of freedom of a body, six for each node, numbered and shared out over the ranks.
// Plain data, the same on every rank except for what a rank owns.
//
// Bodies hold lines, triangles and quadrilaterals at once, and more than two surfaces may meet in
// an edge. No triangulation of deal.II takes such a mesh (one holds cells of one dimension, and its
// neighbourhoods end at a second one), so the numbering works on the graph of the nodes, with
// deal.II's tools for graphs.
#pragma once

#include "structure/element.h"

#include <array>
#include <mpi.h>

namespace vibroimpact::structure {

struct Discretisation {
  std::vector<std::array<int, 6>> dofs;     ///< per node: number of each component
  std::vector<int> own_elements;            ///< elements this rank assembles
  std::vector<std::vector<int>> neighbours; ///< per node: the nodes it shares elements with, and it
  int own_begin = 0;                        ///< this rank owns the degrees of freedom
  int own_end = 0;                          ///< own_begin <= dof < own_end
};

/// The numbering is by rank: each rank's degrees of freedom are contiguous.
Discretisation discretise(std::size_t nodes, const Elements &elements, MPI_Comm communicator);

} // namespace vibroimpact::structure
