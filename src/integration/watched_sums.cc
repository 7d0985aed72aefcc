#include "integration/watched_sums.h"

#include "integration/flight_arithmetic.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::integration {

namespace {
constexpr double value_error = 1.0 / 384;
const double slope_error = std::sqrt(3.0) / 216;
constexpr double curvature_error = 1.0 / 12;
constexpr double rounding_factor = 16 * std::numeric_limits<double>::epsilon();
constexpr int most_halvings = 60;
constexpr int most_corrections = 60;
} // namespace

WatchedSums::WatchedSums(const WatchedForms &forms, const ExponentialBasis &basis)
    : forms_(forms), basis_(basis), extents_(forms.extents), constants_(forms.constants) {
  for (std::size_t form = 0; form < extents_.size(); ++form)
    if (forms.differentiated[form])
      constants_[form] = 0;
  const std::size_t groups = basis.groups.size();
  for (std::vector<double> *list : {&rate_, &frequency_, &now_real_, &now_imaginary_})
    list->resize(groups);
  for (std::vector<double> *list : {&real_, &imaginary_, &size_, &fourth_})
    list->resize(extents_.size() * groups);
  ends_.resize(extents_.size());
  set_groups(0);
}

// Those from `first` on.
void WatchedSums::set_groups(std::size_t first) {
  for (std::size_t j = first; j < basis_.groups.size(); ++j) {
    const ExponentialBasis::Group &group = basis_.groups[j];
    rate_[j] = group.exponent.real();
    frequency_[j] = group.is_pair ? group.exponent.imag() : 0;
    for (std::size_t form = 0; form < extents_.size(); ++form)
      set_coefficient(form, j, seen_of_group(forms_.rows, static_cast<Index>(form), basis_, group));
  }
}

// A derivative sees the exponent times what the form sees.
void WatchedSums::set_coefficient(std::size_t form, std::size_t group, Complex seen) {
  const double rate = rate_[group];
  const double frequency = frequency_[group];
  if (forms_.differentiated[form])
    seen = {seen.real() * rate - seen.imag() * frequency,
            seen.real() * frequency + seen.imag() * rate};
  const double square = rate * rate + frequency * frequency;
  const std::size_t place = form * rate_.size() + group;
  real_[place] = seen.real();
  imaginary_[place] = seen.imag();
  size_[place] = std::sqrt(std::norm(seen));
  fourth_[place] = size_[place] * square * square;
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
                      .first = goes_on_ ? ends_[form] : sum(form, start.real, start.imaginary),
                      .last = sum(form, end.real, end.imaginary)};
    ends_[form] = piece.last;
    extents_[form]->include(piece.first.value);
    extents_[form]->include(piece.last.value);
    rounding_ = rounding(form);
    include(form, piece, 0);
  }
  goes_on_ = true;
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

// The slope has one zero in the piece, near that of the cubic through the slopes and curvatures at
// both ends. As far from it as slope / curvature the value lacks half of slope^2 / curvature.
void WatchedSums::include_turn(std::size_t form, const Piece &piece) {
  using flight_arithmetic::Height;
  double low = piece.from;
  double high = piece.to;
  const bool rises = piece.first.slope > 0;
  const Height first{piece.first.slope, piece.first.curvature};
  const Height last{piece.last.slope, piece.last.curvature};
  double instant = low + flight_arithmetic::zero_of_cubic(first, last, high - low);
  for (int i = 0; i < most_corrections; ++i) {
    const Point there = at(form, instant);
    extents_[form]->include(there.value);
    if (there.slope * there.slope <= rounding_ * std::abs(there.curvature))
      return;
    ((there.slope > 0) == rises ? low : high) = instant;
    const double wanted = instant - there.slope / there.curvature;
    instant = wanted > low && wanted < high ? wanted : 0.5 * (low + high);
  }
}

} // namespace vibroimpact::integration
