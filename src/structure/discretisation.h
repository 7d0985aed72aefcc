// The finite element space of a frame: six components per node, numbered and shared out over the
// ranks by deal.II. Plain data, the same on every rank except for what a rank owns.
#pragma once

#include "structure/line_mesh.h"

#include <mpi.h>

namespace vibroimpact::structure {

struct Discretisation {
  std::vector<std::array<int, 6>> dofs; ///< per node: number of each component
  std::vector<int> own_cells;           ///< cells this rank assembles
  int own_begin = 0;                    ///< this rank owns the degrees of freedom
  int own_end = 0;                      ///< own_begin <= dof < own_end
};

/// Collective. The numbering is by rank: each rank's degrees of freedom are contiguous.
Discretisation discretise(const LineMesh &mesh, MPI_Comm communicator);

} // namespace vibroimpact::structure
