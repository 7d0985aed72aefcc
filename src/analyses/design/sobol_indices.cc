#include "analyses/design/sobol_indices.h"

#include "common/scalar.h"
#include "common/uniform_numbers.h"

#include <cmath>

namespace vibroimpact::analyses {

namespace {

constexpr int resamples = 1000;

/// f_A, f_B and f_ABi of the good rows: rows x (arguments + 2).
Matrix good_rows(const std::vector<double> &values, Index columns) {
  Matrix rows(static_cast<Index>(values.size()) / columns, columns);
  Index good = 0;
  for (Index r = 0; r < rows.rows(); ++r) {
    for (Index c = 0; c < columns; ++c)
      rows(good, c) = values[static_cast<std::size_t>(r * columns + c)];
    good += rows.row(good).allFinite() ? 1 : 0;
  }
  rows.conservativeResize(good, columns);
  return rows;
}

struct Estimates {
  double mean = 0, variance = 0;
  Vector first, total;
};

Estimates estimates(const Matrix &rows) {
  const auto n = static_cast<double>(rows.rows());
  const auto f_a = rows.col(0).array(), f_b = rows.col(1).array();
  Estimates result;
  result.mean = (f_a.sum() + f_b.sum()) / (2 * n);
  result.variance =
      ((f_a - result.mean).square().sum() + (f_b - result.mean).square().sum()) / (2 * n - 1);
  const Index arguments = rows.cols() - 2;
  result.first.resize(arguments);
  result.total.resize(arguments);
  for (Index i = 0; i < arguments; ++i) {
    const auto f_ab = rows.col(2 + i).array();
    result.first[i] = ((f_b - result.mean) * (f_ab - f_a)).mean() / result.variance;
    result.total[i] = (f_a - f_ab).square().mean() / (2 * result.variance);
  }
  return result;
}

Matrix drawn_again(const Matrix &rows, std::uint64_t seed, int number) {
  UniformNumbers random({seed, static_cast<std::uint64_t>(number), 1});
  Matrix drawn(rows.rows(), rows.cols());
  for (Index r = 0; r < rows.rows(); ++r)
    drawn.row(r) =
        rows.row(static_cast<Index>(random.below(static_cast<std::size_t>(rows.rows()))));
  return drawn;
}

/// Standard deviation over samples, each with the index in a column.
Vector deviations(const Matrix &samples) {
  const Matrix centred = samples.colwise() - samples.rowwise().mean();
  return (centred.rowwise().squaredNorm() / static_cast<double>(samples.cols() - 1)).cwiseSqrt();
}

} // namespace

std::size_t SobolDesign::points() const { return rows * static_cast<std::size_t>(arguments + 2); }

Vector SobolDesign::point(std::size_t number) const {
  const auto row = static_cast<std::uint64_t>(number) / static_cast<std::uint64_t>(arguments + 2);
  const auto column = static_cast<Index>(number) % (arguments + 2);
  UniformNumbers random({seed, row});
  Vector a(arguments), b(arguments);
  for (Vector *of_row : {&a, &b})
    for (Index j = 0; j < arguments; ++j)
      (*of_row)[j] = random.next();
  if (column == 1)
    return b;
  if (column > 1)
    a[column - 2] = b[column - 2];
  return a;
}

SobolIndices sobol_indices(const std::vector<double> &values, Index arguments, std::uint64_t seed) {
  const Matrix rows = good_rows(values, arguments + 2);
  SobolIndices result{
      .mean = nan,
      .variance = nan,
      .rows = static_cast<std::size_t>(rows.rows()),
      .arguments = {static_cast<std::size_t>(arguments), SobolIndex{nan, nan, nan, nan}}};
  if (rows.rows() < 2)
    return result;
  const Estimates whole = estimates(rows);
  result.mean = whole.mean;
  result.variance = whole.variance;
  if (!(whole.variance > 0))
    return result;
  Matrix first(arguments, resamples), total(arguments, resamples);
  for (int s = 0; s < resamples; ++s) {
    const Estimates again = estimates(drawn_again(rows, seed, s));
    first.col(s) = again.first;
    total.col(s) = again.total;
  }
  const Vector first_errors = deviations(first), total_errors = deviations(total);
  for (Index i = 0; i < arguments; ++i)
    result.arguments[static_cast<std::size_t>(i)] = {whole.first[i], first_errors[i],
                                                     whole.total[i], total_errors[i]};
  return result;
}

} // namespace vibroimpact::analyses
