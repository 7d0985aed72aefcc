#include "structure/stiffness_operator.h"

namespace vibroimpact::structure {

using petsc::check;

std::vector<int> FreeDofs::of(const Element &element) const {
  std::vector<int> dofs;
  for (const int node : element.nodes())
    dofs.insert(dofs.end(), number[node].begin(), number[node].end());
  return dofs;
}

StiffnessOperator::StiffnessOperator(const FreeDofs &free) : free_(free) {}

int StiffnessOperator::local_number(int dof) {
  if (dof < 0)
    return -1;
  return local_of_dof_.emplace(dof, static_cast<int>(local_of_dof_.size())).first->second;
}

void StiffnessOperator::add(std::shared_ptr<const Element> element, const NodalMatrix &stiffness,
                            const std::vector<int> &dofs) {
  Part part{std::move(element), stiffness, {}};
  for (const int dof : dofs)
    part.local.push_back(local_number(dof));
  parts_.push_back(std::move(part));
}

void StiffnessOperator::add_springs(const std::vector<std::array<double, 6>> &springs) {
  for (std::size_t node = 0; node < springs.size(); ++node)
    for (int component = 0; component < 6; ++component) {
      const int dof = free_.number[node][component];
      if (springs[node][component] != 0 && dof >= free_.own_begin && dof < free_.own_end)
        springs_.push_back({local_number(dof), springs[node][component]});
    }
}

void StiffnessOperator::finish(MPI_Comm communicator) {
  std::vector<PetscInt> dofs(local_of_dof_.size());
  for (const auto &[dof, local] : local_of_dof_)
    dofs[local] = dof;
  const auto ghosts = static_cast<PetscInt>(dofs.size());
  const PetscInt own = free_.own_end - free_.own_begin;
  petsc::IndexSet from;
  petsc::Vector distributed;
  check(ISCreateGeneral(PETSC_COMM_SELF, ghosts, dofs.data(), PETSC_COPY_VALUES, from.address()),
        "Numbering a stiffness operator");
  check(VecCreateSeq(PETSC_COMM_SELF, ghosts, ghosted_x_.address()), "Making a vector");
  check(VecCreateSeq(PETSC_COMM_SELF, ghosts, ghosted_y_.address()), "Making a vector");
  check(VecCreateMPI(communicator, own, free_.size, distributed.address()), "Making a vector");
  check(VecScatterCreate(distributed.get(), from.get(), ghosted_x_.get(), nullptr,
                         scatter_.address()),
        "Making a scatter");
  check(MatCreateShell(communicator, own, own, free_.size, free_.size, this, shell_.address()),
        "Making a stiffness operator");
  check(MatShellSetOperation(shell_.get(), MATOP_MULT, reinterpret_cast<void (*)()>(&multiply)),
        "Making a stiffness operator");
}

PetscErrorCode StiffnessOperator::multiply(Mat shell, Vec x, Vec y) {
  void *context = nullptr;
  MatShellGetContext(shell, static_cast<void *>(&context));
  static_cast<StiffnessOperator *>(context)->apply(x, y);
  return 0;
}

void StiffnessOperator::add_products(const double *in, double *out) const {
  for (const Part &part : parts_) {
    const auto size = static_cast<Index>(part.local.size());
    NodalVector u(size);
    for (Index i = 0; i < size; ++i)
      u[i] = part.local[i] < 0 ? 0.0 : in[part.local[i]];
    const NodalVector force = part.element->force(part.stiffness, u);
    for (Index i = 0; i < size; ++i)
      if (part.local[i] >= 0)
        out[part.local[i]] += force[i];
  }
  for (const Spring &spring : springs_)
    out[spring.local] += spring.stiffness * in[spring.local];
}

void StiffnessOperator::apply(Vec x, Vec y) {
  VecScatterBegin(scatter_.get(), x, ghosted_x_.get(), INSERT_VALUES, SCATTER_FORWARD);
  VecScatterEnd(scatter_.get(), x, ghosted_x_.get(), INSERT_VALUES, SCATTER_FORWARD);
  VecZeroEntries(ghosted_y_.get());
  const double *in = nullptr;
  double *out = nullptr;
  VecGetArrayRead(ghosted_x_.get(), &in);
  VecGetArray(ghosted_y_.get(), &out);
  add_products(in, out);
  VecRestoreArrayRead(ghosted_x_.get(), &in);
  VecRestoreArray(ghosted_y_.get(), &out);
  VecZeroEntries(y);
  VecScatterBegin(scatter_.get(), ghosted_y_.get(), y, ADD_VALUES, SCATTER_REVERSE);
  VecScatterEnd(scatter_.get(), ghosted_y_.get(), y, ADD_VALUES, SCATTER_REVERSE);
}

} // namespace vibroimpact::structure
