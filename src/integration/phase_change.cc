#include "integration/phase_change.h"

namespace vibroimpact {

namespace {

std::size_t own_inputs(const ExponentialBasis &basis) {
  return !basis.inputs.empty() && basis.inputs.front().own ? 1 : 0;
}

} // namespace

PhaseChange::PhaseChange(const FlightPhase &from, std::size_t guard, const FlightPhase &to)
    : from_(from.basis().groups), to_(to.basis().groups),
      first_input_(from.basis().n_modes() + own_inputs(from.basis())),
      n_modes_(to.basis().n_modes()), has_constant_(own_inputs(to.basis()) > 0) {
  const Matrix &rows = from.basis().columns;
  const Index size = to.size();
  Matrix state = rows.topRows(size);
  Vector constant = Vector::Zero(size);
  for (const PhaseForms::Reset &reset : from.forms().resets(guard)) {
    state.row(reset.entry) = reset.form.row * rows;
    constant[reset.entry] = reset.form.constant;
  }
  if (has_constant_)
    constant -= to.basis().columns.col(to_[n_modes_].column).head(size);
  // Less the response to the inputs, which both phases have in the same order.
  std::size_t input = n_modes_ + own_inputs(to.basis());
  for (std::size_t j = first_input_; j < from_.size(); ++j, ++input)
    for (Index part = 0; part < (from_[j].is_pair ? 2 : 1); ++part)
      state.col(from_[j].column + part) -=
          to.basis().columns.col(to_[input].column + part).head(size);
  transposed_ = (to.inverse() * state).transpose();
  constant_ = to.inverse() * constant;
}

void PhaseChange::apply(const Amplitudes &from, Amplitudes &to) const {
  to.resize(to_.size());
  const auto modal = [&](Index column) {
    double sum = constant_[column];
    const double *factor = &transposed_(0, column);
    for (std::size_t j = 0; j < from_.size(); ++j) {
      sum += factor[from_[j].column] * from.real[j];
      if (from_[j].is_pair)
        sum += factor[from_[j].column + 1] * from.imaginary[j];
    }
    return sum;
  };
  for (std::size_t j = 0; j < n_modes_; ++j) {
    to.real[j] = modal(to_[j].column);
    to.imaginary[j] = to_[j].is_pair ? modal(to_[j].column + 1) : 0.0;
  }
  std::size_t place = n_modes_;
  if (has_constant_) {
    to.real[place] = 1;
    to.imaginary[place++] = 0;
  }
  for (std::size_t j = first_input_; j < from_.size(); ++j, ++place) {
    to.real[place] = from.real[j];
    to.imaginary[place] = from.imaginary[j];
  }
}

} // namespace vibroimpact
