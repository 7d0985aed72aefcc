#include "integration/flight_kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact {

namespace {
constexpr double value_error = 1.0 / 384;
const double slope_error = std::sqrt(3.0) / 216;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double rounding_factor = 64 * epsilon;
constexpr int halvings = 24;
constexpr int corrections = 60;
} // namespace

void FlightKernel::start(const GuardSums &sums, const Amplitudes &amplitudes) {
  sums_ = &sums;
  n_groups_ = sums.n_groups();
  n_guards_ = sums.n_guards();
  start_.resize(n_groups_);
  end_.resize(n_groups_);
  shrink_.resize(n_groups_);
  starts_.resize(n_guards_);
  ends_.resize(n_guards_);
  bounds_.resize(n_guards_);
  margins_.resize(n_guards_);
  zero_.assign(n_guards_, 0);
  for (std::size_t j = 0; j < n_groups_; ++j) {
    end_.real[j] = amplitudes.real[j];
    end_.imaginary[j] = amplitudes.imaginary[j];
    end_.size[j] = std::sqrt(end_.real[j] * end_.real[j] + end_.imaginary[j] * end_.imaginary[j]);
  }
  evaluate_all();
  std::swap(start_, end_);
  std::swap(starts_, ends_);
  bound();
  flown_ = 0;
}

void FlightKernel::zero_at_start(std::size_t guard) {
  zero_[guard] = 1;
  starts_[guard].value = 0;
}

// Amplitudes h after the start of the piece.
void FlightKernel::move(double h) {
  const double *rate = sums_->rate.data();
  const double *frequency = sums_->frequency.data();
  growth_ = 1;
  for (std::size_t j = 0; j < n_groups_; ++j) {
    const double factor = rate[j] == 0 ? 1.0 : std::exp(rate[j] * h);
    growth_ = std::max(growth_, factor);
    end_.size[j] = start_.size[j] * factor;
    if (frequency[j] == 0) {
      end_.real[j] = start_.real[j] * factor;
      end_.imaginary[j] = 0;
      continue;
    }
    const double angle = frequency[j] * h;
    const double c = factor * std::cos(angle);
    const double s = factor * std::sin(angle);
    end_.real[j] = start_.real[j] * c - start_.imaginary[j] * s;
    end_.imaginary[j] = start_.real[j] * s + start_.imaginary[j] * c;
  }
}

// The slope multiplies each term by its exponent.
FlightKernel::Value FlightKernel::evaluate(std::size_t guard) const {
  const double *real = &sums_->real[guard * n_groups_];
  const double *imaginary = &sums_->imaginary[guard * n_groups_];
  Value result{.value = sums_->constant[guard]};
  for (std::size_t j = 0; j < n_groups_; ++j) {
    const double x = real[j] * end_.real[j] - imaginary[j] * end_.imaginary[j];
    const double y = real[j] * end_.imaginary[j] + imaginary[j] * end_.real[j];
    result.value += x;
    result.slope += x * sums_->rate[j] - y * sums_->frequency[j];
  }
  return result;
}

void FlightKernel::evaluate_all() {
  for (std::size_t g = 0; g < n_guards_; ++g)
    ends_[g] = evaluate(g);
}

void FlightKernel::bound() {
  for (std::size_t g = 0; g < n_guards_; ++g) {
    const double *size = &sums_->size[g * n_groups_];
    const double *fourth = &sums_->fourth[g * n_groups_];
    double sum = std::abs(sums_->constant[g]);
    double bound = 0;
    for (std::size_t j = 0; j < n_groups_; ++j) {
      sum += size[j] * start_.size[j];
      bound += fourth[j] * start_.size[j];
    }
    margins_[g] = rounding_factor * sum;
    bounds_[g] = bound;
  }
}

// Where value and error would be equal, and beyond which the straight line has long been negative;
// for a guard that rises from zero, where the error would be as large as the rise.
double FlightKernel::first_trial(double limit) const {
  double h = limit;
  for (std::size_t g = 0; g < n_guards_; ++g) {
    const auto [value, slope] = starts_[g];
    const double bound = value_error * bounds_[g];
    if (zero_[g] != 0) {
      if (bound > 0)
        h = std::min(h, std::cbrt(0.3 * slope / bound));
      continue;
    }
    if (bound > 0)
      h = std::min(h, std::sqrt(std::sqrt(value / bound)));
    if (slope < 0)
      h = std::min(h, -2.5 * value / slope);
  }
  return h;
}

FlightKernel::Verdict FlightKernel::judge(std::size_t g, double h) const {
  const auto [v0, s0] = starts_[g];
  const auto [v1, s1] = ends_[g];
  const double third = h / 3;
  const double bound = growth_ * bounds_[g];
  const double margin = growth_ * margins_[g];
  const double error = value_error * h * h * h * h * bound;
  const double b1 = v0 + third * s0;
  const double b2 = v1 - third * s1;
  // Near a zero at the start the error t^2 (h - t)^2 / 24 max|f''''| vanishes faster than f.
  if (zero_[g] != 0)
    return b1 > 0 && 3 * b2 > 16 * error + margin && v1 > margin ? Verdict::positive
                                                                 : Verdict::unclear;
  if (std::min(std::min(v0, b1), std::min(b2, v1)) > error + margin)
    return Verdict::positive;
  const double steepest = std::max(b1 - v0, std::max(b2 - b1, v1 - b2)) * 3;
  if (v1 < -margin && steepest + slope_error * h * h * h * h * bound + margin < 0)
    return Verdict::falling;
  return Verdict::unclear;
}

FlightKernel::Verdict FlightKernel::judge(double h) {
  Verdict verdict = Verdict::positive;
  for (std::size_t g = 0; g < n_guards_; ++g) {
    const Verdict own = judge(g, h);
    if (own == Verdict::unclear || (own == Verdict::falling && verdict == Verdict::falling))
      return Verdict::unclear;
    if (own == Verdict::falling) {
      verdict = own;
      falling_ = g;
    }
  }
  return verdict;
}

void FlightKernel::accept(double h) {
  if (watched_)
    watched_->include(start_, end_, h);
  std::swap(start_, end_);
  std::swap(starts_, ends_);
  std::fill(zero_.begin(), zero_.end(), 0);
  bound();
  flown_ += h;
}

// The guard is positive at the start of the piece, negative at its end, and falls all along.
bool FlightKernel::locate(double h) {
  double low = 0;
  double high = h;
  double instant = h;
  Value there = ends_[falling_];
  for (int i = 0; i < corrections; ++i) {
    const double wanted = instant - there.value / there.slope;
    const double next = wanted > low && wanted < high ? wanted : 0.5 * (low + high);
    const bool settled = std::abs(next - instant) <= 2 * epsilon * next || high - low <= 0;
    instant = next;
    move(instant);
    there = evaluate(falling_);
    if (settled || std::abs(there.value) <= 0.02 * margins_[falling_]) {
      evaluate_all();
      time_to_guard_ = instant;
      residual_ = std::abs(there.value / there.slope);
      return there.slope < 0;
    }
    (there.value > 0 ? low : high) = instant;
  }
  return false;
}

FlightKernel::End FlightKernel::fly(double limit) {
  const double shortest = std::min(limit - flown_, rounding_factor * limit);
  while (flown_ < limit) {
    const double rest = limit - flown_;
    double h = first_trial(rest);
    Verdict verdict = Verdict::unclear;
    for (int i = 0; i < halvings && h > 0 && verdict == Verdict::unclear; ++i) {
      if (i > 0)
        h *= 0.5;
      ++pieces_;
      move(h);
      evaluate_all();
      verdict = judge(h);
    }
    if (verdict == Verdict::falling && locate(h)) {
      if (watched_)
        watched_->include(start_, end_, time_to_guard_);
      return End::guard;
    }
    // Pieces that shrink and shrink come to nothing: two guards that fall together.
    if (verdict != Verdict::positive || h < shortest)
      return End::unclear;
    accept(h);
    if (h == rest)
      flown_ = limit;
  }
  return End::limit;
}

} // namespace vibroimpact
