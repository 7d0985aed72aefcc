#include "integration/phase_change.h"

namespace vibroimpact::integration {

namespace {

std::size_t own_inputs(const ExponentialBasis &basis) {
  return !basis.inputs.empty() && basis.inputs.front().own ? 1 : 0;
}

// All resets see the state before any of them.
void reset(const FlightPhase &from, std::size_t guard, Vector &column) {
  const std::vector<PhaseForms::Reset> &resets = from.forms().resets(guard);
  if (resets.empty())
    return;
  const Vector before = column;
  for (const PhaseForms::Reset &reset : resets)
    column[reset.entry] = reset.form.row.dot(before);
}

} // namespace

PhaseChange::PhaseChange(const FlightPhase &from, std::size_t guard, const FlightPhase &to)
    : phase_(from), next_(to), guard_(guard), from_(from.basis().groups), to_(to.basis().groups),
      first_input_(from.basis().n_modes() + own_inputs(from.basis())),
      n_modes_(to.basis().n_modes()), has_constant_(own_inputs(to.basis()) > 0) {
  const Index size = to.size();
  transposed_.resize(from.basis().columns.cols(), size);
  for (std::size_t j = 0; j < first_input_; ++j)
    for (Index part = 0; part < (from_[j].is_pair ? 2 : 1); ++part) {
      Vector state = from.basis().columns.col(from_[j].column + part);
      reset(from, guard, state);
      find(from_[j].column + part, state);
    }
  Vector constant = Vector::Zero(size);
  for (const PhaseForms::Reset &reset : from.forms().resets(guard))
    constant[reset.entry] = reset.form.constant;
  if (has_constant_)
    constant -= to.basis().columns.col(to_[n_modes_].column).head(size);
  constant_ = to.inverse() * constant;
  renew();
}

// Less the response to the inputs, which both phases have in the same order.
void PhaseChange::renew() {
  Vector state;
  std::size_t input = n_modes_ + own_inputs(next_.basis());
  for (std::size_t j = first_input_; j < from_.size(); ++j, ++input)
    for (Index part = 0; part < (from_[j].is_pair ? 2 : 1); ++part) {
      const Index column = from_[j].column + part;
      state = phase_.basis().columns.col(column);
      reset(phase_, guard_, state);
      state -= next_.basis().columns.col(to_[input].column + part);
      find(column, state);
    }
}

// What the modes get of a column's unit amplitude, from the state that it leads to.
void PhaseChange::find(Index column, const Vector &state) {
  const Matrix &inverse = next_.inverse();
  for (Index mode = 0; mode < inverse.rows(); ++mode) {
    double sum = 0;
    for (Index i = 0; i < inverse.cols(); ++i)
      sum += inverse(mode, i) * state[i];
    transposed_(column, mode) = sum;
  }
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

} // namespace vibroimpact::integration
