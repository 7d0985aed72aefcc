#include "structure/assembly.h"

#include <algorithm>

namespace vibroimpact::structure {

namespace {

using petsc::check;

FreeDofs number_free(const BodyModel &model, const Discretisation &space) {
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

/// Entries of this rank's rows, in its own columns and in those of others.
struct RowLengths {
  std::vector<PetscInt> inside;
  std::vector<PetscInt> outside;
};

RowLengths row_lengths(const FreeDofs &free, const Discretisation &space) {
  RowLengths lengths;
  lengths.inside.assign(free.own_end - free.own_begin, 0);
  lengths.outside = lengths.inside;
  const auto own = [&](int dof) { return dof >= free.own_begin && dof < free.own_end; };
  for (std::size_t node = 0; node < space.neighbours.size(); ++node) {
    PetscInt inside = 0;
    PetscInt outside = 0;
    for (const int neighbour : space.neighbours[node])
      for (const int dof : free.number[neighbour])
        if (dof >= 0)
          ++(own(dof) ? inside : outside);
    for (const int dof : free.number[node])
      if (own(dof)) {
        lengths.inside[dof - free.own_begin] = inside;
        lengths.outside[dof - free.own_begin] = outside;
      }
  }
  return lengths;
}

petsc::Matrix empty_matrix(const FreeDofs &free, const RowLengths &lengths, MPI_Comm communicator) {
  const PetscInt own = free.own_end - free.own_begin;
  petsc::Matrix matrix;
  check(MatCreateAIJ(communicator, own, own, free.size, free.size, 0, lengths.inside.data(), 0,
                     lengths.outside.data(), matrix.address()),
        "Making a matrix");
  return matrix;
}

void finish(const petsc::Matrix &matrix) {
  check(MatAssemblyBegin(matrix.get(), MAT_FINAL_ASSEMBLY), "Assembling a matrix");
  check(MatAssemblyEnd(matrix.get(), MAT_FINAL_ASSEMBLY), "Assembling a matrix");
  check(MatSetOption(matrix.get(), MAT_SYMMETRIC, PETSC_TRUE), "Marking a matrix symmetric");
  check(MatSetOption(matrix.get(), MAT_SYMMETRY_ETERNAL, PETSC_TRUE), "Marking a matrix symmetric");
}

// PETSc leaves out rows and columns with negative numbers: that eliminates the held ones. Element
// matrices are symmetric, so their column-major storage serves as row-major.
void add_element(const std::vector<int> &dofs, const NodalMatrix &values, Mat matrix) {
  const auto size = static_cast<PetscInt>(dofs.size());
  check(MatSetValues(matrix, size, dofs.data(), size, dofs.data(), values.data(), ADD_VALUES),
        "Assembling a matrix");
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

void assemble_matrices(AssembledBody &body, const Discretisation &space, MPI_Comm communicator) {
  const RowLengths lengths = row_lengths(body.free, space);
  for (petsc::Matrix *matrix : {&body.stiffness, &body.mass, &body.distributed_mass})
    *matrix = empty_matrix(body.free, lengths, communicator);
  body.accurate_stiffness = std::make_unique<StiffnessOperator>(body.free);
  for (const int number : space.own_elements) {
    const std::shared_ptr<const Element> &element = body.model.elements[number];
    const std::vector<int> dofs = body.free.of(*element);
    const NodalMatrix stiffness = element->stiffness();
    const NodalMatrix mass = element->mass();
    add_element(dofs, stiffness, body.stiffness.get());
    add_element(dofs, mass, body.mass.get());
    add_element(dofs, mass, body.distributed_mass.get());
    body.accurate_stiffness->add(element, stiffness, dofs);
  }
  add_diagonal(body.free, body.model.spring, body.stiffness.get());
  add_diagonal(body.free, body.model.lumped_mass, body.mass.get());
  for (const petsc::Matrix *matrix : {&body.stiffness, &body.mass, &body.distributed_mass})
    finish(*matrix);
  body.accurate_stiffness->add_springs(body.model.spring);
  body.accurate_stiffness->finish(communicator);
}

vibroimpact::Matrix base_inertia(const BodyModel &model, const FreeDofs &free) {
  vibroimpact::Matrix inertia = vibroimpact::Matrix::Zero(free.size, 3);
  for (const auto &element : model.elements) {
    const NodalMatrix mass = element->mass();
    const std::vector<int> dofs = free.of(*element);
    for (std::size_t i = 0; i < dofs.size(); ++i)
      for (Index column = 0; dofs[i] >= 0 && column < mass.cols(); ++column)
        if (column % 6 < 3)
          inertia(dofs[i], column % 6) += mass(static_cast<Index>(i), column);
  }
  for (std::size_t node = 0; node < model.lumped_mass.size(); ++node)
    for (int axis = 0; axis < 3; ++axis)
      if (free.number[node][axis] >= 0)
        inertia(free.number[node][axis], axis) += model.lumped_mass[node][axis];
  return inertia;
}

vibroimpact::Vector static_load(const AssembledBody &body) {
  vibroimpact::Vector load = body.base_inertia * body.model.acceleration;
  for (std::size_t node = 0; node < body.model.load.size(); ++node)
    for (int component = 0; component < 6; ++component)
      if (const int dof = body.free.number[node][component]; dof >= 0)
        load[dof] += body.model.load[node][component];
  return load;
}

// The mass matrix of an element with density is positive definite; elsewhere only lumped masses
// count.
int count_massive(const BodyModel &model, const FreeDofs &free) {
  std::vector<bool> heavy(model.mesh.nodes.size(), false);
  for (const auto &element : model.elements)
    if (element->total_mass() > 0)
      for (const int node : element->nodes())
        heavy[node] = true;
  int count = 0;
  for (std::size_t node = 0; node < heavy.size(); ++node)
    for (int component = 0; component < 6; ++component)
      count += free.number[node][component] >= 0 &&
               (heavy[node] || model.lumped_mass[node][component] > 0);
  return count;
}

} // namespace

AssembledBody assemble(BodyModel model, MPI_Comm communicator) {
  AssembledBody body;
  body.model = std::move(model);
  const Discretisation space =
      discretise(body.model.mesh.nodes.size(), body.model.elements, communicator);
  body.free = number_free(body.model, space);
  if (body.free.size == 0)
    throw DefinitionError("Modes", "", "Number",
                          "cannot be met: the supports hold every degree of freedom");
  assemble_matrices(body, space, communicator);
  body.base_inertia = base_inertia(body.model, body.free);
  body.load = static_load(body);
  body.massive_dofs = count_massive(body.model, body.free);
  return body;
}

} // namespace vibroimpact::structure
