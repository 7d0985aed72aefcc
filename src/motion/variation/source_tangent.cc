#include "motion/variation/source_tangent.h"

#include "common/error.h"

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

Values values_of(const TimeFunction &function, const std::optional<ExponentialForm> &form,
                 double time) {
  if (form)
    return {form->value(time), form->rate(time), form->acceleration(time)};
  return {function.value(time), function.rate(time), function.acceleration(time)};
}

const TimeFunction &function_of(const model::Model &model, std::size_t source) {
  return *model.sources()[source].function;
}

// Of a list with the closed forms about `time`; its coordinates there.
Vector coordinates_at(double time, const Excitation &excitation) {
  Vector coordinates(excitation.size());
  excitation.coordinates(time, coordinates.data());
  return coordinates;
}

} // namespace

Matrix generator_of(const Excitation &excitation) {
  Matrix generator = Matrix::Zero(excitation.size(), excitation.size());
  Index place = 0;
  for (const Input &input : excitation.inputs()) {
    if (input.kind == Input::Kind::exponential) {
      generator(place, place) = input.exponent.real();
      if (input.is_pair())
        generator.block(place, place, 2, 2) = pair_generator(input.exponent);
    } else if (input.kind == Input::Kind::polynomial) {
      for (Index j = 0; j < input.degree; ++j)
        generator(place + j, place + j + 1) = 1;
    }
    place += input.size();
  }
  return generator;
}

SourceTangent::SourceTangent(const model::Model &model,
                             std::vector<const model::Model *> neighbours, Vector weights)
    : model_(model), neighbours_(std::move(neighbours)), weights_(std::move(weights)) {}

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
      const TimeFunction &near = function_of(*neighbours_[i], k);
      const bool periodic = function.period() > 0 && near.period() > 0;
      const double factor = periodic ? near.period() / function.period() : 1;
      interval.time_factors.push_back(factor);
      interval.stretch += weights_[static_cast<Index>(i)] * (1 / factor - 1);
      interval.neighbours.push_back(near.exponential_form(inside() * factor));
      if (interval.neighbours.back().has_value() != interval.form.has_value())
        throw NumericalError("a key that gives the excitation " + model_.sources()[k].name +
                             " another form has no derivative");
    }
  }
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
      const double instant = function_of(*neighbours_[i], k).next_break(inside());
      if (!(std::abs(instant - to_) < 0.5 * (to_ - from_)))
        throw NumericalError("a break of the excitation " + model_.sources()[k].name + " at t = " +
                             std::to_string(to_) + " s moves too far with a key for a derivative");
      rate += weights_[static_cast<Index>(i)] * (instant - to_);
    }
    if (std::abs(rate) > std::abs(break_rate_))
      break_rate_ = rate;
  }
}

Values SourceTangent::at(std::size_t source, double time) const {
  const Interval &interval = intervals_[source];
  const TimeFunction &function = function_of(model_, source);
  const double last = std::nextafter(to_, -std::numeric_limits<double>::infinity());
  const double instant = interval.form ? time : std::min(time, last);
  const Values own = values_of(function, interval.form, instant);
  Values change{};
  for (std::size_t i = 0; i < neighbours_.size(); ++i) {
    const Values near = values_of(function_of(*neighbours_[i], source), interval.neighbours[i],
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

SourceTangent::InputTangent SourceTangent::inputs(double time, const Excitation &excitation,
                                                  const Matrix &generator) const {
  const Vector own = coordinates_at(time, excitation);
  InputTangent tangent{.generator = Matrix::Zero(own.size(), own.size()),
                       .coordinates = Vector::Zero(own.size())};
  for (std::size_t i = 0; i < neighbours_.size(); ++i) {
    std::vector<ExponentialForm> forms;
    for (const Interval &interval : intervals_) {
      forms.push_back(interval.neighbours[i]->about(time * interval.time_factors[i]));
      forms.back().origin = time; // the same phase at the same instant
    }
    Excitation near;
    near.take(forms);
    if (near.size() != own.size())
      throw NumericalError("a key that gives an excitation another form has no derivative");
    tangent.generator += weights_[static_cast<Index>(i)] * (generator_of(near) - generator);
    tangent.coordinates += weights_[static_cast<Index>(i)] * (coordinates_at(time, near) - own);
  }
  const Vector rates = generator * own;
  Index place = 0;
  for (const Input &input : excitation.inputs()) {
    if (input.kind != Input::Kind::one)
      tangent.coordinates.segment(place, input.size()) +=
          time * intervals_[input.source].stretch * rates.segment(place, input.size());
    place += input.size();
  }
  return tangent;
}

} // namespace vibroimpact::motion
