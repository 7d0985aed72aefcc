// The tables of a phase for pieces of one length.
#include "common/decompositions.h"
#include "common/memory.h"
#include "motion/kernel/interpolation.h"
#include "motion/phase/exact_phase.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

namespace {

// Of a sum of products, by |f - p| / tau^r: what rounding adds to the error of the interpolation.
constexpr double table_rounding = 128 * 0x1p-52;
constexpr std::array<double, 3> order_factors = {1, 7, 21};

} // namespace

// A level that is there already lacks what was renewed since.
void ExactPhase::make_level(int index) {
  const std::unique_ptr<Level> &known = levels_[static_cast<std::size_t>(index)];
  level_bytes_ -= known ? known->bytes() : 0;
  Level &level = known ? *known : allocate_level(index);
  for (const PhaseGroup &group : groups_) {
    if (group.generation <= level.generation)
      continue;
    if (group.kind == BlockKind::dense)
      set_level_dense(level, group);
    else
      set_level_pair(level, group);
  }
  level.generation = generation_;
  level_bytes_ += level.bytes();
  show_level(index);
}

std::size_t ExactPhase::Level::bytes() const {
  return bytes_of(turn, growth, table, bounds, dense, dense_growth);
}

ExactPhase::Level &ExactPhase::allocate_level(int index) {
  const auto n = static_cast<std::size_t>(view_.n_padded);
  const auto forms = static_cast<std::size_t>(view_.n_forms);
  const auto columns = static_cast<std::size_t>(view_.n_groups + view_.n_pairs);
  auto level = std::make_unique<Level>();
  level->length = h0_ * std::exp2(-0.5 * index);
  level->turn.assign(2 * n, 0);
  level->growth.assign(n, 1);
  level->table.assign(forms * columns * 8, 0);
  level->bounds.assign(forms * 3 * n, 0);
  return *(levels_[static_cast<std::size_t>(index)] = std::move(level));
}

void ExactPhase::show_level(int index) {
  const Level &made = *levels_[static_cast<std::size_t>(index)];
  level_views_[static_cast<std::size_t>(index)] = {.length = made.length,
                                                   .turn = made.turn.data(),
                                                   .growth = made.growth.data(),
                                                   .dense_growth = made.dense_growth.data(),
                                                   .table = made.table.data(),
                                                   .bounds = made.bounds.data(),
                                                   .dense = made.dense.data()};
}

void ExactPhase::set_level_pair(Level &level, const PhaseGroup &group) {
  const auto j = static_cast<std::size_t>(group.first);
  const TabulatedExponential table(group.exponent * level.length);
  level.turn[j] = table.end.real();
  level.turn[static_cast<std::size_t>(view_.n_padded) + j] = table.end.imag();
  level.growth[j] = table.growth;
  for (std::size_t g = 0; g < constants_.size(); ++g)
    set_level_rows(level, g, group, table);
}

// c times the polynomial: a column for the real and one for the imaginary part of the amplitude.
void ExactPhase::set_level_rows(Level &level, std::size_t guard, const PhaseGroup &group,
                                const TabulatedExponential &table) {
  const auto j = static_cast<std::size_t>(group.first);
  const auto n = static_cast<std::size_t>(view_.n_padded);
  const auto n_groups = static_cast<std::size_t>(view_.n_groups);
  const std::size_t columns = n_groups + static_cast<std::size_t>(view_.n_pairs);
  const double re = rows_[guard * 8 * n + j];
  const double im = -rows_[(guard * 8 + 1) * n + j];
  double *real = level.table.data() + (guard * columns + j) * 8;
  for (std::size_t i = 0; i < 8; ++i)
    real[i] = re * table.real[i] - im * table.imaginary[i];
  double *imaginary = level.table.data() + (guard * columns + n_groups + j) * 8;
  if (group.kind == BlockKind::pair)
    for (std::size_t i = 0; i < 8; ++i)
      imaginary[i] = -(re * table.imaginary[i] + im * table.real[i]);
  for (std::size_t r = 0; r < 3; ++r) {
    const double whole = interpolation_error[r] * table.eighth;
    const double error = r == 0 ? std::min(whole, table.largest + 1) : whole;
    level.bounds[(guard * 3 + r) * n + j] =
        magnitudes_[guard * n + j] * error +
        sizes_[guard * n + j] * table_rounding * order_factors[r];
  }
}

// f = c exp(B h tau) x: the data of the interpolation are rows.
void ExactPhase::set_level_dense(Level &level, const PhaseGroup &group) {
  const auto size = static_cast<Index>(group.coordinates.size());
  const Matrix b = level.length * group.generator;
  std::array<Matrix, 8> data;
  data[0] = Matrix::Identity(size, size);
  data[1] = b;
  data[2] = 0.5 * b * b;
  for (std::size_t i = 0; i < 5; ++i)
    data[3 + i] = exponential(interpolation_nodes[i] * b);
  for (Matrix &part : data)
    if (!part.allFinite())
      part.setZero();
  Matrix growth = exponential(b.cwiseAbs());
  // Of lengths for which that overflows nothing is known.
  constexpr double no_bound = 1e100;
  growth = growth.allFinite() ? Matrix(growth.cwiseMin(no_bound))
                              : Matrix::Constant(size, size, no_bound);
  for (Index i = 0; i < size; ++i) {
    level.turn[static_cast<std::size_t>(group.first + i)] = 1;
    for (Index k = 0; k < size; ++k) {
      level.dense.push_back(data[7](i, k));
      level.dense_growth.push_back(growth(i, k));
    }
  }
  for (std::size_t g = 0; g < constants_.size(); ++g)
    set_dense_rows(level, g, group, data);
}

void ExactPhase::set_dense_rows(Level &level, std::size_t guard, const PhaseGroup &group,
                                const std::array<Matrix, 8> &data) {
  const auto size = static_cast<Index>(group.coordinates.size());
  const auto n = static_cast<std::size_t>(view_.n_padded);
  const auto first = static_cast<std::size_t>(group.first);
  const auto columns = static_cast<std::size_t>(view_.n_groups + view_.n_pairs);
  const Eigen::Map<const RowVector> row(rows_.data() + guard * 8 * n + first, size);
  double *table = level.table.data() + (guard * columns + first) * 8;
  for (std::size_t k = 0; k < 8; ++k) {
    const RowVector seen = row * data[k];
    for (Index c = 0; c < size; ++c)
      for (std::size_t i = 0; i < 8; ++i)
        table[8 * static_cast<std::size_t>(c) + i] += interpolation_matrix()[i][k] * seen[c];
  }
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < group.size(); ++c) {
      const std::size_t j = guard * n + first + c;
      const double error = interpolation_error[r] * std::pow(level.length, 8) * eighth_[j];
      level.bounds[(guard * 3 + r) * n + first + c] =
          std::min(error, 1e100) + sizes_[j] * table_rounding * order_factors[r];
    }
}

} // namespace vibroimpact::motion
