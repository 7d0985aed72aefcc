#include "motion/exact/exact_change.h"

#include <cmath>

namespace vibroimpact::motion {

ExactChange::ExactChange(const ExactPhase &from, const std::vector<PhaseForms::Reset> &resets,
                         const ExactPhase &to)
    : from_(from), to_(to), resets_(resets) {
  arrange();
}

// Of the rows [y, sources]; all resets see the state before any of them. The constants of the
// resets are left out.
Vector ExactChange::after_resets(const Vector &before) const {
  Vector after = before.head(to_.n_modes());
  for (const PhaseForms::Reset &reset : resets_)
    after[reset.entry] = reset.form.row.dot(before);
  return after;
}

void ExactChange::arrange() {
  const auto n = static_cast<std::size_t>(to_.view().n_padded);
  const auto count = static_cast<std::size_t>(from_.n_coordinates());
  columns_.assign(count * 2 * n, 0);
  magnitudes_.assign(count * n, 0);
  constant_.assign(2 * n, 0);
  constant_sizes_.assign(n, 0);
  const Index modes = to_.n_modes();
  Vector constant = Vector::Zero(modes);
  for (const PhaseForms::Reset &reset : resets_)
    constant[reset.entry] = reset.form.constant;
  for (Index i = 0; i < modes; ++i) {
    const auto place = static_cast<std::size_t>(to_.places()[static_cast<std::size_t>(i)]);
    constant_[place] = to_.modal().inverse().row(i).dot(constant);
    constant_sizes_[place % n] += to_.modal().inverse().row(i).cwiseAbs().dot(constant.cwiseAbs());
  }
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
}

void ExactChange::renew() {
  if (from_arrangement_ != from_.arrangement() || to_arrangement_ != to_.arrangement()) {
    arrange();
    return;
  }
  for (Index k = from_.n_modes(); k < from_.n_coordinates(); ++k)
    set_column(k);
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
  const Index modes = to_.n_modes();
  const Vector before = from_.columns().col(coordinate);
  Eigen::Matrix<long double, Eigen::Dynamic, 1> state = after_resets(before).cast<long double>();
  if (coordinate >= from_.n_modes()) {
    const Index input = coordinate - from_.n_modes() + modes;
    state -= to_.columns().col(input).head(modes).cast<long double>();
    column[to_.places()[static_cast<std::size_t>(input)]] = 1;
  }
  const ModalForm::Long &inverse = to_.modal().long_inverse();
  for (Index i = 0; i < modes; ++i) {
    const auto place = static_cast<std::size_t>(to_.places()[static_cast<std::size_t>(i)]);
    column[place] += static_cast<double>(inverse.row(i).dot(state));
    sizes[place % n] += std::abs(column[place]);
  }
}

} // namespace vibroimpact::motion
