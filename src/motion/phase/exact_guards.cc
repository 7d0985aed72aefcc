// What the kernel needs of the guards of a phase, group by group.
#include "motion/kernel/interpolation.h"
#include "motion/phase/exact_phase.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

void ExactPhase::set_group(PhaseGroup &group) {
  group.generation = generation_;
  if (group.kind == BlockKind::dense)
    set_dense(group);
  else
    set_pair(group);
}

// What a guard sees of a pair, or of a real group as one without imaginary part: Re(c a) with c =
// row (column_re - i column_im). `size`: what that was summed up from.
Complex ExactPhase::seen_by_guard(std::size_t guard, const PhaseGroup &group, double &size) const {
  double seen[2] = {0, 0};
  double sizes[2] = {0, 0};
  for (std::size_t c = 0; c < group.coordinates.size(); ++c)
    for (Index i = 0; i < n_rows_; ++i) {
      const double part =
          guard_rows_(static_cast<Index>(guard), i) * columns_(i, group.coordinates[c]);
      seen[c] += part;
      sizes[c] += std::abs(part);
    }
  size = std::max(sizes[0], sizes[1]);
  return {seen[0], -seen[1]};
}

void ExactPhase::set_pair(const PhaseGroup &group) {
  const auto j = static_cast<std::size_t>(group.first);
  rate_[j] = group.exponent.real();
  frequency_[j] = group.exponent.imag();
  for (std::size_t g = 0; g < constants_.size(); ++g)
    set_pair_rows(g, group);
}

// Value and derivatives of a guard, and bounds of these.
void ExactPhase::set_pair_rows(std::size_t guard, const PhaseGroup &group) {
  const auto n = static_cast<std::size_t>(view_.n_padded);
  const std::size_t j = guard * n + static_cast<std::size_t>(group.first);
  Complex c = seen_by_guard(guard, group, sizes_[j]);
  const double m = std::sqrt(std::norm(c));
  const double squared = std::norm(group.exponent);
  magnitudes_[j] = m;
  slopes_[j] = m * std::sqrt(squared);
  second_[j] = m * squared;
  third_[j] = m * squared * std::sqrt(squared);
  eighth_[j] = m * squared * squared * squared * squared;
  double *row = rows_.data() + guard * 8 * n + static_cast<std::size_t>(group.first);
  for (std::size_t r = 0; r < 4; ++r, c *= group.exponent) {
    row[2 * r * n] = c.real();
    row[(2 * r + 1) * n] = -c.imag();
  }
}

void ExactPhase::set_dense(const PhaseGroup &group) {
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
        if (r == 1)
          slopes_[at * n + j] = std::abs(value);
        if (r == 2)
          second_[at * n + j] = std::abs(value);
        if (r == 3)
          third_[at * n + j] = std::abs(value);
        if (r == 8)
          eighth_[at * n + j] = std::abs(value);
      }
  }
}

// The largest mode of each guard, the unit of its size; of the inputs where it sees no mode.
void ExactPhase::set_norms() {
  const auto n = static_cast<std::size_t>(view_.n_padded);
  norms_.assign(constants_.size(), 0);
  for (const bool inputs : {false, true})
    for (std::size_t g = 0; g < norms_.size(); ++g) {
      double norm = 0;
      for (const PhaseGroup &group : groups_)
        for (std::size_t c = 0; c < group.size() && group.is_input() == inputs; ++c)
          norm = std::max(norm, magnitudes_[g * n + static_cast<std::size_t>(group.first) + c]);
      norms_[g] = norms_[g] > 0 ? norms_[g] : norm;
    }
}

// Sizes of the guards in units of their norms, so that one error serves all of them.
void ExactPhase::set_weights() {
  set_norms();
  const auto n = static_cast<std::size_t>(view_.n_padded);
  std::fill(weights_.begin(), weights_.end(), 0.0);
  view_.constant_weight = 0;
  const double h2 = h0_ * h0_;
  const double h8 = interpolation_error[0] * h2 * h2 * h2 * h2;
  for (std::size_t g = 0; g < constants_.size(); ++g) {
    if (!(norms_[g] > 0))
      continue;
    const double unit = 1 / norms_[g];
    view_.constant_weight = std::max(view_.constant_weight, std::abs(constants_[g]) * unit);
    for (std::size_t j = 0; j < n; ++j) {
      weights_[j] = std::max(weights_[j], magnitudes_[g * n + j] * unit);
      weights_[n + j] = std::max(weights_[n + j], eighth_[g * n + j] * h8 * unit);
    }
  }
  double fastest = 0;
  for (const PhaseGroup &group : groups_)
    fastest = std::max(fastest, std::norm(group.exponent));
  view_.fastest = std::max(fastest_dense_, std::sqrt(fastest));
}

} // namespace vibroimpact::motion
