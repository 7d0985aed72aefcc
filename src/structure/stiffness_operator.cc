#include "structure/stiffness_operator.h"

#include <algorithm>

namespace vibroimpact::structure {

using petsc::check;

std::vector<int> FreeDofs::of(const Element &element) const {
  std::vector<int> dofs;
  for (const int node : element.nodes())
    dofs.insert(dofs.end(), number[node].begin(), number[node].begin() + element.components());
  return dofs;
}

std::vector<FreeDofs::Term> FreeDofs::terms(int node, int component) const {
  const auto found = linked.find(node);
  const LinkedNode motion = found == linked.end() ? LinkedNode{.master = node} : found->second;
  std::vector<Term> terms;
  for (int other = 0; other < 6; ++other)
    if (const double factor = motion.motion(component, other); factor != 0)
      if (const int dof = number[motion.master][other]; dof >= 0)
        terms.push_back({dof, factor});
  return terms;
}

StiffnessOperator::StiffnessOperator(const FreeDofs &free)
    : free_(free), local_of_dof_(free.size, -1) {}

int StiffnessOperator::local_number(int dof) {
  if (dof < 0)
    return -1;
  int &local = local_of_dof_[dof];
  if (local < 0) {
    local = static_cast<int>(dofs_.size());
    dofs_.push_back(dof);
  }
  return local;
}

void StiffnessOperator::add(std::shared_ptr<const Element> element, const NodalMatrix &stiffness,
                            const std::vector<int> &dofs) {
  parts_.push_back({std::move(element), stiffness.rows(), local_.size(), lower_.size()});
  for (const int dof : dofs)
    local_.push_back(local_number(dof));
  for (Index j = 0; j < stiffness.cols(); ++j)
    lower_.insert(lower_.end(), &stiffness(j, j), &stiffness(j, j) + stiffness.rows() - j);
}

NodalMatrix StiffnessOperator::stiffness_of(const Part &part) const {
  NodalMatrix stiffness(part.size, part.size);
  const double *entry = lower_.data() + part.lower_begin;
  for (Index j = 0; j < part.size; ++j)
    for (Index i = j; i < part.size; ++i)
      stiffness(i, j) = stiffness(j, i) = *entry++;
  return stiffness;
}

void StiffnessOperator::add_springs(const std::vector<std::array<double, 6>> &springs) {
  for (std::size_t node = 0; node < springs.size(); ++node)
    for (int component = 0; component < 6; ++component) {
      const int dof = free_.number[node][component];
      if (springs[node][component] != 0 && !free_.linked.contains(static_cast<int>(node)) &&
          dof >= free_.own_begin && dof < free_.own_end)
        springs_.push_back({local_number(dof), springs[node][component]});
    }
}

void StiffnessOperator::finish(MPI_Comm communicator) {
  const auto ghosts = static_cast<PetscInt>(dofs_.size());
  const PetscInt own = free_.own_end - free_.own_begin;
  petsc::IndexSet from;
  petsc::Vector distributed;
  check(ISCreateGeneral(PETSC_COMM_SELF, ghosts, dofs_.data(), PETSC_COPY_VALUES, from.address()),
        "Numbering a stiffness operator");
  check(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, ghosts, nullptr, ghosted_.address()),
        "Making a vector");
  check(VecCreateMPI(communicator, own, free_.size, distributed.address()), "Making a vector");
  check(
      VecScatterCreate(distributed.get(), from.get(), ghosted_.get(), nullptr, scatter_.address()),
      "Making a scatter");
  check(MatCreateShell(communicator, own, own, free_.size, free_.size, this, shell_.address()),
        "Making a stiffness operator");
  check(MatShellSetOperation(shell_.get(), MATOP_MULT, reinterpret_cast<void (*)()>(&multiply)),
        "Making a stiffness operator");
  for (const MatType dense : {MATSEQDENSE, MATMPIDENSE})
    check(MatShellSetMatProductOperation(shell_.get(), MATPRODUCT_AB, nullptr, &multiply_columns,
                                         nullptr, dense, dense),
          "Making a stiffness operator");
}

namespace {

StiffnessOperator &operator_of(Mat shell) {
  void *context = nullptr;
  MatShellGetContext(shell, static_cast<void *>(&context));
  return *static_cast<StiffnessOperator *>(context);
}

} // namespace

PetscErrorCode StiffnessOperator::multiply(Mat shell, Vec x, Vec y) {
  StiffnessOperator &self = operator_of(shell);
  self.begin(1);
  self.take(x, 0);
  self.add_products();
  self.give(0, y);
  return 0;
}

PetscErrorCode StiffnessOperator::multiply_columns(Mat shell, Mat x, Mat y, void * /*unused*/) {
  constexpr PetscInt together = 8;
  StiffnessOperator &self = operator_of(shell);
  PetscInt columns = 0;
  MatGetSize(x, nullptr, &columns);
  Vec column = nullptr;
  for (PetscInt first = 0; first < columns; first += together) {
    const PetscInt count = std::min(together, columns - first);
    self.begin(count);
    for (PetscInt j = 0; j < count; ++j) {
      MatDenseGetColumnVecRead(x, first + j, &column);
      self.take(column, j);
      MatDenseRestoreColumnVecRead(x, first + j, &column);
    }
    self.add_products();
    for (PetscInt j = 0; j < count; ++j) {
      MatDenseGetColumnVecWrite(y, first + j, &column);
      self.give(j, column);
      MatDenseRestoreColumnVecWrite(y, first + j, &column);
    }
  }
  return 0;
}

void StiffnessOperator::begin(Index columns) {
  const auto rows = static_cast<Index>(dofs_.size());
  in_.resize(rows, columns);
  out_.setZero(rows, columns);
}

void StiffnessOperator::take(Vec x, Index column) {
  VecPlaceArray(ghosted_.get(), in_.col(column).data());
  VecScatterBegin(scatter_.get(), x, ghosted_.get(), INSERT_VALUES, SCATTER_FORWARD);
  VecScatterEnd(scatter_.get(), x, ghosted_.get(), INSERT_VALUES, SCATTER_FORWARD);
  VecResetArray(ghosted_.get());
}

void StiffnessOperator::give(Index column, Vec y) {
  VecZeroEntries(y);
  VecPlaceArray(ghosted_.get(), out_.col(column).data());
  VecScatterBegin(scatter_.get(), ghosted_.get(), y, ADD_VALUES, SCATTER_REVERSE);
  VecScatterEnd(scatter_.get(), ghosted_.get(), y, ADD_VALUES, SCATTER_REVERSE);
  VecResetArray(ghosted_.get());
}

void StiffnessOperator::add_products() {
  for (const Part &part : parts_) {
    const int *local = local_.data() + part.local_begin;
    NodalMatrix u(part.size, in_.cols());
    for (Index j = 0; j < in_.cols(); ++j)
      for (Index i = 0; i < part.size; ++i)
        u(i, j) = local[i] < 0 ? 0.0 : in_(local[i], j);
    const NodalMatrix force = part.element->force(stiffness_of(part), u);
    for (Index j = 0; j < in_.cols(); ++j)
      for (Index i = 0; i < part.size; ++i)
        if (local[i] >= 0)
          out_(local[i], j) += force(i, j);
  }
  for (const Spring &spring : springs_)
    out_.row(spring.local) += spring.stiffness * in_.row(spring.local);
}

} // namespace vibroimpact::structure
