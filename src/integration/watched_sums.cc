#include "integration/watched_sums.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact {

namespace {
constexpr double value_error = 1.0 / 384;
const double slope_error = std::sqrt(3.0) / 216;
constexpr double curvature_error = 1.0 / 12;
constexpr double rounding_factor = 16 * std::numeric_limits<double>::epsilon();
constexpr int most_halvings = 60;
constexpr int most_corrections = 60;
} // namespace

// A row sees c Re(a) + d Im(a) = Re((c - i d) a) of a group, and its derivative the exponent times
// that.
WatchedSums::WatchedSums(const WatchedForms &forms, const ExponentialBasis &basis)
    : extents_(forms.extents), constants_(forms.constants) {
  for (const ExponentialBasis::Group &group : basis.groups) {
    rate_.push_back(group.exponent.real());
    frequency_.push_back(group.is_pair ? group.exponent.imag() : 0);
  }
  now_real_.resize(rate_.size());
  now_imaginary_.resize(rate_.size());
  const std::size_t count = extents_.size() * rate_.size();
  for (std::vector<double> *list : {&real_, &imaginary_, &size_, &fourth_})
    list->reserve(count);
  if (extents_.empty())
    return;
  const Matrix seen = forms.rows.lazyProduct(basis.columns);
  for (std::size_t form = 0; form < extents_.size(); ++form)
    add_form(forms.differentiated[form], seen.row(static_cast<Index>(form)), basis);
}

void WatchedSums::add_form(bool differentiated, const RowVector &seen,
                           const ExponentialBasis &basis) {
  if (differentiated)
    constants_[real_.size() / rate_.size()] = 0;
  for (const ExponentialBasis::Group &group : basis.groups) {
    const Complex exponent = group.is_pair ? group.exponent : group.exponent.real();
    Complex coefficient(seen[group.column], group.is_pair ? -seen[group.column + 1] : 0.0);
    if (differentiated)
      coefficient *= exponent;
    const double square = std::norm(exponent);
    real_.push_back(coefficient.real());
    imaginary_.push_back(coefficient.imag());
    size_.push_back(std::sqrt(std::norm(coefficient)));
    fourth_.push_back(size_.back() * square * square);
  }
}

WatchedSums::Point WatchedSums::sum(std::size_t form, const std::vector<double> &real,
                                    const std::vector<double> &imaginary) const {
  Point result{.value = constants_[form]};
  const std::size_t first = form * rate_.size();
  for (std::size_t j = 0; j < rate_.size(); ++j) {
    const double rate = rate_[j];
    const double frequency = frequency_[j];
    const double x = real_[first + j] * real[j] - imaginary_[first + j] * imaginary[j];
    const double y = real_[first + j] * imaginary[j] + imaginary_[first + j] * real[j];
    const double dx = x * rate - y * frequency;
    const double dy = y * rate + x * frequency;
    result.fourth += fourth_[first + j] * (std::abs(real[j]) + std::abs(imaginary[j]));
    result.value += x;
    result.slope += dx;
    result.curvature += dx * rate - dy * frequency;
  }
  return result;
}

// Amplitudes at t after the start of the piece.
void WatchedSums::move(double t) {
  if (t == moved_)
    return;
  moved_ = t;
  for (std::size_t j = 0; j < rate_.size(); ++j) {
    const double factor = rate_[j] == 0 ? 1.0 : std::exp(rate_[j] * t);
    const double c = frequency_[j] == 0 ? factor : factor * std::cos(frequency_[j] * t);
    const double s = frequency_[j] == 0 ? 0 : factor * std::sin(frequency_[j] * t);
    now_real_[j] = start_->real[j] * c - start_->imaginary[j] * s;
    now_imaginary_[j] = start_->real[j] * s + start_->imaginary[j] * c;
  }
}

WatchedSums::Point WatchedSums::at(std::size_t form, double t) {
  move(t);
  return sum(form, now_real_, now_imaginary_);
}

double WatchedSums::rounding(std::size_t form) const {
  double sum = std::abs(constants_[form]);
  for (std::size_t j = 0; j < rate_.size(); ++j)
    sum += size_[form * rate_.size() + j] *
           (std::abs(start_->real[j]) + std::abs(start_->imaginary[j]));
  return growth_ * rounding_factor * sum;
}

void WatchedSums::include(const Amplitudes &start, const Amplitudes &end, double h) {
  start_ = &start;
  moved_ = -1;
  growth_ = 1;
  for (const double rate : rate_)
    if (rate > 0)
      growth_ = std::max(growth_, std::exp(rate * h));
  for (std::size_t form = 0; form < extents_.size(); ++form) {
    const Piece piece{.from = 0,
                      .to = h,
                      .first = sum(form, start.real, start.imaginary),
                      .last = sum(form, end.real, end.imaginary)};
    extents_[form]->include(piece.first.value);
    extents_[form]->include(piece.last.value);
    rounding_ = rounding(form);
    include(form, piece, 0);
  }
}

// The values at the ends are included already.
void WatchedSums::include(std::size_t form, const Piece &piece, int halvings) {
  const double h = piece.to - piece.from;
  const double v0 = piece.first.value, v1 = piece.last.value;
  const double s0 = piece.first.slope, s1 = piece.last.slope;
  const double b1 = v0 + h / 3 * s0;
  const double b2 = v1 - h / 3 * s1;
  const double bound = growth_ * piece.first.fourth;
  const double error = bound > 0 ? value_error * h * h * h * h * bound : 0;
  Extent &extent = *extents_[form];
  if (std::max({v0, b1, b2, v1}) + error <= extent.maximum + rounding_ &&
      std::min({v0, b1, b2, v1}) - error >= extent.minimum - rounding_)
    return;
  const double middle = 3 * (b2 - b1) / h;
  const double of_slope = slope_error / value_error * error / h;
  if (std::min({s0, middle, s1}) - of_slope > 0 || std::max({s0, middle, s1}) + of_slope < 0)
    return;
  const double bend0 = 2 * (middle - s0) / h;
  const double bend1 = 2 * (s1 - middle) / h;
  const double of_curvature = curvature_error / value_error * error / (h * h);
  if (std::min(bend0, bend1) - of_curvature > 0 || std::max(bend0, bend1) + of_curvature < 0) {
    if ((s0 > 0) != (s1 > 0))
      include_turn(form, piece);
    return;
  }
  const double half = piece.from + 0.5 * h;
  if (halvings == most_halvings || half <= piece.from || half >= piece.to)
    return;
  const Point between = at(form, half);
  extent.include(between.value);
  include(form, {.from = piece.from, .to = half, .first = piece.first, .last = between},
          halvings + 1);
  include(form, {.from = half, .to = piece.to, .first = between, .last = piece.last}, halvings + 1);
}

// The slope has one zero in the piece. Near it the value changes with the square of the distance,
// so that half the digits of the instant are all of the value's.
void WatchedSums::include_turn(std::size_t form, const Piece &piece) {
  constexpr double enough = 1e-9;
  double low = piece.from;
  double high = piece.to;
  const bool rises = piece.first.slope > 0;
  double instant = low + (high - low) * piece.first.slope / (piece.first.slope - piece.last.slope);
  for (int i = 0; i < most_corrections; ++i) {
    const Point there = at(form, instant);
    extents_[form]->include(there.value);
    ((there.slope > 0) == rises ? low : high) = instant;
    const double wanted = instant - there.slope / there.curvature;
    if (std::abs(wanted - instant) <= enough * (piece.to - piece.from))
      return;
    instant = wanted > low && wanted < high ? wanted : 0.5 * (low + high);
  }
}

} // namespace vibroimpact
