#include "motion/phase/exact_change.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

ExactChange::ExactChange(const ExactPhase &from, const std::vector<PhaseForms::Reset> &resets,
                         const ExactPhase &to)
    : from_(from), to_(to), resets_(resets) {
  arrange();
}

void ExactChange::arrange() {
  const auto n = static_cast<std::size_t>(to_.view().n_padded);
  const auto count = static_cast<std::size_t>(from_.n_coordinates());
  columns_.assign(count * 2 * n, 0);
  magnitudes_.assign(count * n, 0);
  constant_.assign(2 * n, 0);
  constant_sizes_.assign(n, 0);
  state_.resize(to_.n_modes());
  set_constant();
  for (Index k = 0; k < from_.n_coordinates(); ++k)
    set_column(k);
  view_ = {.n_columns = static_cast<int>(count),
           .places = from_.places().data(),
           .n_padded = static_cast<int>(n),
           .constant = constant_.data(),
           .columns = columns_.data(),
           .magnitudes = magnitudes_.data(),
           .constant_sizes = constant_sizes_.data()};
  from_arrangement_ = from_.arrangement();
  to_arrangement_ = to_.arrangement();
  generation_ = from_.generation();
}

// What the resets add whatever the state is.
void ExactChange::set_constant() {
  const auto n = static_cast<std::size_t>(to_.view().n_padded);
  Vector constant = Vector::Zero(to_.n_modes());
  for (const PhaseForms::Reset &reset : resets_)
    constant[reset.entry] = reset.form.constant;
  for (Index i = 0; i < to_.n_modes(); ++i) {
    const auto place = static_cast<std::size_t>(to_.places()[static_cast<std::size_t>(i)]);
    constant_[place] = to_.modal().inverse().row(i).dot(constant);
    constant_sizes_[place % n] += to_.modal().inverse().row(i).cwiseAbs().dot(constant.cwiseAbs());
  }
}

void ExactChange::renew() {
  if (from_arrangement_ != from_.arrangement() || to_arrangement_ != to_.arrangement()) {
    arrange();
    return;
  }
  for (const PhaseGroup &group : from_.groups())
    if (group.is_input() && group.generation > generation_)
      for (const Index coordinate : group.coordinates)
        set_column(coordinate);
  generation_ = from_.generation();
}

// The state that belongs to one coordinate of the old phase, all resets seeing it before any of
// them; of an input less the response to it in the new phase.
void ExactChange::set_state(Index coordinate) {
  const Index modes = to_.n_modes();
  const auto before = from_.columns().col(coordinate);
  for (Index i = 0; i < modes; ++i)
    state_[i] = before[i];
  for (const PhaseForms::Reset &reset : resets_)
    state_[reset.entry] = reset.form.row.dot(before);
  if (coordinate < from_.n_modes())
    return;
  const auto response = to_.columns().col(coordinate - from_.n_modes() + modes);
  for (Index i = 0; i < modes; ++i)
    state_[i] -= response[i];
}

// Where one coordinate of the old phase leads to. An input goes on as itself, and the modes get the
// difference of its responses in the two phases. In extended precision, so that each entry is
// rounded once.
void ExactChange::set_column(Index coordinate) {
  const auto n = static_cast<std::size_t>(to_.view().n_padded);
  double *column = columns_.data() + static_cast<std::size_t>(coordinate) * 2 * n;
  double *sizes = magnitudes_.data() + static_cast<std::size_t>(coordinate) * n;
  std::fill(column, column + 2 * n, 0.0);
  std::fill(sizes, sizes + n, 0.0);
  const std::vector<int> &places = to_.places();
  const Index modes = to_.n_modes();
  set_state(coordinate);
  if (coordinate >= from_.n_modes())
    column[places[static_cast<std::size_t>(coordinate - from_.n_modes() + modes)]] = 1;
  const ModalForm::Long &inverse = to_.modal().long_inverse();
  for (Index i = 0; i < modes; ++i) {
    const auto place = static_cast<std::size_t>(places[static_cast<std::size_t>(i)]);
    column[place] += static_cast<double>(inverse.row(i).dot(state_));
    sizes[place % n] += std::abs(column[place]);
  }
}

} // namespace vibroimpact::motion
