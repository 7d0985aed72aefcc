#include "structure/stiffness_operator.h"

namespace vibroimpact::structure {

using petsc::check;

StiffnessOperator::StiffnessOperator(const FrameModel &model, const FreeDofs &free,
                                     const std::vector<int> &own_cells, MPI_Comm communicator)
    : properties_(model.properties) {
  for (const int cell : own_cells) {
    Element element{.frame = model.frames[cell]};
    for (int i = 0; i < 12; ++i)
      element.local[i] = local_number(free.number[model.mesh.cells[cell][i / 6]][i % 6]);
    elements_.push_back(element);
  }
  add_springs(model, free);

  std::vector<PetscInt> dofs(local_of_dof_.size());
  for (const auto &[dof, local] : local_of_dof_)
    dofs[local] = dof;
  const auto ghosts = static_cast<PetscInt>(dofs.size());
  const PetscInt own = free.own_end - free.own_begin;
  petsc::IndexSet from;
  petsc::Vector distributed;
  check(ISCreateGeneral(PETSC_COMM_SELF, ghosts, dofs.data(), PETSC_COPY_VALUES, from.address()),
        "Numbering a stiffness operator");
  check(VecCreateSeq(PETSC_COMM_SELF, ghosts, ghosted_x_.address()), "Making a vector");
  check(VecCreateSeq(PETSC_COMM_SELF, ghosts, ghosted_y_.address()), "Making a vector");
  check(VecCreateMPI(communicator, own, free.size, distributed.address()), "Making a vector");
  check(VecScatterCreate(distributed.get(), from.get(), ghosted_x_.get(), nullptr,
                         scatter_.address()),
        "Making a scatter");
  check(MatCreateShell(communicator, own, own, free.size, free.size, this, shell_.address()),
        "Making a stiffness operator");
  check(MatShellSetOperation(shell_.get(), MATOP_MULT, reinterpret_cast<void (*)()>(&multiply)),
        "Making a stiffness operator");
}

int StiffnessOperator::local_number(int dof) {
  if (dof < 0)
    return -1;
  return local_of_dof_.emplace(dof, static_cast<int>(local_of_dof_.size())).first->second;
}

void StiffnessOperator::add_springs(const FrameModel &model, const FreeDofs &free) {
  for (std::size_t node = 0; node < model.spring.size(); ++node)
    for (int component = 0; component < 6; ++component) {
      const int dof = free.number[node][component];
      if (model.spring[node][component] != 0 && dof >= free.own_begin && dof < free.own_end)
        springs_.push_back({local_number(dof), model.spring[node][component]});
    }
}

PetscErrorCode StiffnessOperator::multiply(Mat shell, Vec x, Vec y) {
  void *context = nullptr;
  MatShellGetContext(shell, static_cast<void *>(&context));
  static_cast<StiffnessOperator *>(context)->apply(x, y);
  return 0;
}

void StiffnessOperator::apply(Vec x, Vec y) {
  VecScatterBegin(scatter_.get(), x, ghosted_x_.get(), INSERT_VALUES, SCATTER_FORWARD);
  VecScatterEnd(scatter_.get(), x, ghosted_x_.get(), INSERT_VALUES, SCATTER_FORWARD);
  VecZeroEntries(ghosted_y_.get());
  const double *in = nullptr;
  double *out = nullptr;
  VecGetArrayRead(ghosted_x_.get(), &in);
  VecGetArray(ghosted_y_.get(), &out);
  for (const Element &element : elements_) {
    ElementVector u;
    for (int i = 0; i < 12; ++i)
      u[i] = element.local[i] < 0 ? 0.0 : in[element.local[i]];
    const ElementVector force = stiffness_product(properties_, element.frame, u);
    for (int i = 0; i < 12; ++i)
      if (element.local[i] >= 0)
        out[element.local[i]] += force[i];
  }
  for (const Spring &spring : springs_)
    out[spring.local] += spring.stiffness * in[spring.local];
  VecRestoreArrayRead(ghosted_x_.get(), &in);
  VecRestoreArray(ghosted_y_.get(), &out);
  VecZeroEntries(y);
  VecScatterBegin(scatter_.get(), ghosted_y_.get(), y, ADD_VALUES, SCATTER_REVERSE);
  VecScatterEnd(scatter_.get(), ghosted_y_.get(), y, ADD_VALUES, SCATTER_REVERSE);
}

} // namespace vibroimpact::structure
