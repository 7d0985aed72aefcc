#include "integration/flight_phase.h"

#include <utility>

namespace vibroimpact {

FlightPhase::FlightPhase(const Equations &equations, ExponentialBasis basis, Matrix inverse)
    : contact_modes_(equations.modes()), basis_(std::move(basis)), inverse_(std::move(inverse)) {
  add_sums(equations);
  for (std::size_t c = 0; c < contact_modes_.size(); ++c)
    add_guards(equations, c);
}

// A row sees c Re(a) + d Im(a) = Re((c - i d) a) of a group.
void FlightPhase::add_sums(const Equations &equations) {
  for (const ExponentialBasis::Group &group : basis_.groups)
    sums_.add_exponent(group.is_pair ? group.exponent : group.exponent.real());
  const GuardForms forms = guard_forms(equations);
  const Matrix seen = forms.rows * basis_.columns;
  const Matrix parts = forms.rows.cwiseAbs() * basis_.columns.cwiseAbs();
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

void FlightPhase::add_guards(const Equations &equations, std::size_t contact) {
  const ContactPair &pair = equations.contacts().pairs()[contact];
  const Mode &mode = pair.law->modes()[static_cast<std::size_t>(contact_modes_[contact])];
  for (std::size_t g = 0; g < mode.guards.size(); ++g) {
    const Guard &guard = mode.guards[g];
    guards_.push_back({.contact = contact, .guard = g, .target = guard.target});
    std::vector<Reset> &resets = resets_.emplace_back();
    for (std::size_t i = 0; i < guard.reset.size(); ++i) {
      LinearRow form = linear_row(equations, contact, guard.reset[i]);
      resets.push_back(
          {.row = equations.layout().internal() + pair.internal_offset + static_cast<Index>(i),
           .form = std::move(form.row),
           .constant = form.constant});
    }
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

void FlightPhase::reset(std::size_t guard, const Vector &rows, Vector &y) const {
  for (const Reset &reset : resets_[guard])
    y[reset.row] = reset.constant + reset.form.dot(rows.transpose());
}

} // namespace vibroimpact
