#include "motion/phase/amplitude_forms.h"

#include "common/memory.h"

#include <cmath>
#include <utility>

namespace vibroimpact::motion {

namespace {

// The kernel gives 8 eps times the sizes of the terms.
constexpr double kernel_roundings = guard_rounding / (8 * 0x1p-52);

std::size_t whole_blocks(std::size_t count) {
  return (count + group_block - 1) / group_block * group_block;
}

} // namespace

AmplitudeForms::AmplitudeForms(const ExactPhase &phase, std::vector<LinearRow> forms)
    : phase_(phase), forms_(std::move(forms)) {
  const std::size_t n = whole_blocks(forms_.size());
  constants_.assign(2 * n, 0);
  constant_sizes_.assign(n, 0);
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    constants_[i] = forms_[i].constant;
    constant_sizes_[i] = std::abs(forms_[i].constant);
  }
  values_.assign(2 * n, 0);
  hidden_.assign(n, 0);
  arrange();
}

std::size_t AmplitudeForms::bytes() const { return bytes_of(columns_, magnitudes_); }

void AmplitudeForms::arrange() {
  const std::size_t n = hidden_.size();
  const auto count = static_cast<std::size_t>(phase_.n_coordinates());
  columns_.assign(count * 2 * n, 0);
  magnitudes_.assign(count * n, 0);
  for (Index k = 0; k < phase_.n_coordinates(); ++k)
    set_column(k);
  view_ = {.n_columns = static_cast<int>(count),
           .places = phase_.places().data(),
           .n_padded = static_cast<int>(n),
           .constant = constants_.data(),
           .columns = columns_.data(),
           .magnitudes = magnitudes_.data(),
           .constant_sizes = constant_sizes_.data()};
  arrangement_ = phase_.arrangement();
  generation_ = phase_.generation();
}

void AmplitudeForms::set_column(Index coordinate) {
  const std::size_t n = hidden_.size();
  const auto k = static_cast<std::size_t>(coordinate);
  const auto rows = phase_.columns().col(coordinate);
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    columns_[k * 2 * n + i] = forms_[i].row.dot(rows);
    magnitudes_[k * n + i] = forms_[i].row.cwiseAbs().dot(rows.cwiseAbs());
  }
}

void AmplitudeForms::renew() {
  if (arrangement_ != phase_.arrangement()) {
    arrange();
    return;
  }
  for (const PhaseGroup &group : phase_.groups())
    if (group.is_input() && group.generation > generation_)
      for (const Index coordinate : group.coordinates)
        set_column(coordinate);
  generation_ = phase_.generation();
}

void AmplitudeForms::evaluate(const double *amplitudes, const double *rounding) {
  const std::size_t n = hidden_.size();
  const auto groups = static_cast<std::size_t>(phase_.view().n_padded);
  kernel().change(view_, amplitudes, values_.data(), hidden_.data());
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    double noise = 0;
    for (std::size_t k = 0; k < phase_.places().size(); ++k)
      noise +=
          magnitudes_[k * n + i] * rounding[static_cast<std::size_t>(phase_.places()[k]) % groups];
    hidden_[i] = kernel_roundings * hidden_[i] + noise;
  }
}

} // namespace vibroimpact::motion
