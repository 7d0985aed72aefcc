// The tables of a phase for pieces of one length.
#include "motion/exact/exact_phase.h"
#include "motion/exact/interpolation.h"

#include <unsupported/Eigen/MatrixFunctions>

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

namespace {

// Of a sum of products, by |f - p| / tau^r: what rounding adds to the error of the interpolation.
constexpr double table_rounding = 128 * 0x1p-52;
constexpr std::array<double, 3> order_factors = {1, 7, 21};

void to_bernstein(const std::array<Complex, 8> &data, std::array<Complex, 8> &coefficients) {
  const InterpolationMatrix &matrix = interpolation_matrix();
  for (std::size_t i = 0; i < 8; ++i) {
    double real = 0;
    double imaginary = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      real += matrix[i][k] * data[k].real();
      imaginary += matrix[i][k] * data[k].imag();
    }
    coefficients[i] = {real, imaginary};
  }
}

// exp(z) without what the library does for infinities.
Complex exponential(Complex z) {
  const double size = std::exp(z.real());
  return z.imag() == 0 ? Complex(size) : std::polar(size, z.imag());
}

} // namespace

void ExactPhase::make_level(int index) {
  auto level = std::make_unique<Level>();
  const auto n = static_cast<std::size_t>(view_.n_padded);
  const auto guards = static_cast<std::size_t>(view_.n_guards);
  const auto columns = static_cast<std::size_t>(view_.n_groups + view_.n_pairs);
  const double h = h0_ * std::exp2(-0.5 * index);
  level->turn.assign(2 * n, 0);
  level->growth.assign(n, 1);
  level->table.assign(guards * columns * 8, 0);
  level->bounds.assign(guards * 3 * n, 0);
  for (const Group &group : groups_)
    set_level(*level, h, group);
  levels_[static_cast<std::size_t>(index)] = std::move(level);
  const Level &made = *levels_[static_cast<std::size_t>(index)];
  level_views_[static_cast<std::size_t>(index)] = {.length = h,
                                                   .turn = made.turn.data(),
                                                   .growth = made.growth.data(),
                                                   .dense_growth = made.dense_growth.data(),
                                                   .table = made.table.data(),
                                                   .bounds = made.bounds.data(),
                                                   .dense = made.dense.data()};
}

void ExactPhase::set_level(Level &level, double h, const Group &group) {
  if (group.kind == BlockKind::dense)
    set_level_dense(level, h, group);
  else
    set_level_pair(level, h, group);
}

void ExactPhase::set_level_pair(Level &level, double h, const Group &group) {
  const auto j = static_cast<std::size_t>(group.first);
  const auto n = static_cast<std::size_t>(view_.n_padded);
  const auto n_groups = static_cast<std::size_t>(view_.n_groups);
  const std::size_t columns = n_groups + static_cast<std::size_t>(view_.n_pairs);
  const Complex z = group.exponent * h;
  std::array<Complex, 8> data = {1.0, z, 0.5 * z * z};
  for (std::size_t i = 0; i < 5; ++i)
    data[3 + i] = exponential(z * interpolation_nodes[i]);
  std::array<Complex, 8> beta;
  to_bernstein(data, beta);
  level.turn[j] = data[7].real();
  level.turn[n + j] = data[7].imag();
  level.growth[j] = std::max(1.0, std::exp(std::min(z.real(), 600.0)));
  double largest = 0;
  for (const Complex &b : beta)
    largest = std::max(largest, std::abs(b));
  const double size8 = std::pow(std::abs(z), 8);
  for (std::size_t g = 0; g < constants_.size(); ++g) {
    const Complex c(rows_[g * 8 * n + j], -rows_[(g * 8 + 1) * n + j]);
    double *real = level.table.data() + (g * columns + j) * 8;
    double *imaginary = level.table.data() + (g * columns + n_groups + j) * 8;
    for (std::size_t i = 0; i < 8; ++i) {
      const Complex product = c * beta[i];
      real[i] = product.real();
      if (group.kind == BlockKind::pair)
        imaginary[i] = -product.imag();
    }
    for (std::size_t r = 0; r < 3; ++r) {
      double error = interpolation_error[r] * size8;
      if (r == 0)
        error = std::min(error, largest + 1);
      level.bounds[(g * 3 + r) * n + j] =
          magnitudes_[g * n + j] * error + sizes_[g * n + j] * table_rounding * order_factors[r];
    }
  }
}

// f = c exp(B h tau) x: the data of the interpolation are rows.
void ExactPhase::set_level_dense(Level &level, double h, const Group &group) {
  const auto size = static_cast<Index>(group.coordinates.size());
  const auto n = static_cast<std::size_t>(view_.n_padded);
  const std::size_t columns = static_cast<std::size_t>(view_.n_groups + view_.n_pairs);
  const auto first = static_cast<std::size_t>(group.first);
  const Matrix b = h * group.generator;
  std::array<Matrix, 8> data;
  data[0] = Matrix::Identity(size, size);
  data[1] = b;
  data[2] = 0.5 * b * b;
  for (std::size_t i = 0; i < 5; ++i)
    data[3 + i] = (interpolation_nodes[i] * b).eval().exp();
  const Matrix growth = b.cwiseAbs().eval().exp();
  for (Index i = 0; i < size; ++i) {
    level.turn[first + static_cast<std::size_t>(i)] = 1;
    for (Index k = 0; k < size; ++k) {
      level.dense.push_back(data[7](i, k));
      level.dense_growth.push_back(std::min(growth(i, k), 1e100));
    }
  }
  const InterpolationMatrix &matrix = interpolation_matrix();
  for (std::size_t g = 0; g < constants_.size(); ++g) {
    RowVector row(size);
    for (Index c = 0; c < size; ++c)
      row[c] = rows_[g * 8 * n + first + static_cast<std::size_t>(c)];
    for (std::size_t k = 0; k < 8; ++k) {
      const RowVector seen = row * data[k];
      for (Index c = 0; c < size; ++c) {
        double *table =
            level.table.data() + (g * columns + first + static_cast<std::size_t>(c)) * 8;
        for (std::size_t i = 0; i < 8; ++i)
          table[i] = (k == 0 ? 0 : table[i]) + matrix[i][k] * seen[c];
      }
    }
    for (std::size_t r = 0; r < 3; ++r)
      for (Index c = 0; c < size; ++c) {
        const std::size_t j = g * n + first + static_cast<std::size_t>(c);
        const double error = interpolation_error[r] * std::pow(h, 8) * eighth_[j];
        level.bounds[(g * 3 + r) * n + first + static_cast<std::size_t>(c)] =
            std::min(error, 1e100) + sizes_[j] * table_rounding * order_factors[r];
      }
  }
}

} // namespace vibroimpact::motion
