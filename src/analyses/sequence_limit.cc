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

void SequenceLimit::add(const Vector &state) {
  states_.push_front(state.cwiseProduct(scale_));
  if (static_cast<Index>(states_.size()) > most_terms + 2)
    states_.pop_back();
}

double SequenceLimit::last_change() const {
  return (states_[0] - states_[1]).cwiseAbs().maxCoeff();
}

// Of the newest states but one, the oldest of them first.
std::optional<Vector> SequenceLimit::mean(const Vector &weights) const {
  const Vector &newest = states_[0];
  Vector shift = Vector::Zero(scale_.size());
  for (Index i = 0; i < weights.size(); ++i)
    shift += weights[i] * (states_[static_cast<std::size_t>(weights.size() - i)] - newest);
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

// Each further term is one difference more of the past: Gram and Schmidt's way takes them in turn,
// and what is left of the last difference tells when they are enough.
std::optional<Vector> SequenceLimit::limit() const {
  const auto most = std::min(static_cast<Index>(states_.size()) - 2, most_terms);
  if (most < 1)
    return std::nullopt;
  Matrix basis(scale_.size(), most);       // orthonormal
  Matrix parts = Matrix::Zero(most, most); // of the differences in the basis
  Vector wanted(most);                     // parts of the last difference
  Vector rest = states_[0] - states_[1];
  const double enough = unexplained * rest.norm();
  for (Index k = 0; k < most; ++k) {
    const auto age = static_cast<std::size_t>(k + 1);
    Vector direction = states_[age] - states_[age + 1];
    const double size = direction.norm();
    for (Index i = 0; i < k; ++i) {
      parts(i, k) = basis.col(i).dot(direction);
      direction -= parts(i, k) * basis.col(i);
    }
    parts(k, k) = direction.norm();
    if (!(parts(k, k) > dependent * size))
      return std::nullopt;
    basis.col(k) = direction / parts(k, k);
    wanted[k] = basis.col(k).dot(rest);
    rest -= wanted[k] * basis.col(k);
    if (rest.norm() <= enough)
      return limit_of(recurrence(parts, wanted, k + 1));
  }
  return std::nullopt;
}

} // namespace vibroimpact::analyses
