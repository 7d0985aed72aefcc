#include "integration/flight_kernel.h"

#include "common/signals.h"
#include "integration/flight_functions.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::integration {

using namespace flight_arithmetic;

void FlightKernel::start(const GuardSums &sums, const Amplitudes &amplitudes) {
  sums_ = &sums;
  n_groups_ = sums.n_groups();
  n_guards_ = sums.n_guards();
  start_.resize(n_groups_);
  end_.resize(n_groups_);
  factors_.assign(n_groups_, 1);
  sines_.assign(n_groups_, 0);
  cosines_.assign(n_groups_, 1);
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

void FlightKernel::watch(WatchedSums *sums) {
  watched_ = sums;
  if (watched_)
    watched_->begin();
}

// The functions take two groups at a time.
void FlightKernel::find_factors(double h) {
  const std::vector<std::size_t> &decaying = sums_->decaying;
  for (std::size_t i = 0; i < decaying.size(); i += 2) {
    const std::size_t j = decaying[i];
    const std::size_t k = decaying[std::min(i + 1, decaying.size() - 1)];
    const Two factor = exponential({sums_->rate[j] * h, sums_->rate[k] * h});
    factors_[j] = factor.first;
    factors_[k] = factor.second;
  }
  const std::vector<std::size_t> &oscillating = sums_->oscillating;
  for (std::size_t i = 0; i < oscillating.size(); i += 2) {
    const std::size_t j = oscillating[i];
    const std::size_t k = oscillating[std::min(i + 1, oscillating.size() - 1)];
    const TwoAngles angle = sine_cosine({sums_->frequency[j] * h, sums_->frequency[k] * h});
    sines_[j] = angle.sine.first;
    sines_[k] = angle.sine.second;
    cosines_[j] = angle.cosine.first;
    cosines_[k] = angle.cosine.second;
  }
}

// Amplitudes h after the start of the piece.
void FlightKernel::move(double h) {
  find_factors(h);
  growth_ = 1;
  for (const std::size_t j : sums_->decaying)
    growth_ = std::max(growth_, factors_[j]);
  for (std::size_t j = 0; j < n_groups_; ++j) {
    end_.size[j] = start_.size[j] * factors_[j];
    rotate(start_.real[j], start_.imaginary[j], factors_[j], sines_[j], cosines_[j], end_.real[j],
           end_.imaginary[j]);
  }
}

// From where the last move has led.
void FlightKernel::move_little(double time) {
  for (std::size_t j = 0; j < n_groups_; ++j)
    rotate_little(sums_->rate[j], sums_->frequency[j], time, end_.real[j], end_.imaginary[j],
                  end_.size[j]);
}

FlightKernel::Value FlightKernel::evaluate(std::size_t guard) const {
  const double *real = sums_->real.data() + guard * n_groups_;
  const double *imaginary = sums_->imaginary.data() + guard * n_groups_;
  Value result{.value = sums_->constant[guard], .slope = 0};
  for (std::size_t j = 0; j < n_groups_; ++j)
    add_group(real[j], imaginary[j], end_.real[j], end_.imaginary[j], sums_->rate[j],
              sums_->frequency[j], result);
  return result;
}

void FlightKernel::evaluate_all() {
  for (std::size_t g = 0; g < n_guards_; ++g)
    ends_[g] = evaluate(g);
}

void FlightKernel::bound() {
  for (std::size_t g = 0; g < n_guards_; ++g) {
    const double *size = sums_->size.data() + g * n_groups_;
    const double *fourth = sums_->fourth.data() + g * n_groups_;
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

// For a guard that rises from zero, a length at which the error is well below the rise.
double FlightKernel::first_trial(double limit) {
  Trial trial(limit);
  double h = limit;
  for (std::size_t g = 0; g < n_guards_; ++g)
    if (zero_[g] == 0)
      trial.add(starts_[g], bounds_[g], margins_[g]);
    else if (bounds_[g] > 0)
      h = std::min(h, std::cbrt(0.04 * starts_[g].slope / (value_error * bounds_[g])));
  least_ = trial.shortest();
  return std::min(h, trial.length());
}

FlightKernel::Verdict FlightKernel::judge(std::size_t g, const Span &span) const {
  const double bound = growth_ * bounds_[g];
  const double margin = growth_ * margins_[g];
  if (zero_[g] != 0)
    return positive_from_zero(starts_[g], ends_[g], span, bound, margin) ? Verdict::positive
                                                                         : Verdict::unclear;
  if (positive(starts_[g], ends_[g], span, bound, margin))
    return Verdict::positive;
  return flight_arithmetic::falling(starts_[g], ends_[g], span, bound, margin) ? Verdict::falling
                                                                               : Verdict::unclear;
}

FlightKernel::Verdict FlightKernel::judge(double h) {
  const Span span(h);
  Verdict verdict = Verdict::positive;
  for (std::size_t g = 0; g < n_guards_; ++g) {
    const Verdict own = judge(g, span);
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

bool FlightKernel::is_zero() const {
  return std::abs(ends_[falling_].value) <= negligible_part * margins_[falling_];
}

bool FlightKernel::found(double instant) {
  time_to_guard_ = instant;
  residual_ = std::abs(ends_[falling_].value / ends_[falling_].slope);
  return ends_[falling_].slope < 0;
}

// The guard is positive at the start of the piece, negative at its end, and falls all along.
bool FlightKernel::locate(double h) {
  Bracket bracket{.low = 0, .high = h};
  double instant = zero_of_cubic(starts_[falling_], ends_[falling_], h);
  for (int i = 0; i < corrections; ++i) {
    move(instant);
    evaluate_all();
    if (is_zero())
      return found(instant);
    const double next = bracket.next(instant, ends_[falling_]);
    const double rest = std::abs(next - instant);
    const bool settled = rest <= 2 * epsilon * next;
    if (rest * sums_->fastest <= short_reach) {
      move_little(next - instant);
      evaluate_all();
      if (settled || is_zero())
        return found(next);
      instant = bracket.next(next, ends_[falling_]);
    } else {
      instant = next;
    }
  }
  return false;
}

// Where two guards fall together pieces shrink and shrink. No guard alone needs pieces that short:
// one that grazes zero at v is passed in pieces of about sqrt(2 v / max|f''|), and with v above its
// rounding of 64 eps sum|a| and max|f''| <= fastest^2 sum|a| this is 1.7e-7 / fastest or more.
double FlightKernel::shortest(double limit) const {
  constexpr double part_of_time_scale = 1e-8;
  const double least = std::max(rounding_factor * limit, part_of_time_scale / sums_->fastest);
  return std::min(limit - flown_, least);
}

FlightKernel::End FlightKernel::fly(double limit) {
  const double least = shortest(limit);
  while (flown_ < limit) {
    leave_if_stopped();
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
    if (verdict != Verdict::positive || h < std::max(least, least_))
      return End::unclear;
    accept(h);
    if (h == rest)
      flown_ = limit;
  }
  return End::limit;
}

} // namespace vibroimpact::integration
