#include "integration/flight_phase.h"

#include <algorithm>
#include <utility>

namespace vibroimpact {

FlightPhase::FlightPhase(const PhaseForms &forms, ExponentialBasis basis, Matrix inverse)
    : forms_(forms), basis_(std::move(basis)), inverse_(std::move(inverse)) {
  // Oscillating modes side by side, next to the inputs: so are those of other phases in the lanes.
  std::stable_partition(basis_.groups.begin(),
                        basis_.groups.begin() + static_cast<std::ptrdiff_t>(basis_.n_modes()),
                        [](const ExponentialBasis::Group &group) { return !group.is_pair; });
  add_sums();
}

// A row sees c Re(a) + d Im(a) = Re((c - i d) a) of a group.
void FlightPhase::add_sums() {
  for (const ExponentialBasis::Group &group : basis_.groups)
    sums_.add_exponent(group.is_pair ? group.exponent : group.exponent.real());
  const GuardForms &forms = forms_.guard_forms();
  const Matrix seen = forms.rows.lazyProduct(basis_.columns);
  const Matrix parts = forms.rows.cwiseAbs().lazyProduct(basis_.columns.cwiseAbs());
  std::vector<Complex> coefficients;
  std::vector<double> sizes;
  for (Index g = 0; g < seen.rows(); ++g) {
    coefficients.clear();
    sizes.clear();
    for (const ExponentialBasis::Group &group : basis_.groups) {
      coefficients.emplace_back(seen(g, group.column),
                                group.is_pair ? -seen(g, group.column + 1) : 0.0);
      sizes.push_back(parts(g, group.column) + (group.is_pair ? parts(g, group.column + 1) : 0.0));
    }
    sums_.add_guard(forms.constants[g], coefficients, sizes);
  }
}

void FlightPhase::rows(const Amplitudes &amplitudes, Vector &rows) const {
  const Index count = basis_.columns.rows();
  rows.setZero(count);
  const auto add = [&](Index column, double factor) {
    const double *entries = &basis_.columns(0, column);
    for (Index i = 0; i < count; ++i)
      rows[i] += factor * entries[i];
  };
  for (std::size_t j = 0; j < n_groups(); ++j) {
    add(basis_.groups[j].column, amplitudes.real[j]);
    if (basis_.groups[j].is_pair)
      add(basis_.groups[j].column + 1, amplitudes.imaginary[j]);
  }
}

void FlightPhase::find_modes(const Vector &y, Amplitudes &amplitudes) {
  rest_ = y;
  const Index count = size();
  const auto subtract = [&](Index column, double factor) {
    const double *entries = &basis_.columns(0, column);
    for (Index i = 0; i < count; ++i)
      rest_[i] -= factor * entries[i];
  };
  for (std::size_t j = basis_.n_modes(); j < n_groups(); ++j) {
    subtract(basis_.groups[j].column, amplitudes.real[j]);
    if (basis_.groups[j].is_pair)
      subtract(basis_.groups[j].column + 1, amplitudes.imaginary[j]);
  }
  const auto modal = [&](Index row) {
    double sum = 0;
    for (Index i = 0; i < count; ++i)
      sum += inverse_(row, i) * rest_[i];
    return sum;
  };
  for (std::size_t j = 0; j < basis_.n_modes(); ++j) {
    amplitudes.real[j] = modal(basis_.groups[j].column);
    amplitudes.imaginary[j] = basis_.groups[j].is_pair ? modal(basis_.groups[j].column + 1) : 0.0;
  }
}

} // namespace vibroimpact
