#include "integration/flight_phase.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vibroimpact::integration {

FlightPhase::FlightPhase(const PhaseForms &forms, ExponentialBasis basis, Matrix inverse)
    : forms_(forms), basis_(std::move(basis)), inverse_(std::move(inverse)) {
  // Oscillating modes side by side, next to the inputs.
  std::stable_partition(basis_.groups.begin(),
                        basis_.groups.begin() + static_cast<std::ptrdiff_t>(basis_.n_modes()),
                        [](const ExponentialBasis::Group &group) { return !group.is_pair; });
  for (const ExponentialBasis::Group &group : basis_.groups)
    sums_.add_exponent(group.is_pair ? group.exponent : group.exponent.real());
  const std::vector<Complex> coefficients(n_groups());
  const std::vector<double> sizes(n_groups());
  for (const double constant : forms_.guard_forms().constants)
    sums_.add_guard(constant, coefficients, sizes);
  set_coefficients(0);
}

void FlightPhase::renew(const ExponentialBasis &basis) {
  basis_.take_inputs(basis);
  exponents_.clear();
  for (std::size_t j = basis_.n_modes(); j < n_groups(); ++j)
    exponents_.push_back(basis_.groups[j].is_pair ? basis_.groups[j].exponent
                                                  : basis_.groups[j].exponent.real());
  sums_.set_exponents(basis_.n_modes(), exponents_);
  set_coefficients(basis_.n_modes());
}

double FlightPhase::size_behind(Index guard, const ExponentialBasis::Group &group) const {
  const Matrix &rows = forms_.guard_forms().rows;
  double sum = 0;
  for (Index column = group.column; column <= group.column + (group.is_pair ? 1 : 0); ++column)
    for (Index i = 0; i < rows.cols(); ++i)
      sum += std::abs(rows(guard, i) * basis_.columns(i, column));
  return sum;
}

// Of the groups from `first` on.
void FlightPhase::set_coefficients(std::size_t first) {
  const Matrix &rows = forms_.guard_forms().rows;
  for (Index g = 0; g < rows.rows(); ++g)
    for (std::size_t j = first; j < n_groups(); ++j) {
      const ExponentialBasis::Group &group = basis_.groups[j];
      sums_.set_coefficient(static_cast<std::size_t>(g), j, seen_of_group(rows, g, basis_, group),
                            size_behind(g, group));
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

} // namespace vibroimpact::integration
