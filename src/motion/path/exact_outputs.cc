#include "motion/path/exact_outputs.h"

#include "common/scalar.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vibroimpact::motion {

namespace {

// factor for which row = factor * other, entry by entry but for rounding; 0 when there is none.
double proportion(const RowVector &row, const RowVector &other) {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  Index largest = 0;
  if (!(other.cwiseAbs().maxCoeff(&largest) > 0))
    return 0;
  const double factor = row[largest] / other[largest];
  return ((row - factor * other).array().abs() <= rounding * row.array().abs()).all() ? factor : 0;
}

} // namespace

ExactOutputs::ExactOutputs(const LinearOutputs &forms, const ExactPhase &phase)
    : forms_(forms), phase_(phase) {
  for (std::size_t form = 0; form < forms.ranges.size(); ++form)
    share_output(form);
  arrange();
}

// With an output so far that is parallel to it, or one of its own.
void ExactOutputs::share_output(std::size_t form) {
  const auto row = [&](std::size_t of) { return forms_.rows.row(static_cast<Index>(of)); };
  const auto constant = [&](std::size_t of) {
    return forms_.differentiated[of] ? 0 : forms_.constants[of];
  };
  Share share{.range = forms_.ranges[form], .output = leaders_.size()};
  for (std::size_t k = 0; k < leaders_.size() && share.output == leaders_.size(); ++k) {
    const std::size_t leader = leaders_[k];
    const double factor = forms_.differentiated[form] == forms_.differentiated[leader]
                              ? proportion(row(form), row(leader))
                              : 0;
    if (factor != 0)
      share = {.range = share.range,
               .output = k,
               .factor = factor,
               .inverse = 1 / factor,
               .shift = constant(form) - factor * constant(leader)};
  }
  if (share.output == leaders_.size())
    leaders_.push_back(form);
  shares_.push_back(share);
}

void ExactOutputs::arrange() {
  arrangement_ = phase_.arrangement();
  generation_ = phase_.generation();
  const std::size_t count = leaders_.size();
  const std::size_t blocks = (count + 7) / 8;
  const auto n = static_cast<std::size_t>(phase_.view().n_padded);
  const std::size_t middles = static_cast<std::size_t>(most_halvings) * 2 * n;
  storage_.assign(blocks * (24 + 64 * n) + 8 * count * n + middles + 3 * n, 0);
  double *free = storage_.data();
  const auto take = [&](std::size_t size) { return std::exchange(free, free + size); };
  constants_ = take(8 * blocks);
  minimum_ = take(8 * blocks);
  maximum_ = take(8 * blocks);
  rows_ = take(48 * blocks * n);
  sixth_ = take(8 * blocks * n);
  sizes_ = take(8 * blocks * n);
  single_ = take(8 * count * n);
  for (std::size_t f = 0; f < count; ++f)
    constants_[f] = forms_.differentiated[leaders_[f]] ? 0 : forms_.constants[leaders_[f]];
  std::fill_n(minimum_, 8 * blocks, -infinity);
  std::fill_n(maximum_, 8 * blocks, infinity);
  dense_magnitudes_.clear();
  for (const PhaseGroup &group : phase_.groups()) {
    set_group(group);
    for (Index i = 0; group.kind == BlockKind::dense && i < group.generator.rows(); ++i)
      for (const double entry : group.generator.row(i))
        dense_magnitudes_.push_back(std::abs(entry));
  }
  view_ = {.n_blocks = static_cast<int>(blocks),
           .constants = constants_,
           .rows = rows_,
           .sixth = sixth_,
           .sizes = sizes_,
           .single = single_,
           .dense_magnitudes = dense_magnitudes_.data(),
           .minimum = minimum_,
           .maximum = maximum_,
           .middles = take(middles),
           .turned = take(2 * n),
           .reach = take(n)};
}

void ExactOutputs::renew() {
  if (arrangement_ != phase_.arrangement()) {
    arrange();
    return;
  }
  for (const PhaseGroup &group : phase_.groups())
    if (group.generation > generation_)
      set_group(group);
  generation_ = phase_.generation();
}

void ExactOutputs::store(std::size_t f, std::size_t j, Index order, double real, double imaginary) {
  const auto n = static_cast<std::size_t>(phase_.view().n_padded);
  const auto r = static_cast<std::size_t>(order);
  single_[(f * 8 + 2 * r) * n + j] = real;
  single_[(f * 8 + 2 * r + 1) * n + j] = imaginary;
  if (r == 3)
    return;
  const std::size_t block = f / 8 * 6 * n;
  rows_[8 * (block + 2 * r * n + j) + f % 8] = real;
  rows_[8 * (block + (2 * r + 1) * n + j) + f % 8] = imaginary;
}

void ExactOutputs::set_group(const PhaseGroup &group) {
  for (std::size_t f = 0; f < leaders_.size(); ++f)
    if (group.kind == BlockKind::dense)
      set_dense(f, group);
    else
      set_pair(f, group);
}

double ExactOutputs::seen(std::size_t f, Index coordinate) const {
  return forms_.rows.row(static_cast<Index>(leaders_[f])).dot(phase_.columns().col(coordinate));
}

// A derivative sees the exponent times what the form sees.
void ExactOutputs::set_pair(std::size_t f, const PhaseGroup &group) {
  const bool is_pair = group.kind == BlockKind::pair;
  Complex c(seen(f, group.coordinates[0]), is_pair ? -seen(f, group.coordinates[1]) : 0);
  if (forms_.differentiated[leaders_[f]])
    c *= group.exponent;
  const auto first = static_cast<std::size_t>(group.first);
  const std::size_t place =
      8 * (f / 8 * static_cast<std::size_t>(phase_.view().n_padded) + first) + f % 8;
  const double size = std::sqrt(std::norm(c));
  const double squared = std::norm(group.exponent);
  sizes_[place] = size;
  sixth_[place] = size * squared * squared * squared;
  for (Index r = 0; r < 4; ++r, c *= group.exponent)
    store(f, first, r, c.real(), -c.imag());
}

// A derivative sees the generator times what the form sees.
void ExactOutputs::set_dense(std::size_t f, const PhaseGroup &group) {
  const auto first = static_cast<std::size_t>(group.first);
  const std::size_t place =
      8 * (f / 8 * static_cast<std::size_t>(phase_.view().n_padded) + first) + f % 8;
  RowVector row(static_cast<Index>(group.coordinates.size()));
  for (std::size_t c = 0; c < group.coordinates.size(); ++c)
    row[static_cast<Index>(c)] = seen(f, group.coordinates[c]);
  if (forms_.differentiated[leaders_[f]])
    row = row * group.generator;
  for (Index r = 0; r <= 6; ++r, row = row * group.generator)
    for (std::size_t c = 0; c < group.coordinates.size(); ++c) {
      const double value = row[static_cast<Index>(c)];
      if (r < 4)
        store(f, first + c, r, value, 0);
      if (r == 0)
        sizes_[place + 8 * c] = std::abs(value);
      if (r == 6)
        sixth_[place + 8 * c] = std::abs(value);
    }
}

// Of an output that several ranges share, the search must find what exceeds any of them.
void ExactOutputs::begin() {
  std::fill_n(minimum_, leaders_.size(), -infinity);
  std::fill_n(maximum_, leaders_.size(), infinity);
  for (const Share &share : shares_) {
    const double low = (share.range->minimum - share.shift) * share.inverse;
    const double high = (share.range->maximum - share.shift) * share.inverse;
    double &minimum = minimum_[share.output];
    double &maximum = maximum_[share.output];
    minimum = std::max(minimum, share.factor > 0 ? low : high);
    maximum = std::min(maximum, share.factor > 0 ? high : low);
  }
}

void ExactOutputs::include(const double *from, const double *to, double length) {
  begin();
  kernel().include_part(phase_.view(), view_, from, to, length);
  end();
}

void ExactOutputs::end() {
  for (const Share &share : shares_) {
    const double of_minimum = share.factor * minimum_[share.output] + share.shift;
    const double of_maximum = share.factor * maximum_[share.output] + share.shift;
    ValueRange &range = *share.range;
    range.minimum = std::min(range.minimum, share.factor > 0 ? of_minimum : of_maximum);
    range.maximum = std::max(range.maximum, share.factor > 0 ? of_maximum : of_minimum);
  }
}

} // namespace vibroimpact::motion
