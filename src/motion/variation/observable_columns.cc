#include "motion/variation/observable_columns.h"

#include "common/decompositions.h"

#include <algorithm>

namespace vibroimpact::motion {

namespace {

constexpr int most_terms = 40;
constexpr double last_term = 1e-17;   // of rows of length 1
constexpr double largest_term = 100;  // beyond, the sum loses digits
constexpr double independent = 1e-15; // of the largest direction
constexpr double worth_it = 0.6;      // of the columns
constexpr double least_scale = 1e-3;  // of the largest one of displacements, of velocities

// A mode with a node at every point that matters moves these by rounding alone, and its scale says
// so. The basis mixes columns: divided by such a scale, rounding of that mode would count in all.
Vector balanced(const Equations &equations, Vector scale) {
  const StateLayout &layout = equations.layout();
  for (const Index first : {Index{0}, layout.velocity()}) {
    auto of_kind = scale.segment(first, layout.n);
    of_kind = of_kind.cwiseMax(least_scale * of_kind.maxCoeff()).eval();
  }
  return scale;
}

// Rows of gaps, slips, their rates and internal states, of length 1 in scaled coordinates.
Matrix observed_rows(const Equations &equations, const Vector &scale) {
  const StateLayout &layout = equations.layout();
  std::vector<RowVector> rows;
  const auto row_at = [&](Index first, const RowVector &entries) {
    RowVector &row = rows.emplace_back(RowVector::Zero(scale.size()));
    row.segment(first, entries.size()) = entries;
  };
  for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
    if (equations.mode(c).affine || equations.mode(c).holds_gap)
      continue;
    const contact::ContactPair &pair = equations.contacts().pairs()[c];
    for (int d = 0; d < pair.n_directions(); ++d) {
      row_at(0, pair.along(d).projection->row);
      row_at(layout.velocity(), pair.along(d).projection->row);
    }
    for (Index i = 0; i < pair.n_internal(); ++i)
      row_at(layout.internal() + pair.internal_offset + i, RowVector::Ones(1));
  }
  Matrix scaled(static_cast<Index>(rows.size()), scale.size());
  for (Index i = 0; i < scaled.rows(); ++i)
    scaled.row(i) = rows[static_cast<std::size_t>(i)].cwiseQuotient(scale.transpose()).normalized();
  return scaled;
}

// Columns (w (A h)^k / k!)^T; none where there are too many terms.
std::optional<Matrix> directions(const Matrix &rows, const Matrix &generator, double h) {
  Matrix all(generator.rows(), 0);
  Matrix term = rows;
  for (int k = 1; k <= most_terms; ++k) {
    all.conservativeResize(Eigen::NoChange, all.cols() + rows.rows());
    all.rightCols(rows.rows()) = term.transpose();
    term = (term * generator * (h / k)).eval();
    const double size = rows.rows() > 0 ? term.rowwise().norm().maxCoeff() : 0;
    if (size < last_term)
      return all;
    if (!(size < largest_term))
      break;
  }
  return std::nullopt;
}

} // namespace

std::optional<ObservableColumns> observable_columns(const Equations &equations, LinearFlow &free,
                                                    const Vector &scale_of_error, double h,
                                                    const Matrix &columns) {
  const Vector scale = balanced(equations, scale_of_error);
  const auto inverse = scale.cwiseInverse().asDiagonal();
  const Matrix generator = scale.asDiagonal() * free.generator() * inverse;
  const auto found = directions(observed_rows(equations, scale), generator, h);
  if (!found)
    return std::nullopt;
  Matrix basis(scale.size(), 0);
  if (found->cols() > 0) {
    const PivotedQr qr(*found, independent);
    basis = qr.basis(qr.rank());
  }
  if (static_cast<double>(basis.cols()) > worth_it * static_cast<double>(columns.cols()))
    return std::nullopt;
  const Matrix scaled = scale.asDiagonal() * columns;
  ObservableColumns split{
      .basis = inverse * basis, .coefficients = basis.transpose() * scaled, .rest = {}};
  split.rest = inverse * (scaled - basis * split.coefficients);
  free.propagate(h, split.rest);
  return split;
}

} // namespace vibroimpact::motion
