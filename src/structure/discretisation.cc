#include "structure/discretisation.h"

#include <deal.II/distributed/shared_tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/tria.h>

namespace vibroimpact::structure {

namespace {

using Triangulation = dealii::parallel::shared::Triangulation<1, 3>;

std::vector<dealii::Point<3>> deal_points(const LineMesh &mesh) {
  std::vector<dealii::Point<3>> points;
  for (const Vector3 &node : mesh.nodes)
    points.emplace_back(node[0], node[1], node[2]);
  return points;
}

std::vector<dealii::CellData<1>> deal_cells(const LineMesh &mesh) {
  std::vector<dealii::CellData<1>> cells;
  for (const auto &cell : mesh.cells) {
    dealii::CellData<1> data;
    data.vertices = {static_cast<unsigned int>(cell[0]), static_cast<unsigned int>(cell[1])};
    cells.push_back(data);
  }
  return cells;
}

void read_cells(const dealii::DoFHandler<1, 3> &space, Discretisation &result) {
  for (const auto &cell : space.active_cell_iterators()) {
    if (cell->is_locally_owned())
      result.own_cells.push_back(cell->index());
    for (unsigned int vertex = 0; vertex < 2; ++vertex)
      for (unsigned int component = 0; component < 6; ++component)
        result.dofs[cell->vertex_index(vertex)][component] =
            static_cast<int>(cell->vertex_dof_index(vertex, component));
  }
}

} // namespace

Discretisation discretise(const LineMesh &mesh, MPI_Comm communicator) {
  // Ordering the cells along the mesh and cutting that order into equal parts needs no partitioner
  // and gives the same parts on every machine.
  Triangulation triangulation(communicator, Triangulation::MeshSmoothing::none, false,
                              Triangulation::Settings::partition_zorder);
  triangulation.create_triangulation(deal_points(mesh), deal_cells(mesh), dealii::SubCellData());
  const dealii::FESystem<1, 3> element(dealii::FE_Q<1, 3>(1), 6);
  dealii::DoFHandler<1, 3> space(triangulation);
  space.distribute_dofs(element);

  Discretisation result;
  result.dofs.resize(mesh.nodes.size());
  read_cells(space, result);
  const dealii::IndexSet &own = space.locally_owned_dofs();
  result.own_begin = own.is_empty() ? 0 : static_cast<int>(own.nth_index_in_set(0));
  result.own_end = result.own_begin + static_cast<int>(own.n_elements());
  return result;
}

} // namespace vibroimpact::structure
