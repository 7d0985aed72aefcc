#include "motion/variation/source_tangent.h"

#include "common/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

using model::ExponentialForm;
using model::TimeFunction;

namespace {

using Values = std::array<double, 3>;

ExponentialForm derivative(const ExponentialForm &form) {
  ExponentialForm rate{.origin = form.origin, .terms = form.terms, .polynomial = {}};
  for (ExponentialForm::Term &term : rate.terms)
    term.amplitude *= term.exponent;
  for (std::size_t j = 1; j < form.polynomial.size(); ++j)
    rate.polynomial.push_back(static_cast<double>(j) * form.polynomial[j]);
  return rate;
}

bool same_form(const ExponentialForm &a, const ExponentialForm &b) {
  return a.origin == b.origin && a.polynomial == b.polynomial &&
         std::equal(a.terms.begin(), a.terms.end(), b.terms.begin(), b.terms.end(),
                    [](const ExponentialForm::Term &one, const ExponentialForm::Term &other) {
                      return one.amplitude == other.amplitude && one.exponent == other.exponent;
                    });
}

Values values_of(const TimeFunction &function, const std::optional<ExponentialForm> &form,
                 double time) {
  if (form)
    return {form->value(time), form->rate(time), form->acceleration(time)};
  return {function.value(time), function.rate(time), function.acceleration(time)};
}

const TimeFunction &function_of(const model::Model &model, std::size_t source) {
  return *model.sources()[source].function;
}

} // namespace

SourceTangent::SourceTangent(const model::Model &model, std::vector<Histories> neighbours,
                             Vector weights)
    : model_(model), neighbours_(std::move(neighbours)), weights_(std::move(weights)) {}

// A source without closed form belongs to its next piece at the break itself.
double SourceTangent::last_instant() const {
  return std::nextafter(to_, -std::numeric_limits<double>::infinity());
}

double SourceTangent::inside() const {
  return std::isinf(to_) ? from_ + 1 + 1e-3 * std::abs(from_) : 0.5 * (from_ + to_);
}

void SourceTangent::enter(double from, double to) {
  from_ = from;
  to_ = to;
  intervals_.assign(model_.sources().size(), {});
  for (std::size_t k = 0; k < intervals_.size(); ++k) {
    Interval &interval = intervals_[k];
    const TimeFunction &function = function_of(model_, k);
    interval.form = function.exponential_form(inside());
    for (std::size_t i = 0; i < neighbours_.size(); ++i) {
      const TimeFunction &near = *neighbours_[i][k];
      const bool periodic = function.period() > 0 && near.period() > 0;
      const double factor = periodic ? near.period() / function.period() : 1;
      interval.time_factors.push_back(factor);
      interval.stretch += weights_[static_cast<Index>(i)] * (1 / factor - 1);
      interval.neighbours.push_back(near.exponential_form(inside() * factor));
      if (interval.neighbours.back().has_value() != interval.form.has_value())
        throw NumericalError("a key that gives the excitation " + model_.sources()[k].name +
                             " another form has no derivative");
    }
    if (interval.form) {
      interval.changes = std::any_of(interval.neighbours.begin(), interval.neighbours.end(),
                                     [&](const std::optional<ExponentialForm> &near) {
                                       return !same_form(*interval.form, *near);
                                     });
      take_inputs(interval);
    }
  }
  find_input_generator();
  find_break_rate();
}

// A neighbour that already is in its next piece would be another function altogether.
void SourceTangent::find_break_rate() {
  break_rate_ = 0;
  if (std::isinf(to_))
    return;
  for (std::size_t k = 0; k < intervals_.size(); ++k) {
    if (function_of(model_, k).next_break(inside()) != to_)
      continue;
    double rate = 0;
    for (std::size_t i = 0; i < neighbours_.size(); ++i) {
      const double instant = neighbours_[i][k]->next_break(inside());
      if (!(std::abs(instant - to_) < 0.5 * (to_ - from_)))
        throw NumericalError("a break of the excitation " + model_.sources()[k].name + " at t = " +
                             std::to_string(to_) + " s moves too far with a key for a derivative");
      rate += weights_[static_cast<Index>(i)] * (instant - to_);
    }
    if (std::abs(rate) > std::abs(break_rate_))
      break_rate_ = rate;
  }
}

Values SourceTangent::value(std::size_t source, double time) const {
  const Interval &interval = intervals_[source];
  return values_of(function_of(model_, source), interval.form,
                   interval.form ? time : std::min(time, last_instant()));
}

Values SourceTangent::at(std::size_t source, double time) const {
  const Interval &interval = intervals_[source];
  if (!interval.changes)
    return {};
  const TimeFunction &function = function_of(model_, source);
  const double instant = interval.form ? time : std::min(time, last_instant());
  const Values own = values_of(function, interval.form, instant);
  Values change{};
  for (std::size_t i = 0; i < neighbours_.size(); ++i) {
    const Values near = values_of(*neighbours_[i][source], interval.neighbours[i],
                                  instant * interval.time_factors[i]);
    for (std::size_t m = 0; m < 3; ++m)
      change[m] += weights_[static_cast<Index>(i)] * (near[m] - own[m]);
  }
  if (interval.stretch == 0)
    return change;
  if (!interval.form)
    throw NumericalError("the excitation " + model_.sources()[source].name +
                         " has no closed form, which the derivative by its frequency needs");
  const double third = derivative(*interval.form).acceleration(instant);
  const double moved = instant * interval.stretch;
  return {change[0] + moved * own[1], change[1] + moved * own[2], change[2] + moved * third};
}

void SourceTangent::take_inputs(Interval &interval) const {
  interval.inputs.take({*interval.form});
  for (std::size_t i = 0; interval.changes && i < neighbours_.size(); ++i)
    interval.near_inputs.emplace_back().take({*interval.neighbours[i]});
}

// Behind the number 1, which every excitation begins with, those of one source after the other.
void SourceTangent::find_input_generator() {
  Index size = 1;
  same_inputs_ = true;
  for (const Interval &interval : intervals_) {
    same_inputs_ = same_inputs_ && interval.form;
    size += interval.inputs.size() - 1;
    for (const Excitation &near : interval.near_inputs)
      same_inputs_ = same_inputs_ && near.size() == interval.inputs.size();
  }
  if (!same_inputs_)
    return;
  Matrix change = Matrix::Zero(size, size);
  Index place = 1;
  for (const Interval &interval : intervals_) {
    const Index own_size = interval.inputs.size() - 1;
    const Matrix own = interval.inputs.generator();
    for (std::size_t i = 0; i < interval.near_inputs.size(); ++i)
      change.block(place, place, own_size, own_size) +=
          weights_[static_cast<Index>(i)] *
          (interval.near_inputs[i].generator() - own).bottomRightCorner(own_size, own_size);
    place += own_size;
  }
  if (change.size() == input_generator_.size() && change == input_generator_)
    return;
  input_generator_ = std::move(change);
  ++generation_;
}

const Matrix &SourceTangent::input_generator() const {
  if (!same_inputs_)
    throw NumericalError("a key that gives an excitation another form has no derivative");
  return input_generator_;
}

Vector SourceTangent::input_coordinates(double time) const {
  Vector change = Vector::Zero(input_generator().rows());
  std::vector<double> own;
  std::vector<double> near;
  Index place = 1;
  for (const Interval &interval : intervals_) {
    const Index size = interval.inputs.size();
    own.resize(static_cast<std::size_t>(size));
    near.resize(own.size());
    interval.inputs.coordinates(time, own.data());
    const Eigen::Map<const Vector> present(own.data(), size);
    auto into = change.segment(place, size - 1);
    for (std::size_t i = 0; i < interval.near_inputs.size(); ++i) {
      interval.near_inputs[i].coordinates(time * interval.time_factors[i], near.data());
      into += weights_[static_cast<Index>(i)] *
              (Eigen::Map<const Vector>(near.data(), size) - present).tail(size - 1);
    }
    if (interval.changes && interval.stretch != 0)
      into += time * interval.stretch * (interval.inputs.generator() * present).tail(size - 1);
    place += size - 1;
  }
  return change;
}

} // namespace vibroimpact::motion
