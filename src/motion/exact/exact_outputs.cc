#include "motion/exact/exact_outputs.h"

#include <cmath>
#include <limits>

namespace vibroimpact::motion {

ExactOutputs::ExactOutputs(const MonitoredForms &forms, const ExactPhase &phase)
    : forms_(forms), phase_(phase) {
  arrange();
}

void ExactOutputs::arrange() {
  arrangement_ = phase_.arrangement();
  const std::size_t count = forms_.ranges.size();
  const std::size_t blocks = (count + 7) / 8;
  const auto n = static_cast<std::size_t>(phase_.view().n_padded);
  constants_.assign(8 * blocks, 0);
  for (std::size_t f = 0; f < count; ++f)
    constants_[f] = forms_.differentiated[f] ? 0 : forms_.constants[f];
  rows_.assign(blocks * 6 * n * 8, 0);
  sixth_.assign(blocks * n * 8, 0);
  sizes_.assign(blocks * n * 8, 0);
  single_.assign(count * 8 * n, 0);
  minimum_.assign(8 * blocks, -std::numeric_limits<double>::infinity());
  maximum_.assign(8 * blocks, std::numeric_limits<double>::infinity());
  ends_.assign(blocks * 48, 0);
  for (std::size_t f = 0; f < count; ++f)
    for (const ExactPhase::Group &group : phase_.groups())
      set_coordinate(f, group);
  view_ = {.n_blocks = static_cast<int>(blocks),
           .constants = constants_.data(),
           .rows = rows_.data(),
           .sixth = sixth_.data(),
           .sizes = sizes_.data(),
           .single = single_.data(),
           .minimum = minimum_.data(),
           .maximum = maximum_.data(),
           .ends = ends_.data()};
}

void ExactOutputs::renew() {
  if (arrangement_ != phase_.arrangement()) {
    arrange();
    return;
  }
  for (std::size_t f = 0; f < forms_.ranges.size(); ++f)
    for (const ExactPhase::Group &group : phase_.groups())
      if (group.is_input)
        set_coordinate(f, group);
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

// A derivative sees the generator times what the form sees.
void ExactOutputs::set_coordinate(std::size_t f, const ExactPhase::Group &group) {
  const auto n = static_cast<std::size_t>(phase_.view().n_padded);
  const Matrix &columns = phase_.columns();
  const auto row = forms_.rows.row(static_cast<Index>(f));
  const bool differentiated = forms_.differentiated[f];
  const std::size_t bounds = f / 8 * n;
  const auto first = static_cast<std::size_t>(group.first);
  if (group.kind != BlockKind::dense) {
    Complex c = row.dot(columns.col(group.coordinates[0]));
    if (group.kind == BlockKind::pair)
      c.imag(-row.dot(columns.col(group.coordinates[1])));
    if (differentiated)
      c *= group.exponent;
    // Real exponentials are bounded by their ends, without the quintic.
    if (group.kind == BlockKind::pair)
      sixth_[8 * (bounds + first) + f % 8] = std::abs(c) * std::pow(std::abs(group.exponent), 6);
    sizes_[8 * (bounds + first) + f % 8] = std::abs(c);
    for (Index r = 0; r < 4; ++r, c *= group.exponent)
      store(f, first, r, c.real(), -c.imag());
    return;
  }
  RowVector seen(static_cast<Index>(group.coordinates.size()));
  for (std::size_t c = 0; c < group.coordinates.size(); ++c)
    seen[static_cast<Index>(c)] = row.dot(columns.col(group.coordinates[c]));
  if (differentiated)
    seen = seen * group.generator;
  for (Index r = 0; r <= 6; ++r, seen = seen * group.generator)
    for (std::size_t c = 0; c < group.coordinates.size(); ++c) {
      const double value = seen[static_cast<Index>(c)];
      if (r < 4)
        store(f, first + c, r, value, 0);
      if (r == 0)
        sizes_[8 * (bounds + first + c) + f % 8] = std::abs(value);
      if (r == 6)
        sixth_[8 * (bounds + first + c) + f % 8] = std::abs(value);
    }
}

OutputsView &ExactOutputs::begin() {
  for (std::size_t f = 0; f < forms_.ranges.size(); ++f) {
    minimum_[f] = forms_.ranges[f]->minimum;
    maximum_[f] = forms_.ranges[f]->maximum;
  }
  view_.continued = false;
  return view_;
}

void ExactOutputs::end() {
  for (std::size_t f = 0; f < forms_.ranges.size(); ++f) {
    forms_.ranges[f]->minimum = minimum_[f];
    forms_.ranges[f]->maximum = maximum_[f];
  }
}

} // namespace vibroimpact::motion
