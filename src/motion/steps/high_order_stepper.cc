#include "motion/steps/high_order_stepper.h"

#include "common/error.h"
#include "motion/interval/guard_products.h"
#include "motion/steps/dormand_prince_8.h"
#include "motion/system/decayed_states.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace vibroimpact::motion {

using contact::LocalState;

namespace {

namespace method = dormand_prince_8;

constexpr double safety = 0.9;
constexpr double smallest_growth = 0.2, largest_growth = 4;
constexpr double exponent = 1.0 / 8; // of the step's error and of the polynomial's alike

ConstVectorView view_of(const Vector &x) { return {x.data(), x.size()}; }

// a |a| / sqrt(a^2 + b^2), by the ratio of the two, lest the squares of a small model's figures
// vanish.
double corrected(double a, double b) {
  const double large = std::max(std::abs(a), std::abs(b));
  if (large == 0)
    return 0;
  const double share = std::abs(a) / large, other = std::abs(b) / large;
  return a * share / std::sqrt(share * share + other * other);
}

} // namespace

HighOrderStepper::HighOrderStepper(const Equations &equations, const Settings &settings)
    : equations_(equations),
      maximum_step_(settings.maximum_step > 0 ? settings.maximum_step
                                              : std::numeric_limits<double>::infinity()),
      event_tolerance_(settings.event_tolerance),
      measure_(equations, settings.relative_tolerance, settings.absolute_tolerance),
      source_step_(equations, settings.relative_tolerance),
      error_(Vector::Zero(equations.layout().size())), dense_error_(equations.layout().n),
      stages_(equations.layout().size(), method::stages),
      stage_state_(Vector::Zero(equations.layout().size())) {}

void HighOrderStepper::forget() {
  learned_.clear();
  measure_.forget();
  first_of_phase_ = true;
}

void HighOrderStepper::recall_steps() {
  const auto known = learned_.find(equations_.modes());
  if (known != learned_.end()) {
    steps_ = known->second;
    return;
  }
  const double highest = equations_.model().highest_frequency();
  steps_ = {.first = highest > 0 ? 0.01 / highest : 1e-6,
            .last = std::numeric_limits<double>::infinity()};
}

void HighOrderStepper::find_only_contact() {
  only_contact_.reset();
  std::size_t count = 0;
  for (std::size_t c = 0; c < equations_.contacts().size(); ++c) {
    if (!equations_.mode(c).affine && !equations_.mode(c).holds_gap) {
      ++count;
      only_contact_ = c;
    }
  }
  if (count != 1)
    only_contact_.reset();
}

// Contacts in circular gaps with a guard that is no sum of squares: a curve through its values at
// the ends of a step.
void HighOrderStepper::find_curved_guards() {
  curved_guards_.clear();
  for (std::size_t c = 0; c < equations_.contacts().size(); ++c) {
    const std::vector<contact::Guard> &guards = equations_.mode(c).guards;
    if (equations_.contacts().pairs()[c].circle &&
        std::ranges::any_of(guards, [](const auto &of) { return !is_product(of.indicator); }))
      curved_guards_.push_back(c);
  }
}

// In the time r / |u'| the normal turns by no more than an angle of pi / 2; past the centre it
// jumps, even where no force does so and the errors of the step know nothing of it. A motion
// through the centre itself steps over a small part of the gap there.
double HighOrderStepper::curved_step() const {
  constexpr double part = 0.25;
  constexpr double centre = 1e-3;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t c : curved_guards_) {
    const contact::CircularFrame at = equations_.frame(c, start_.time, view_of(start_.state));
    const double speed = std::hypot(at.gap_rate, at.turning);
    const double clearance = equations_.contacts().pairs()[c].circle->clearance();
    if (speed > 0)
      least = std::min(least, part * std::max(at.distance, centre * clearance) / speed);
  }
  return least;
}

LocalState HighOrderStepper::contact_at(const EndPoint &point) const {
  return equations_.local_state(*only_contact_, point.time, view_of(point.state));
}

void HighOrderStepper::restart(double time, const Vector &x) {
  end_.time = phase_start_ = time;
  end_.state = x;
  read_sources(time);
  complete(end_);
  start_ = end_;
  measure_.begin(end_);
  find_only_contact();
  find_curved_guards();
  begins_contact_ = false;
  if (only_contact_) {
    const LocalState local = contact_at(end_);
    // What is left of the gap was passed within the uncertainty of the instant, or nearly so.
    begins_contact_ = local.gap_rate < 0 && -local.gap <= -local.gap_rate * 100 * event_tolerance_;
  }
  recall_steps();
  natural_step_ = steps_.first;
  first_of_phase_ = true;
}

// The work integrals, the last entries, does not act back: stages go without it.
void HighOrderStepper::take_stages(const TimeTransformation &course) {
  const Index size = equations_.layout().size();
  double *k = stages_.data();
  const double rate = course.rate(0);
  for (Index m = 0; m < size; ++m)
    k[m] = rate * start_.rates[m];
  take_stages(course, std::make_index_sequence<method::stages>());
}

template <std::size_t... stage>
void HighOrderStepper::take_stages(const TimeTransformation &course,
                                   std::index_sequence<stage...>) {
  (take_stage<stage>(course), ...);
}

template <std::size_t stage> void HighOrderStepper::take_stage(const TimeTransformation &course) {
  if constexpr (stage > 0) {
    const Index size = equations_.layout().size();
    constexpr auto factor = [](auto j) { return method::a[stage][j]; };
    add_stages<stage>(factor, equations_.layout().physical_size(), stage_state_.data());
    double *k = stages_.data() + static_cast<Index>(stage) * size;
    const double s = method::c[stage];
    equations_.rates(course.time(s), view_of(stage_state_), VectorView(k, size));
    const double rate = course.rate(s);
    for (Index m = 0; m < size; ++m)
      k[m] *= rate;
  }
}

// state = that at the start + sum of the first `count` stages times their factors, in one pass and
// without those whose factor is zero.
template <std::size_t count, typename Factor>
void HighOrderStepper::add_stages(Factor factor, Index size, double *state) const {
  const auto entry = [&]<std::size_t... j>(Index m, std::index_sequence<j...>) {
    const double *k = stages_.data() + m;
    const Index stride = stages_.rows();
    double sum = 0;
    const auto add = [&](auto i) {
      if constexpr (factor(i) != 0)
        sum += factor(i) * k[static_cast<Index>(i) * stride];
    };
    (add(std::integral_constant<std::size_t, j>()), ...);
    return sum;
  };
  for (Index m = 0; m < size; ++m)
    state[m] = start_.state[m] + entry(m, std::make_index_sequence<count>());
}

double HighOrderStepper::attempt(const TimeTransformation &course) {
  taken_ = course;
  take_stages(course);
  end_.time = course.start + course.length;
  end_.state.resize(start_.state.size());
  constexpr auto factor = [](auto j) { return method::b[j]; };
  add_stages<method::stages>(factor, end_.state.size(), end_.state.data());
  if (!end_.state.allFinite())
    return std::numeric_limits<double>::infinity();
  complete(end_);
  measure_.set_step(start_, end_);
  return std::max(step_error(), dense_error());
}

// The estimate of order 5, corrected where that of order 3 is not much larger (Hairer).
double HighOrderStepper::step_error() {
  for (Index m = 0; m < error_.size(); ++m) {
    double fifth = 0;
    double third = 0;
    for (int i = 0; i < method::stages; ++i) {
      fifth += method::fifth[i] * stages_(m, i);
      third += method::third[i] * stages_(m, i);
    }
    error_[m] = corrected(fifth, 0.1 * third);
  }
  return measure_.of_step(error_);
}

// In the middle the polynomials of rising degree differ by ever less; the next difference is
// estimated from the last two.
double HighOrderStepper::dense_error() {
  const Index n = equations_.layout().n;
  const double h = end_.time - start_.time;
  for (Index j = 0; j < n; ++j) {
    const double rate = h * (start_.rates[j] - end_.rates[j]);
    const double second = h * h * (start_.rates[n + j] + end_.rates[n + j]);
    double before = rate / 8;
    double last = rate / 32 + second / 64;
    if (has_higher_) {
      const double third = h * h * h * (start_.higher(n + j, 0) - end_.higher(n + j, 0));
      before = last;
      last = rate / 64 + second / 128 + third / 768;
    }
    const double ratio = std::abs(before) > 0 ? std::min(1.0, std::abs(last / before)) : 1;
    dense_error_[j] = last * ratio;
  }
  return measure_.of_dense(dense_error_);
}

void HighOrderStepper::complete(EndPoint &point) {
  point.rates.resize(point.state.size());
  equations_.rates(point.time, view_of(point.state),
                   VectorView(point.rates.data(), point.rates.size()));
  equations_.source_values(point.time, point.sources);
  if (has_higher_)
    add_higher(point);
  else
    point.higher.resize(0, 0);
}

bool HighOrderStepper::opening() const {
  if (!only_contact_)
    return false;
  const LocalState local = contact_at(start_);
  return local.gap < 0 && local.gap_rate > 0;
}

double HighOrderStepper::growth(double error) {
  return error > 0
             ? std::clamp(safety * std::pow(error, -exponent), smallest_growth, largest_growth)
             : largest_growth;
}

void HighOrderStepper::learn(const LearnedSteps &steps) {
  steps_ = steps;
  learned_[equations_.modes()] = steps;
}

// The next step from how this one went.
void HighOrderStepper::accept(double error) {
  const double factor = growth(error);
  const double taken = end_.time - start_.time;
  natural_step_ =
      std::max(taken * factor, taken < natural_step_ && factor >= 1 ? natural_step_ : 0);
  if (first_of_phase_)
    learn({.first = taken * std::min(factor, 2.0), .last = steps_.last});
  first_of_phase_ = false;
  measure_.accept();
}

// How long the two sides, moving apart, will stay in contact: within 0.2 % if they were alone and
// the force went with the power 1.5 of the penetration u. With v and the acceleration a now that is
//   u int_0^1 ds / sqrt(v^2 + 0.8 a u (1 - s^2.5)) = 2 u / (v + sqrt(v^2 + fading a u)),
// 0.8 = 2 / 2.5; fading is 8 / 7 for a u << v^2, and 3.2 / (B(0.4, 0.5) / 2.5)^2 = 1.478 for v = 0.
// Between these -0.17 and 0.505, whose sum is theirs, were found by trial.
double HighOrderStepper::rest_of_contact() const {
  const LocalState local = contact_at(start_);
  const double acceleration = equations_.gap_acceleration(
      *only_contact_, start_.time, view_of(start_.state),
      ConstVectorView(start_.rates.data() + equations_.layout().velocity(), equations_.layout().n));
  const double elastic = std::max(0.0, -0.8 * acceleration * local.gap);
  const double kinetic = local.gap_rate * local.gap_rate;
  const double share = elastic / (elastic + kinetic);
  const double fading = 1.143 - 0.17 * share + 0.505 * (1 - std::sqrt(1 - share));
  const double pull = kinetic + fading * elastic / 0.8;
  return -2 * local.gap / (local.gap_rate + std::sqrt(pull));
}

// A step that ends just after the two sides part: the end is where the step is found to need it.
// False: no such step is good enough.
bool HighOrderStepper::take_last(double left, double limit) {
  double error = 0;
  for (int i = 0; i < 3; ++i) {
    const double end = start_.time + left;
    if (end >= limit)
      break;
    error = attempt(TimeTransformation::until(end, start_.time, end));
    ++rejected_; // until it is taken
    const LocalState there = contact_at(end_);
    constexpr double hopeless = 4;
    if (!(there.gap_rate > 0) || error > hopeless)
      break;
    const double correction = -there.gap / there.gap_rate;
    const double beyond =
        correction + std::max(1e-5 * std::abs(correction), 4 * instant_tolerance());
    if (error <= 1 &&
        ((i > 0 && correction <= 0) || (end + beyond < limit && move_end(end + beyond)))) {
      --rejected_;
      learn({.first = steps_.first, .last = left * growth(error)});
      accept(error);
      return true;
    }
    if (std::abs(correction) > 0.3 * left)
      break;
    left += beyond;
  }
  if (error > 1)
    learn({.first = steps_.first, .last = left * growth(error)});
  return false;
}

// Of the end of a contact: a small part of the time that it has lasted, where that is less than the
// tolerance of events.
double HighOrderStepper::instant_tolerance() const {
  constexpr double part = 1e-6;
  const double rounding = 2 * std::numeric_limits<double>::epsilon() * std::abs(start_.time);
  return std::min(event_tolerance_, std::max(rounding, part * (start_.time - phase_start_)));
}

// Where the next step is to end, at first.
double HighOrderStepper::wanted_step(double left) const {
  const double wanted = std::min({natural_step_, maximum_step_, curved_step()});
  if (wanted < left - 0.9 * steps_.last)
    return wanted;
  // What is left then is a good last step.
  return std::min(wanted, std::max(left - 0.9 * steps_.last, 0.5 * left));
}

void HighOrderStepper::step(double limit) {
  std::swap(start_, end_);
  if (clear_decayed(equations_, start_.time, start_.state))
    complete(start_);
  const double rest_of_opening =
      opening() ? rest_of_contact() : std::numeric_limits<double>::infinity();
  // What the event tolerance cannot tell from parted sides has no end to step to.
  const bool opens = std::isfinite(rest_of_opening) && rest_of_opening > 16 * event_tolerance_;
  const double left = opens ? rest_of_opening : std::numeric_limits<double>::infinity();
  if (opens && left <= std::min(steps_.last, maximum_step_) &&
      left <=
          (1 + 1e-9) * source_step_.limited(start_.time, left, measure_.source_tolerances(left)) &&
      take_last(left, limit))
    return;
  const bool rooted = only_contact_ && begins_contact_ && !opens;
  // Evenly in the root of a time that is longer by more is evenly in time, but for the rounding.
  constexpr double nearness = 1e-3;
  const double free_step = std::min(wanted_step(left), limit - start_.time);
  double wanted =
      source_step_.limited(start_.time, free_step, measure_.source_tolerances(free_step));
  const double first = wanted;
  double before = 0;
  for (int i = 0; i < 100; ++i) {
    const double rest = limit - start_.time;
    // Two halves rather than a step and a sliver.
    const double end = rest <= wanted * (1 + 1e-9)
                           ? limit
                           : start_.time + (rest < 2 * wanted ? 0.5 * rest : wanted);
    double error =
        attempt(rooted ? TimeTransformation::since(phase_start_, start_.time, end)
                : opens && end < start_.time + left && end - start_.time > nearness * left
                    ? TimeTransformation::until(start_.time + left, start_.time, end)
                    : TimeTransformation::even(start_.time, end));
    // From rest under forces that begin as a power of time, all errors do so too, and relative to
    // what a step reaches they are the same for steps of every length. They count against what the
    // first wanted step would reach, that much more at least as it is longer.
    if (measure_.at_rest() && i > 0 && error > 0.5 * before)
      error *= (end - start_.time) / first;
    else
      before = error;
    if (error <= 1) {
      end_.time = end;
      accept(error);
      return;
    }
    ++rejected_;
    const double shrink =
        std::isfinite(error) ? std::max(smallest_growth, safety * std::pow(error, -exponent)) : 0.1;
    wanted = natural_step_ = (end - start_.time) * shrink;
    if (!(start_.time + wanted > start_.time))
      break;
  }
  throw NumericalError("time integration stopped at t = " + std::to_string(start_.time) +
                       " s: no step is short enough for the tolerance");
}

// A little further on or back the derivatives at the end are as good as another step. Even a third
// derivative that falls as the root of the time left makes no more than rounding of it.
bool HighOrderStepper::move_end(double time) {
  const double shift = time - end_.time;
  constexpr double little = 1e-5;
  if (!has_higher_ || std::abs(shift) > little * (end_.time - start_.time))
    return false;
  const StateLayout &layout = equations_.layout();
  const Index size = layout.physical_size();
  const Index kept = layout.size() - size;
  const Vector before = end_.rates.tail(kept);
  end_.state.head(size) += shift * end_.rates.head(size) + 0.5 * shift * shift * end_.higher.col(0);
  end_.time = time;
  complete(end_);
  end_.state.tail(kept) += 0.5 * shift * (before + end_.rates.tail(kept));
  return true;
}

// The way that the error of the longer step was judged for: the shorter one has less. At the end of
// the contact itself evenly in the root of the time until then.
void HighOrderStepper::shorten(double time) {
  if (move_end(time))
    return;
  constexpr double shallow = 1e-3; // part of the penetration at the start
  attempt(taken_.to(time));
  if (opening() && contact_at(end_).gap > shallow * contact_at(start_).gap)
    attempt(TimeTransformation::until(time, start_.time, time));
  end_.time = time;
  if (!end_.state.allFinite())
    throw NumericalError("the state is no longer finite at t = " + std::to_string(time) + " s");
}

void HighOrderStepper::undo() { end_ = start_; }

} // namespace vibroimpact::motion
