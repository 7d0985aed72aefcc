#include "reduction/basis_rule.h"

#include "modes/normal_modes.h"

#include <array>

namespace vibroimpact::reduction {

namespace {

struct Group {
  Index first, size;
};

std::vector<Group> groups_of(const Vector &eigenvalues) {
  std::vector<Group> groups;
  for (Index j = 0; j < eigenvalues.size(); ++j) {
    const bool continues =
        j > 0 && eigenvalues[j] - eigenvalues[groups.back().first] <=
                     modes::multiplicity_tolerance * eigenvalues[groups.back().first];
    if (continues)
      ++groups.back().size;
    else
      groups.push_back({j, 1});
  }
  return groups;
}

std::vector<Index> row_order(const std::vector<int> &points, Index nodes) {
  std::vector<Index> rows;
  for (const int point : points)
    for (Index component = 0; component < 6; ++component)
      rows.push_back(6 * point + component);
  for (Index row = 0; row < 6 * nodes; ++row)
    rows.push_back(row);
  return rows;
}

// Of the larger kind, rotations times the length of the body: a kind that stays below it in the
// whole group is what the eigen-solution leaves of one that is zero (the angle of a vector to its
// subspace is the square root of the error of its eigenvalue, and counts in rotations by the size
// of an element).
constexpr double least_kind = 1e-2;

// Displacements and rotations have different units, so each kind has its own scale.
std::array<double, 2> row_scales(Eigen::Ref<const Matrix> group, double length) {
  std::array<double, 2> scale{};
  for (Index row = 0; row < group.rows(); ++row) {
    double &kind = scale[row % 6 / 3];
    kind = std::max(kind, group.row(row).norm());
  }
  if (length > 0)
    scale = {std::max(scale[0], least_kind * scale[1] * length),
             std::max(scale[1], least_kind * scale[0] / length)};
  return scale;
}

// Householder reflection of the columns that takes `row` to (+, 0, 0, ...). The first entry of the
// reflection's normal is written without the cancellation of row[0] - |row|.
void reflect(Eigen::Ref<Matrix> columns, Index row) {
  Vector normal = columns.row(row).transpose();
  const double norm = normal.norm();
  const double rest = normal.tail(normal.size() - 1).squaredNorm();
  normal[0] = normal[0] > 0 ? -rest / (normal[0] + norm) : normal[0] - norm;
  const double square = normal.squaredNorm();
  if (square == 0)
    return;
  const Vector along = columns * normal;
  columns.noalias() -= 2 / square * along * normal.transpose();
}

void fix_group(Eigen::Ref<Matrix> group, const std::vector<Index> &rows, double length) {
  const std::array<double, 2> scale = row_scales(group, length);
  Index done = 0;
  for (double significant = 1e-3; done < group.cols() && significant > 1e-14; significant *= 1e-3)
    for (const Index row : rows) {
      const Index left = group.cols() - done;
      if (left == 0)
        return;
      const double size = group.row(row).tail(left).norm();
      if (size > significant * scale[row % 6 / 3]) {
        reflect(group.rightCols(left), row);
        ++done;
      }
    }
}

} // namespace

void fix_basis(const Vector &eigenvalues, const std::vector<int> &points, double length,
               Matrix &shapes) {
  const std::vector<Index> rows = row_order(points, shapes.rows() / 6);
  for (const Group &group : groups_of(eigenvalues))
    fix_group(shapes.middleCols(group.first, group.size), rows, length);
}

Vector merge_multiple(const Vector &eigenvalues) {
  Vector merged = eigenvalues;
  for (const Group &group : groups_of(eigenvalues))
    merged.segment(group.first, group.size)
        .setConstant(eigenvalues.segment(group.first, group.size).mean());
  return merged;
}

} // namespace vibroimpact::reduction
