#include "analyses/sequence_limit.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

namespace {
constexpr Index most_terms = 6;
// Part of the last difference that a recurrence may leave unexplained: the distance to the limit
// shrinks by about this at once.
constexpr double unexplained = 0.02;
constexpr double contraction = 0.97;
// Part of the state over which a limit is believed: beyond it the sequence is not linear yet.
constexpr double reach = 0.01;
// A difference that adds less than this to those before it is made of them.
constexpr double dependent = 1e-10;

// c_0 ... c_{k-1}, the oldest first, from the upper triangular system.
Vector recurrence(const Matrix &parts, const Vector &wanted, Index terms) {
  Vector c(terms);
  for (Index i = terms - 1; i >= 0; --i) {
    double rest = wanted[i];
    for (Index j = i + 1; j < terms; ++j)
      rest += parts(i, j) * c[terms - 1 - j];
    c[terms - 1 - i] = -rest / parts(i, i);
  }
  return c;
}

} // namespace

// The polynomial of lower degree by one whose zeros are inside the circle when all of these are:
// the recursion of Schur and Cohn.
bool zeros_within(Vector coefficients, double radius) {
  Index n = coefficients.size();
  for (Index i = 0; i < n; ++i)
    coefficients[i] /= std::pow(radius, n - i);
  for (; n > 0; --n) {
    const double last = coefficients[0];
    if (!(std::abs(last) < 1))
      return false;
    Vector lower(n - 1);
    for (Index i = 0; i < n - 1; ++i)
      lower[i] = (coefficients[i + 1] - last * coefficients[n - 1 - i]) / (1 - last * last);
    coefficients = lower;
  }
  return true;
}

SequenceLimit::SequenceLimit(const Vector &scale)
    : scale_(scale), states_(scale.size(), most_terms + 2), basis_(scale.size(), most_terms),
      parts_(Matrix::Zero(most_terms, most_terms)), wanted_(most_terms), rest_(scale.size()),
      direction_(scale.size()) {}

// Of the newest states but one, the oldest of them first.
std::optional<Vector> SequenceLimit::mean(const Vector &weights) const {
  const auto newest = states_[0];
  Vector shift = Vector::Zero(scale_.size());
  for (Index i = 0; i < weights.size(); ++i)
    shift += weights[i] * (states_[weights.size() - i] - newest);
  if (!(shift.cwiseAbs().maxCoeff() <= reach * newest.cwiseAbs().maxCoeff()))
    return std::nullopt;
  return (newest + shift).cwiseQuotient(scale_);
}

std::optional<Vector> SequenceLimit::limit_of(const Vector &recurrence) const {
  if (!zeros_within(recurrence, contraction))
    return std::nullopt;
  Vector weights(recurrence.size() + 1);
  weights << recurrence, 1;
  return mean(weights / weights.sum());
}

// One difference more of the past, by Gram and Schmidt's way. False: it is made of those before.
bool SequenceLimit::add_direction(Index k) {
  direction_ = states_[k + 1] - states_[k + 2];
  const double size = direction_.norm();
  for (Index i = 0; i < k; ++i) {
    parts_(i, k) = basis_.col(i).dot(direction_);
    direction_ -= parts_(i, k) * basis_.col(i);
  }
  parts_(k, k) = direction_.norm();
  if (!(parts_(k, k) > dependent * size))
    return false;
  basis_.col(k) = direction_ / parts_(k, k);
  return true;
}

// Each further term is one difference more of the past; what is left of the last difference tells
// when they are enough.
std::optional<Vector> SequenceLimit::limit() {
  const Index most = std::min(states_.count() - 2, most_terms);
  if (most < 1)
    return std::nullopt;
  rest_ = states_[0] - states_[1];
  const double enough = unexplained * rest_.norm();
  for (Index k = 0; k < most && add_direction(k); ++k) {
    wanted_[k] = basis_.col(k).dot(rest_);
    rest_ -= wanted_[k] * basis_.col(k);
    if (rest_.norm() <= enough)
      return limit_of(recurrence(parts_, wanted_, k + 1));
  }
  return std::nullopt;
}

} // namespace vibroimpact::analyses
