#include "structure/given_assembly.h"

#include "structure/given_matrices.h"

#include <algorithm>

namespace vibroimpact::structure {

namespace {

FreeDofs number_given(const BodyModel &model) {
  const GivenMatrices &given = *model.given;
  FreeDofs free;
  free.number.assign(model.mesh.nodes.size(), {-1, -1, -1, -1, -1, -1});
  for (int row = 0; row < given.size; ++row) {
    if (row == given.own_begin)
      free.own_begin = free.size;
    const auto [node, component] = given.place[row];
    if (!model.fixed[node][component])
      free.number[node][component] = free.size++;
    if (row + 1 == given.own_end)
      free.own_end = free.size;
  }
  if (given.own_begin == given.own_end)
    free.own_begin = free.own_end = 0;
  return free;
}

struct RowEntry {
  int column = 0; ///< of the table
  double stiffness = 0;
  double mass = 0;
};

class GivenRows {
public:
  explicit GivenRows(const BodyModel &model) : model_(model), given_(*model.given) {
    for (int row = 0; row < given_.size; ++row)
      if (model.lumped_masses.contains(given_.place[row][0]))
        heavy_rows_[given_.place[row][0]].push_back(row);
  }

  /// Of a row of this rank, with the spring and the lumped mass of its node; ascending columns.
  std::vector<RowEntry> entries(int row) const {
    std::vector<RowEntry> all;
    const int local = row - given_.own_begin;
    for (int k = given_.rows.begins[local]; k < given_.rows.begins[local + 1]; ++k)
      all.push_back({given_.rows.columns[k], given_.stiffness[k], given_.mass[k]});
    const auto [node, component] = given_.place[row];
    if (const double spring = model_.spring[node][component]; spring != 0)
      all.push_back({.column = row, .stiffness = spring});
    if (const auto lumped = model_.lumped_masses.find(node); lumped != model_.lumped_masses.end())
      for (const int other : heavy_rows_.at(node))
        all.push_back({.column = other, .mass = lumped->second(component, given_.place[other][1])});
    return merged(std::move(all));
  }

private:
  static std::vector<RowEntry> merged(std::vector<RowEntry> all) {
    std::stable_sort(all.begin(), all.end(),
                     [](const RowEntry &a, const RowEntry &b) { return a.column < b.column; });
    std::vector<RowEntry> sums;
    for (const RowEntry &entry : all)
      if (!sums.empty() && sums.back().column == entry.column) {
        sums.back().stiffness += entry.stiffness;
        sums.back().mass += entry.mass;
      } else {
        sums.push_back(entry);
      }
    return sums;
  }

  const BodyModel &model_;
  const GivenMatrices &given_;
  std::map<int, std::vector<int>> heavy_rows_; ///< of the nodes with a lumped mass
};

/// Goes through the rows of this rank.
class GivenAssembly {
public:
  explicit GivenAssembly(AssembledBody &body)
      : body_(body), model_(body.model), given_(*body.model.given), rows_(body.model) {}

  void assemble(MPI_Comm communicator) {
    body_.base_inertia = vibroimpact::Matrix::Zero(body_.free.size, 3);
    for (int row = given_.own_begin; row < given_.own_end; ++row)
      take(row);
    body_.stiffness = sparse_matrix(body_.free, pattern_, stiffness_, communicator);
    body_.mass = sparse_matrix(body_.free, pattern_, mass_, communicator);
    if (given_.damped())
      take_damping(communicator);
    MPI_Allreduce(MPI_IN_PLACE, body_.base_inertia.data(),
                  static_cast<int>(body_.base_inertia.size()), MPI_DOUBLE, MPI_SUM, communicator);
    MPI_Allreduce(MPI_IN_PLACE, body_.total_mass.data(), 3, MPI_DOUBLE, MPI_SUM, communicator);
    MPI_Allreduce(MPI_IN_PLACE, &body_.massive_dofs, 1, MPI_INT, MPI_SUM, communicator);
  }

private:
  int free_number(int row) const {
    const auto [node, component] = given_.place[row];
    return body_.free.number[node][component];
  }

  /// The axis along which a rigid displacement of the body moves a row; 3 where none does.
  int axis_of(int row) const {
    const auto [node, component] = given_.place[row];
    return node < static_cast<int>(model_.mesh.places().size()) ? std::min(component, 3) : 3;
  }

  void take(int row) {
    Vector3 inertia = Vector3::Zero(); // the row of M r
    const int free = free_number(row);
    for (const RowEntry &entry : rows_.entries(row)) {
      if (const int axis = axis_of(entry.column); axis < 3)
        inertia[axis] += entry.mass;
      const int column = free_number(entry.column);
      if (free < 0 || column < 0)
        continue;
      pattern_.columns.push_back(column);
      stiffness_.push_back(entry.stiffness);
      mass_.push_back(entry.mass);
      body_.massive_dofs += entry.column == row && entry.mass > 0;
    }
    if (const int axis = axis_of(row); axis < 3)
      body_.total_mass[axis] += inertia[axis];
    if (free < 0)
      return;
    pattern_.begins.push_back(static_cast<int>(pattern_.columns.size()));
    body_.base_inertia.row(free) = inertia;
  }

  void take_damping(MPI_Comm communicator) {
    SparseRows pattern;
    std::vector<double> values;
    for (int row = given_.own_begin; row < given_.own_end; ++row) {
      if (free_number(row) < 0)
        continue;
      const int local = row - given_.own_begin;
      for (int k = given_.damping_rows.begins[local]; k < given_.damping_rows.begins[local + 1];
           ++k)
        if (const int column = free_number(given_.damping_rows.columns[k]); column >= 0) {
          pattern.columns.push_back(column);
          values.push_back(given_.damping[k]);
        }
      pattern.begins.push_back(static_cast<int>(pattern.columns.size()));
    }
    body_.damping = sparse_matrix(body_.free, pattern, values, communicator);
  }

  AssembledBody &body_;
  const BodyModel &model_;
  const GivenMatrices &given_;
  GivenRows rows_;
  SparseRows pattern_;
  std::vector<double> stiffness_;
  std::vector<double> mass_;
};

} // namespace

void assemble_given(AssembledBody &body, MPI_Comm communicator) {
  body.free = number_given(body.model);
  check_free(body.free);
  GivenAssembly(body).assemble(communicator);
}

} // namespace vibroimpact::structure
