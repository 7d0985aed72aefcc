#include "integration/high_order_stepper.h"

#include "common/error.h"
#include "integration/dormand_prince_8.h"
#include "integration/tolerances.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace vibroimpact {

namespace {

namespace method = dormand_prince_8;

constexpr double safety = 0.9;
constexpr double largest_growth = 4;
constexpr double smallest_growth = 0.2;
constexpr double exponent = 1.0 / 8; // of the step's error and of the polynomial's alike

ConstVectorView view_of(const Vector &x) { return {x.data(), x.size()}; }

double third_derivative(const ExponentialForm &form, double time) {
  const double t = time - form.origin;
  double sum = 0;
  for (std::size_t j = form.polynomial.size(); j-- > 3;)
    sum = sum * t + static_cast<double>(j * (j - 1) * (j - 2)) * form.polynomial[j];
  for (const ExponentialForm::Term &term : form.terms)
    sum += std::real(term.amplitude * term.exponent * term.exponent * term.exponent *
                     std::exp(term.exponent * t));
  return sum;
}

} // namespace

HighOrderStepper::HighOrderStepper(const Equations &equations, const IntegrationSettings &settings)
    : equations_(equations),
      maximum_step_(settings.maximum_step > 0 ? settings.maximum_step
                                              : std::numeric_limits<double>::infinity()),
      relative_(settings.relative_tolerance), event_tolerance_(settings.event_tolerance),
      absolute_(absolute_tolerances(equations, settings.absolute_tolerance)),
      stages_(equations.layout().size(), method::stages),
      stage_state_(Vector::Zero(equations.layout().size())),
      stage_rates_(equations.layout().size()) {}

void HighOrderStepper::forget() {
  first_steps_.clear();
  first_of_phase_ = true;
}

double HighOrderStepper::first_step() const {
  const auto known = first_steps_.find(equations_.modes());
  if (known != first_steps_.end())
    return known->second;
  const double highest = equations_.model().highest_frequency();
  return highest > 0 ? 0.01 / highest : 1e-6;
}

// The third derivative needs those of the sources.
void HighOrderStepper::read_sources(double time) {
  sources_.clear();
  has_higher_ = equations_.model().linear() && equations_.holding().empty();
  for (const Source &source : equations_.model().sources()) {
    std::optional<ExponentialForm> form = source.function->exponential_form(time);
    if (!form)
      has_higher_ = false;
    else
      sources_.push_back(*std::move(form));
  }
}

void HighOrderStepper::find_only_contact() {
  only_contact_.reset();
  std::size_t count = 0;
  for (std::size_t c = 0; c < equations_.contacts().size(); ++c) {
    const ContactLaw &law = *equations_.contacts().pairs()[c].law;
    if (!law.modes()[static_cast<std::size_t>(equations_.modes()[c])].affine) {
      ++count;
      only_contact_ = c;
    }
  }
  if (count != 1)
    only_contact_.reset();
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
  find_only_contact();
  begins_contact_ = false;
  if (only_contact_) {
    const LocalState local = contact_at(end_);
    // What is left of the gap was passed within the uncertainty of the instant, or nearly so.
    begins_contact_ = local.gap_rate < 0 && -local.gap <= -local.gap_rate * 100 * event_tolerance_;
  }
  natural_step_ = first_step();
  first_of_phase_ = true;
}

double HighOrderStepper::Course::time(double s) const {
  if (span == 0)
    return start + s * length;
  const double r = root + s * span;
  return origin + sign * r * r;
}

double HighOrderStepper::Course::rate(double s) const {
  return span == 0 ? length : 2 * sign * span * (root + s * span);
}

HighOrderStepper::Course HighOrderStepper::even(double end) const {
  return {.start = start_.time, .length = end - start_.time};
}

HighOrderStepper::Course HighOrderStepper::since_start(double end) const {
  Course course = even(end);
  course.origin = phase_start_;
  course.root = std::sqrt(start_.time - phase_start_);
  course.span = std::sqrt(end - phase_start_) - course.root;
  return course;
}

HighOrderStepper::Course HighOrderStepper::until_end(double end) const {
  Course course = even(end);
  course.origin = end;
  course.sign = -1;
  course.root = std::sqrt(course.length);
  course.span = -course.root;
  return course;
}

// The ledger, the last entries, does not act back: stages go without it.
void HighOrderStepper::take_stages(const Course &course) {
  const Index size = equations_.layout().physical_size();
  stages_.col(0) = course.rate(0) * start_.rates;
  for (int i = 1; i < method::stages; ++i) {
    double *x = stage_state_.data();
    std::copy(start_.state.begin(), start_.state.begin() + size, x);
    for (int j = 0; j < i; ++j) {
      const double factor = method::a[i][j];
      if (factor == 0)
        continue;
      const double *k = &stages_(0, j);
      for (Index m = 0; m < size; ++m)
        x[m] += factor * k[m];
    }
    const double s = method::c[i];
    equations_.rates(course.time(s), view_of(stage_state_),
                     VectorView(stage_rates_.data(), stage_rates_.size()));
    stages_.col(i) = course.rate(s) * stage_rates_;
  }
}

double HighOrderStepper::attempt(const Course &course) {
  take_stages(course);
  end_.time = course.start + course.length;
  end_.state = start_.state;
  for (int i = 0; i < method::stages; ++i)
    if (method::b[i] != 0)
      end_.state += method::b[i] * stages_.col(i);
  if (!end_.state.allFinite())
    return std::numeric_limits<double>::infinity();
  complete(end_);
  return std::max(step_error(), dense_error());
}

// The estimate of order 5, corrected where that of order 3 is not much larger (Hairer).
double HighOrderStepper::step_error() const {
  const Index size = equations_.layout().physical_size();
  double largest = 0;
  for (Index m = 0; m < size; ++m) {
    double fifth = 0;
    double third = 0;
    for (int i = 0; i < method::stages; ++i) {
      fifth += method::fifth[i] * stages_(m, i);
      third += method::third[i] * stages_(m, i);
    }
    const double scale =
        absolute_[m] + relative_ * std::max(std::abs(start_.state[m]), std::abs(end_.state[m]));
    const double squares = fifth * fifth + 0.01 * third * third;
    if (squares > 0)
      largest = std::max(largest, fifth * fifth / std::sqrt(squares) / scale);
  }
  return largest;
}

// In the middle the polynomials of rising degree differ by ever less; the next difference is
// estimated from the last two.
double HighOrderStepper::dense_error() const {
  const Index n = equations_.layout().n;
  const double h = end_.time - start_.time;
  double largest = 0;
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
    const double scale =
        absolute_[j] + relative_ * std::max(std::abs(start_.state[j]), std::abs(end_.state[j]));
    largest = std::max(largest, std::abs(last) * ratio / scale);
  }
  return largest;
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

// m q''' = f' - K q' - C q'' + forces of the contacts by the chain rule, and likewise for internal
// states.
void HighOrderStepper::add_higher(EndPoint &point) {
  const StateLayout &layout = equations_.layout();
  const Model &model = equations_.model();
  const Index n = layout.n;
  const ConstVectorView velocity(point.rates.data(), n);
  const ConstVectorView acceleration(point.rates.data() + n, n);
  point.higher.resize(layout.physical_size(), 1);
  model.stiffness().apply(velocity, elastic_);
  model.damping().apply(acceleration, damping_);
  point.higher.col(0).head(n) = acceleration;
  auto third = point.higher.col(0).segment(n, n);
  third = -elastic_ - damping_;
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    const Source &source = model.sources()[k];
    SourceValues &s = point.sources[k];
    s[3] = third_derivative(sources_[k], point.time);
    third += s[1] * source.load + s[2] * source.rate_load + s[3] * source.inertial_load;
  }
  for (std::size_t c = 0; c < equations_.contacts().size(); ++c) {
    if (equations_.silent(c))
      continue;
    const ContactPair &pair = equations_.contacts().pairs()[c];
    const LocalState local = equations_.local_state(c, point.time, view_of(point.state));
    const double gap_acceleration = equations_.gap_acceleration(c, point.time, acceleration);
    pair.law->evaluate(equations_.modes()[c], local, response_);
    double force =
        response_.force_by_gap * local.gap_rate + response_.force_by_gap_rate * gap_acceleration;
    const int count = pair.n_internal();
    const Index first = layout.internal() + pair.internal_offset;
    for (int i = 0; i < count; ++i) {
      force += response_.force_by_internal[i] * point.rates[first + i];
      double second = response_.internal_rate_by_gap[i] * local.gap_rate +
                      response_.internal_rate_by_gap_rate[i] * gap_acceleration;
      for (int j = 0; j < count; ++j)
        second += response_.internal_rate_by_internal[i * count + j] * point.rates[first + j];
      point.higher(first + i, 0) = second;
    }
    third += force * pair.gap.row.transpose();
  }
  third.array() /= model.mass().array();
}

bool HighOrderStepper::opening() const {
  if (!only_contact_)
    return false;
  const LocalState local = contact_at(start_);
  return local.gap < 0 && local.gap_rate > 0;
}

// The next step from how this one went; the first of a phase is remembered for the next one like
// it.
void HighOrderStepper::accept(double error) {
  const double growth =
      error > 0 ? std::clamp(safety * std::pow(error, -exponent), smallest_growth, largest_growth)
                : largest_growth;
  const double taken = end_.time - start_.time;
  natural_step_ =
      std::max(taken * growth, taken < natural_step_ && growth >= 1 ? natural_step_ : 0);
  if (first_of_phase_)
    first_steps_[equations_.modes()] = natural_step_ / std::max(1.0, growth);
  first_of_phase_ = false;
}

// A step that ends just after the two sides part, if that is near: the end is where the step is
// found to need it. False: no such step is good enough.
bool HighOrderStepper::take_last(double limit) {
  const LocalState local = contact_at(start_);
  const double acceleration = equations_.gap_acceleration(
      *only_contact_, start_.time,
      ConstVectorView(start_.rates.data() + equations_.layout().velocity(), equations_.layout().n));
  // Between a constant acceleration and one that fades.
  const double pull = local.gap_rate * local.gap_rate - 1.2 * acceleration * local.gap;
  double left = -2 * local.gap / (local.gap_rate + std::sqrt(std::max(0.0, pull)));
  if (left > 1.5 * std::min(natural_step_, maximum_step_) || left <= 16 * event_tolerance_)
    return false;
  for (int i = 0; i < 3; ++i) {
    const double end = start_.time + left;
    if (end >= limit)
      return false;
    const double error = attempt(until_end(end));
    const LocalState there = contact_at(end_);
    if (!(there.gap_rate > 0))
      break;
    const double correction = -there.gap / there.gap_rate;
    if (i > 0 && error <= 1 && correction <= 0) {
      accept(error);
      return true;
    }
    if (std::abs(correction) > 0.3 * left)
      break;
    left += correction + std::max(1e-5 * std::abs(correction), 4 * event_tolerance_);
  }
  ++rejected_;
  return false;
}

void HighOrderStepper::step(double limit) {
  std::swap(start_, end_);
  const bool opens = opening();
  if (opens && take_last(limit))
    return;
  const bool rooted = only_contact_ && begins_contact_ && !opens;
  double wanted = std::min(natural_step_, maximum_step_);
  for (int i = 0; i < 100; ++i) {
    const double rest = limit - start_.time;
    // Two halves rather than a step and a sliver.
    const double end = rest <= wanted * (1 + 1e-9)
                           ? limit
                           : start_.time + (rest < 2 * wanted ? 0.5 * rest : wanted);
    const double error = attempt(rooted ? since_start(end) : even(end));
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
  throw NumericalError("the time integrator gave up at t = " + std::to_string(start_.time) +
                       " s: no step is short enough for the tolerance");
}

void HighOrderStepper::shorten(double time) {
  attempt(opening()                          ? until_end(time)
          : only_contact_ && begins_contact_ ? since_start(time)
                                             : even(time));
  end_.time = time;
  if (!end_.state.allFinite())
    throw NumericalError("the state is no longer finite at t = " + std::to_string(time) + " s");
}

void HighOrderStepper::undo() { end_ = start_; }

} // namespace vibroimpact
