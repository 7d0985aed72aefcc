#include "structure/assembly.h"

#include <algorithm>

namespace vibroimpact::structure {

namespace {

using petsc::check;

FreeDofs number_free(const FrameModel &model, const Discretisation &space) {
  const std::size_t nodes = model.mesh.nodes.size();
  std::vector<int> number(6 * nodes, 0);
  for (std::size_t node = 0; node < nodes; ++node)
    for (int component = 0; component < 6; ++component)
      number[space.dofs[node][component]] = model.fixed[node][component] ? -1 : 0;
  FreeDofs free;
  for (std::size_t dof = 0; dof < number.size(); ++dof) {
    if (static_cast<int>(dof) == space.own_begin)
      free.own_begin = free.size;
    if (number[dof] == 0)
      number[dof] = free.size++;
    if (static_cast<int>(dof) + 1 == space.own_end)
      free.own_end = free.size;
  }
  if (space.own_begin == space.own_end)
    free.own_begin = free.own_end = 0;
  free.number.resize(nodes);
  for (std::size_t node = 0; node < nodes; ++node)
    for (int component = 0; component < 6; ++component)
      free.number[node][component] = number[space.dofs[node][component]];
  return free;
}

// A node couples with itself and with its neighbours, six components each.
std::vector<PetscInt> row_lengths(const FrameModel &model, const FreeDofs &free) {
  std::vector<int> neighbours(model.mesh.nodes.size(), 0);
  for (const auto &cell : model.mesh.cells)
    for (const int node : cell)
      ++neighbours[node];
  std::vector<PetscInt> lengths(free.own_end - free.own_begin, 0);
  for (std::size_t node = 0; node < neighbours.size(); ++node)
    for (const int dof : free.number[node])
      if (dof >= free.own_begin && dof < free.own_end)
        lengths[dof - free.own_begin] = 6 * (1 + neighbours[node]);
  return lengths;
}

petsc::Matrix empty_matrix(const FrameModel &model, const FreeDofs &free, MPI_Comm communicator) {
  const PetscInt own = free.own_end - free.own_begin;
  std::vector<PetscInt> inside = row_lengths(model, free);
  std::vector<PetscInt> outside = inside;
  for (std::size_t row = 0; row < inside.size(); ++row) {
    inside[row] = std::min(inside[row], own);
    outside[row] = std::min(outside[row], free.size - own);
  }
  petsc::Matrix matrix;
  check(MatCreateAIJ(communicator, own, own, free.size, free.size, 0, inside.data(), 0,
                     outside.data(), matrix.address()),
        "Making a matrix");
  return matrix;
}

void finish(const petsc::Matrix &matrix) {
  check(MatAssemblyBegin(matrix.get(), MAT_FINAL_ASSEMBLY), "Assembling a matrix");
  check(MatAssemblyEnd(matrix.get(), MAT_FINAL_ASSEMBLY), "Assembling a matrix");
  check(MatSetOption(matrix.get(), MAT_SYMMETRIC, PETSC_TRUE), "Marking a matrix symmetric");
  check(MatSetOption(matrix.get(), MAT_SYMMETRY_ETERNAL, PETSC_TRUE), "Marking a matrix symmetric");
}

std::array<PetscInt, 12> cell_dofs(const FrameModel &model, const FreeDofs &free,
                                   std::size_t cell) {
  std::array<PetscInt, 12> dofs{};
  for (int i = 0; i < 12; ++i)
    dofs[i] = free.number[model.mesh.cells[cell][i / 6]][i % 6];
  return dofs;
}

// PETSc leaves out rows and columns with negative numbers: that eliminates the held ones. Element
// matrices are symmetric, so their column-major storage serves as row-major.
template <class ElementFunction>
void add_elements(const AssembledBody &body, const std::vector<int> &own_cells, Mat matrix,
                  ElementFunction element) {
  for (const int cell : own_cells) {
    const ElementMatrix values = element(body.model.properties, body.model.frames[cell]);
    const std::array<PetscInt, 12> dofs = cell_dofs(body.model, body.free, cell);
    check(MatSetValues(matrix, 12, dofs.data(), 12, dofs.data(), values.data(), ADD_VALUES),
          "Assembling a matrix");
  }
}

void add_diagonal(const FreeDofs &free, const std::vector<std::array<double, 6>> &values,
                  Mat matrix) {
  for (std::size_t node = 0; node < values.size(); ++node)
    for (int component = 0; component < 6; ++component) {
      const PetscInt dof = free.number[node][component];
      if (dof >= free.own_begin && dof < free.own_end && values[node][component] != 0)
        check(MatSetValue(matrix, dof, dof, values[node][component], ADD_VALUES),
              "Assembling a matrix");
    }
}

vibroimpact::Matrix base_inertia(const FrameModel &model, const FreeDofs &free) {
  vibroimpact::Matrix inertia = vibroimpact::Matrix::Zero(free.size, 3);
  for (std::size_t cell = 0; cell < model.mesh.cells.size(); ++cell) {
    const ElementMatrix mass = mass_matrix(model.properties, model.frames[cell]);
    const std::array<PetscInt, 12> dofs = cell_dofs(model, free, cell);
    for (int i = 0; i < 12; ++i)
      for (int axis = 0; dofs[i] >= 0 && axis < 3; ++axis)
        inertia(dofs[i], axis) += mass(i, axis) + mass(i, 6 + axis);
  }
  for (std::size_t node = 0; node < model.lumped_mass.size(); ++node)
    for (int axis = 0; axis < 3; ++axis)
      if (free.number[node][axis] >= 0)
        inertia(free.number[node][axis], axis) += model.lumped_mass[node][axis];
  return inertia;
}

// The mass of a beam with density is positive definite; without density only lumped masses count.
int count_massive(const FrameModel &model, const FreeDofs &free) {
  if (model.properties.mass_per_length > 0)
    return free.size;
  int count = 0;
  for (std::size_t node = 0; node < model.lumped_mass.size(); ++node)
    for (int component = 0; component < 6; ++component)
      count += free.number[node][component] >= 0 && model.lumped_mass[node][component] > 0;
  return count;
}

} // namespace

AssembledBody assemble(FrameModel model, MPI_Comm communicator) {
  AssembledBody body;
  body.model = std::move(model);
  const Discretisation space = discretise(body.model.mesh, communicator);
  body.free = number_free(body.model, space);
  if (body.free.size == 0)
    throw DefinitionError("Modes", "", "Number",
                          "cannot be met: the supports hold every degree of freedom");
  for (petsc::Matrix *matrix : {&body.stiffness, &body.mass, &body.distributed_mass})
    *matrix = empty_matrix(body.model, body.free, communicator);
  add_elements(body, space.own_cells, body.stiffness.get(), stiffness_matrix);
  add_elements(body, space.own_cells, body.mass.get(), mass_matrix);
  add_elements(body, space.own_cells, body.distributed_mass.get(), mass_matrix);
  add_diagonal(body.free, body.model.spring, body.stiffness.get());
  add_diagonal(body.free, body.model.lumped_mass, body.mass.get());
  for (const petsc::Matrix *matrix : {&body.stiffness, &body.mass, &body.distributed_mass})
    finish(*matrix);
  body.accurate_stiffness =
      std::make_unique<StiffnessOperator>(body.model, body.free, space.own_cells, communicator);
  body.base_inertia = base_inertia(body.model, body.free);
  body.massive_dofs = count_massive(body.model, body.free);
  return body;
}

} // namespace vibroimpact::structure
