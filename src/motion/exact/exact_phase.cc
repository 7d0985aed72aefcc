#include "motion/exact/exact_phase.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace vibroimpact::motion {

namespace {

Matrix input_generator(const Input &input) {
  if (input.kind == Input::Kind::exponential)
    return input.is_pair() ? pair_generator(input.exponent)
                           : Matrix::Constant(1, 1, input.exponent.real());
  Matrix shift = Matrix::Zero(input.size(), input.size());
  shift.diagonal(1).setOnes();
  return shift;
}

int padded(std::size_t count) {
  const auto blocks = (static_cast<int>(count) + group_block - 1) / group_block;
  return group_block * std::max(blocks, 1);
}

} // namespace

ExactPhase::ExactPhase(const Matrix &matrix, const Vector &constant,
                       const std::vector<LinearSystem::Load> &loads, const GuardForms &guards,
                       double h0)
    : modal_(matrix), h0_(h0), guard_rows_(guards.rows), guard_constants_(guards.constants),
      n_rows_(guards.rows.cols()) {
  for (const LinearSystem::Load &load : loads)
    modal_loads_.push_back({modal_.inverse() * load.value, modal_.inverse() * load.rate,
                            modal_.inverse() * load.acceleration});
  modal_constant_ = modal_.inverse() * constant;
  for (const ModalBlock &block : modal_.blocks())
    radius_ = std::max(radius_, block.matrix().eigenvalues().cwiseAbs().maxCoeff());
  view_.make_level = [](void *owner, int level) {
    static_cast<ExactPhase *>(owner)->make_level(level);
  };
  view_.owner = this;
  levels_.resize(n_levels);
  level_views_.resize(n_levels);
  forget();
}

void ExactPhase::forget() { hints_.fill(-1); }

void ExactPhase::take(const Excitation &excitation) {
  if (generation_ == excitation.generation())
    return;
  generation_ = excitation.generation();
  if (structure_ == excitation.structure() && !coupled_)
    renew(excitation);
  else
    arrange(excitation);
  structure_ = excitation.structure();
}

void ExactPhase::arrange(const Excitation &excitation) {
  inputs_ = excitation.inputs();
  const Index n = n_modes();
  columns_ = Matrix::Zero(n_rows_, n + excitation.size());
  columns_.topLeftCorner(n, n) = modal_.basis();
  couples_ = Matrix::Zero(n, excitation.size());
  couplings_.clear();
  respond(excitation, true);
  coupled_ = !couplings_.empty();
  place_groups();
  allocate();
  for (const Group &group : groups_)
    set_group(group);
  set_weights();
  for (int k = 0; k < n_levels; ++k) {
    levels_[static_cast<std::size_t>(k)].reset();
    level_views_[static_cast<std::size_t>(k)] = {};
  }
  forget();
  ++arrangement_;
}

// Of the same structure under other exponents.
void ExactPhase::renew(const Excitation &excitation) {
  if (!respond(excitation, false)) {
    arrange(excitation);
    return;
  }
  inputs_ = excitation.inputs();
  for (Group &group : groups_)
    if (group.is_input) {
      Index coordinate = group.coordinates.front() - n_modes();
      for (const Input &input : inputs_) {
        if (coordinate == 0)
          group.exponent = input.exponent;
        coordinate -= input.size();
      }
      set_group(group);
    }
  set_weights();
  for (int k = 0; k < n_levels; ++k)
    if (const std::unique_ptr<Level> &level = levels_[static_cast<std::size_t>(k)])
      for (const Group &group : groups_)
        if (group.is_input)
          set_level(*level, level_views_[static_cast<std::size_t>(k)].length, group);
}

// Blocks of modes and inputs, those that are coupled as one dense block: pairs first, those of the
// modes before those of the inputs.
void ExactPhase::place_groups() {
  const std::size_t n_blocks = modal_.blocks().size();
  std::vector<std::size_t> root(n_blocks + inputs_.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i)
      i = root[i];
    return i;
  };
  for (const auto &[block, input] : couplings_)
    root[find(n_blocks + static_cast<std::size_t>(input))] = find(static_cast<std::size_t>(block));
  struct Part {
    Index first, size;
    Matrix generator;
  };
  std::vector<Part> parts;
  for (const ModalBlock &block : modal_.blocks())
    parts.push_back({block.column, block.size, block.matrix()});
  Index first = n_modes();
  for (const Input &input : inputs_) {
    parts.push_back({first, input.size(), input_generator(input)});
    first += input.size();
  }
  groups_.clear();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (find(i) != i)
      continue;
    Group group;
    std::vector<std::size_t> members;
    for (std::size_t m = 0; m < parts.size(); ++m)
      if (find(m) == i)
        members.push_back(m);
    for (const std::size_t m : members)
      for (Index c = 0; c < parts[m].size; ++c)
        group.coordinates.push_back(parts[m].first + c);
    const auto size = static_cast<Index>(group.coordinates.size());
    group.is_input = members.size() == 1 && i >= n_blocks;
    group.generator = Matrix::Zero(size, size);
    Index place = 0;
    for (const std::size_t m : members) {
      group.generator.block(place, place, parts[m].size, parts[m].size) = parts[m].generator;
      place += parts[m].size;
    }
    for (Index a = 0; a < size && members.size() > 1; ++a)
      for (Index b = 0; b < size; ++b)
        if (group.coordinates[static_cast<std::size_t>(a)] < n_modes() &&
            group.coordinates[static_cast<std::size_t>(b)] >= n_modes())
          group.generator(a, b) =
              couples_(group.coordinates[static_cast<std::size_t>(a)],
                       group.coordinates[static_cast<std::size_t>(b)] - n_modes());
    const bool single = members.size() == 1;
    const bool is_block = i < n_blocks;
    if (single && size == 2 &&
        (is_block ? modal_.blocks()[i].kind == BlockKind::pair
                  : inputs_[i - n_blocks].kind == Input::Kind::exponential)) {
      group.kind = BlockKind::pair;
      group.exponent = {group.generator(0, 0), group.generator(1, 0)};
    } else if (size == 1) {
      group.kind = BlockKind::real;
      group.exponent = group.generator(0, 0);
    } else {
      group.kind = BlockKind::dense;
    }
    groups_.push_back(std::move(group));
  }
  std::stable_sort(groups_.begin(), groups_.end(), [](const Group &a, const Group &b) {
    const auto rank = [](const Group &g) {
      return g.kind == BlockKind::pair ? 0 : g.kind == BlockKind::real ? 1 : 2;
    };
    return std::pair(rank(a), a.is_input) < std::pair(rank(b), b.is_input);
  });
}

void ExactPhase::allocate() {
  std::size_t count = 0;
  std::size_t pairs = 0;
  for (Group &group : groups_) {
    group.first = static_cast<int>(count);
    count += group.kind == BlockKind::dense ? group.coordinates.size() : 1;
    pairs += group.kind == BlockKind::pair ? 1 : 0;
  }
  view_.n_groups = static_cast<int>(count);
  view_.n_padded = padded(count);
  view_.n_pairs = static_cast<int>(pairs);
  view_.n_guards = static_cast<int>(guard_constants_.size());
  const auto n = static_cast<std::size_t>(view_.n_padded);
  const auto guards = static_cast<std::size_t>(view_.n_guards);
  rate_.assign(n, 0);
  frequency_.assign(n, 0);
  rows_.assign(guards * 8 * n, 0);
  for (AlignedArray *list : {&sizes_, &second_, &third_, &eighth_, &magnitudes_})
    list->assign(guards * n, 0);
  weights_.assign(2 * n, 0);
  constants_.assign(guard_constants_.begin(), guard_constants_.end());
  constant_sizes_.resize(guards);
  for (std::size_t g = 0; g < guards; ++g)
    constant_sizes_[g] = std::abs(constants_[g]);
  dense_.clear();
  generators_.clear();
  places_.assign(static_cast<std::size_t>(n_coordinates()), 0);
  for (const Group &group : groups_)
    for (std::size_t c = 0; c < group.coordinates.size(); ++c)
      places_[static_cast<std::size_t>(group.coordinates[c])] =
          group.kind == BlockKind::pair ? group.first + static_cast<int>(c) * view_.n_padded
                                        : group.first + static_cast<int>(c);
  for (const Group &group : groups_)
    if (group.kind == BlockKind::dense) {
      const Matrix transposed = group.generator.transpose();
      generators_.emplace_back(transposed.data(), transposed.data() + transposed.size());
      dense_.push_back({group.first, static_cast<int>(group.coordinates.size()), nullptr});
    }
  for (std::size_t d = 0; d < dense_.size(); ++d)
    dense_[d].generator = generators_[d].data();
  view_.n_dense = static_cast<int>(dense_.size());
  view_.dense = dense_.data();
  view_.rate = rate_.data();
  view_.frequency = frequency_.data();
  view_.rows = rows_.data();
  view_.sizes = sizes_.data();
  view_.second = second_.data();
  view_.third = third_.data();
  view_.constants = constants_.data();
  view_.constant_sizes = constant_sizes_.data();
  view_.weights = weights_.data();
  view_.levels = level_views_.data();
  view_.hints = hints_.data();
}

void ExactPhase::set_group(const Group &group) {
  if (group.kind == BlockKind::dense)
    set_dense(group);
  else
    set_pair(group);
}

// A pair, or a real group as one without imaginary part: c = row (column_re - i column_im).
void ExactPhase::set_pair(const Group &group) {
  const auto j = static_cast<std::size_t>(group.first);
  const auto n = static_cast<std::size_t>(view_.n_padded);
  rate_[j] = group.exponent.real();
  frequency_[j] = group.exponent.imag();
  const double size = std::abs(group.exponent);
  const bool pair = group.kind == BlockKind::pair;
  for (Index g = 0; g < guard_rows_.rows(); ++g) {
    double real = 0;
    double imaginary = 0;
    double of_real = 0;
    double of_imaginary = 0;
    for (Index i = 0; i < n_rows_; ++i) {
      const double row = guard_rows_(g, i);
      const double re = row * columns_(i, group.coordinates[0]);
      real += re;
      of_real += std::abs(re);
      if (pair) {
        const double im = row * columns_(i, group.coordinates[1]);
        imaginary += im;
        of_imaginary += std::abs(im);
      }
    }
    const auto at = static_cast<std::size_t>(g);
    Complex c(real, -imaginary);
    magnitudes_[at * n + j] = std::abs(c);
    sizes_[at * n + j] = std::max(of_real, of_imaginary);
    const double m = magnitudes_[at * n + j];
    second_[at * n + j] = m * size * size;
    third_[at * n + j] = m * size * size * size;
    eighth_[at * n + j] = m * std::pow(size, 8);
    for (std::size_t r = 0; r < 4; ++r, c *= group.exponent) {
      rows_[(at * 8 + 2 * r) * n + j] = c.real();
      rows_[(at * 8 + 2 * r + 1) * n + j] = -c.imag();
    }
  }
}

void ExactPhase::set_dense(const Group &group) {
  const auto n = static_cast<std::size_t>(view_.n_padded);
  for (Index g = 0; g < guard_rows_.rows(); ++g) {
    const auto at = static_cast<std::size_t>(g);
    RowVector row(static_cast<Index>(group.coordinates.size()));
    for (std::size_t c = 0; c < group.coordinates.size(); ++c) {
      const Vector column = columns_.col(group.coordinates[c]);
      row[static_cast<Index>(c)] = guard_rows_.row(g).dot(column);
      sizes_[at * n + static_cast<std::size_t>(group.first) + c] =
          guard_rows_.row(g).cwiseAbs().dot(column.cwiseAbs());
    }
    for (int r = 0; r <= 8; ++r, row = row * group.generator)
      for (std::size_t c = 0; c < group.coordinates.size(); ++c) {
        const std::size_t j = static_cast<std::size_t>(group.first) + c;
        const double value = row[static_cast<Index>(c)];
        if (r < 4)
          rows_[(at * 8 + 2 * static_cast<std::size_t>(r)) * n + j] = value;
        if (r == 0)
          magnitudes_[at * n + j] = std::abs(value);
        if (r == 2)
          second_[at * n + j] = std::abs(value);
        if (r == 3)
          third_[at * n + j] = std::abs(value);
        if (r == 8)
          eighth_[at * n + j] = std::abs(value);
      }
  }
}

// Sizes of the guards in units of their largest mode, so that one error serves all of them.
void ExactPhase::set_weights() {
  const auto n = static_cast<std::size_t>(view_.n_padded);
  std::fill(weights_.begin(), weights_.end(), 0.0);
  view_.constant_weight = 0;
  const double h8 = interpolation_error[0] * std::pow(h0_, 8);
  for (std::size_t g = 0; g < constants_.size(); ++g) {
    double of_modes = 0;
    double of_all = 0;
    for (const Group &group : groups_)
      for (std::size_t c = 0; c < (group.kind == BlockKind::dense ? group.coordinates.size() : 1);
           ++c) {
        const double m = magnitudes_[g * n + static_cast<std::size_t>(group.first) + c];
        of_all = std::max(of_all, m);
        if (!group.is_input)
          of_modes = std::max(of_modes, m);
      }
    const double norm = of_modes > 0 ? of_modes : of_all;
    if (!(norm > 0))
      continue;
    view_.constant_weight = std::max(view_.constant_weight, std::abs(constants_[g]) / norm);
    for (std::size_t j = 0; j < n; ++j) {
      weights_[j] = std::max(weights_[j], magnitudes_[g * n + j] / norm);
      weights_[n + j] = std::max(weights_[n + j], eighth_[g * n + j] * h8 / norm);
    }
  }
  view_.fastest = 0;
  for (const Group &group : groups_)
    view_.fastest =
        std::max(view_.fastest, group.kind == BlockKind::dense
                                    ? group.generator.eigenvalues().cwiseAbs().maxCoeff()
                                    : std::abs(group.exponent));
}

void ExactPhase::amplitudes(const Vector &y, const double *inputs, Amplitudes &amplitudes) const {
  using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  const Index n = n_modes();
  amplitudes.assign(n_amplitudes(), 0.0);
  LongVector rest = y.cast<long double>();
  for (Index k = n; k < n_coordinates(); ++k) {
    const long double input = inputs[k - n];
    rest -= input * columns_.col(k).head(n).cast<long double>();
    amplitudes[static_cast<std::size_t>(places_[static_cast<std::size_t>(k)])] = inputs[k - n];
  }
  const LongVector modes = modal_.long_inverse() * rest;
  for (Index i = 0; i < n; ++i)
    amplitudes[static_cast<std::size_t>(places_[static_cast<std::size_t>(i)])] =
        static_cast<double>(modes[i]);
}

void ExactPhase::rows(const double *amplitudes, Vector &rows) const {
  rows.setZero(n_rows_);
  for (Index k = 0; k < n_coordinates(); ++k)
    rows += amplitudes[places_[static_cast<std::size_t>(k)]] * columns_.col(k);
}

} // namespace vibroimpact::motion
