#include "model/sine_sweep.h"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact::model {

namespace {

int sweep_integrations(Given given) {
  return given == Given::displacement ? 0 : given == Given::velocity ? 1 : 2;
}

// The smooth step u^3 (10 - 15 u + 6 u^2) over `length`, with two derivatives by time.
std::array<double, 3> smooth_step(double elapsed, double length) {
  if (!(elapsed < length))
    return {1, 0, 0};
  const double u = elapsed / length;
  return {u * u * u * (10 + u * (6 * u - 15)), 30 * u * u * (1 - u) * (1 - u) / length,
          60 * u * (1 - u) * (1 - 2 * u) / (length * length)};
}

// Value, first and second derivative of the envelope.
std::array<double, 3> envelope(const SweepDefinition &definition, double time) {
  const double remaining = definition.duration - time;
  if (remaining < definition.fade_out) {
    const auto [value, rate, acceleration] = smooth_step(remaining, definition.fade_out);
    return {value, -rate, acceleration};
  }
  return smooth_step(time, definition.fade_in);
}

void sort_out(std::vector<double> &instants) {
  std::sort(instants.begin(), instants.end());
  instants.erase(std::unique(instants.begin(), instants.end()), instants.end());
}

} // namespace

SineSweep::SineSweep(const SweepDefinition &definition)
    : definition_(definition),
      growth_((definition.logarithmic ? std::log(definition.to / definition.from)
                                      : definition.to - definition.from) /
              definition.duration),
      breaks_{0, definition.fade_in, definition.duration - definition.fade_out,
              definition.duration} {
  if (growth_ == 0)
    definition_.logarithmic = false; // both laws are the same constant
  sort_out(breaks_);
  if (sweep_integrations(definition.given) > 0) {
    make_cells();
    choose_constants();
  }
  continue_outside();
}

double SineSweep::frequency(double time) const {
  return definition_.logarithmic ? definition_.from * std::exp(growth_ * time)
                                 : definition_.from + growth_ * time;
}

double SineSweep::phase(double time) const {
  const double advance = definition_.logarithmic
                             ? definition_.from * std::expm1(growth_ * time) / growth_
                             : (definition_.from + 0.5 * growth_ * time) * time;
  return definition_.phase + advance;
}

double SineSweep::time_of_advance(double advance) const {
  if (definition_.logarithmic)
    return std::log1p(growth_ * advance / definition_.from) / growth_;
  const double square = definition_.from * definition_.from + 2 * growth_ * advance;
  return 2 * advance / (definition_.from + std::sqrt(std::max(0.0, square)));
}

double SineSweep::given(int order, double time) const {
  const double angle = phase(time);
  const double sine = std::sin(angle);
  const auto [w, w_rate, w_acceleration] = envelope(definition_, time);
  if (order == 0)
    return definition_.amplitude * w * sine;
  const double omega = frequency(time);
  const double cosine = std::cos(angle);
  if (order == 1)
    return definition_.amplitude * (w_rate * sine + w * omega * cosine);
  const double omega_rate = definition_.logarithmic ? growth_ * omega : growth_;
  return definition_.amplitude * ((w_acceleration - w * omega * omega) * sine +
                                  (2 * w_rate * omega + w * omega_rate) * cosine);
}

// Cells of an eighth of a period, and of a 64th of the sweep where that is shorter, so that the
// quadrature is exact to rounding; no break lies inside one.
void SineSweep::make_cells() {
  cells_ = breaks_;
  constexpr int parts = 64;
  for (int i = 1; i < parts; ++i)
    cells_.push_back(definition_.duration * i / parts);
  const double total = phase(definition_.duration) - definition_.phase;
  constexpr double advance = std::numbers::pi / 4;
  for (double i = 1; i * advance < total; ++i)
    cells_.push_back(std::min(time_of_advance(i * advance), definition_.duration));
  sort_out(cells_);
  first_.push_back(0);
  second_.push_back(0);
  for (std::size_t i = 1; i < cells_.size(); ++i) {
    const double once = integral(1, cells_[i]);
    const double twice = integral(2, cells_[i]);
    first_.push_back(once);
    second_.push_back(twice);
  }
}

// Once or twice from 0, without constants. Uses the cells that are there, so that the next edge can
// be computed from the ones before.
double SineSweep::integral(int times, double time) const {
  const auto above = std::upper_bound(cells_.begin(), cells_.end(), time) - cells_.begin();
  const std::size_t cell = std::min(static_cast<std::size_t>(above) - 1, first_.size() - 1);
  const double begin = cells_[cell];
  const double length = time - begin;
  const double start = times == 1 ? first_[cell] : second_[cell] + first_[cell] * length;
  if (length <= 0)
    return start;
  const auto integrand = [&](double t) {
    return times == 1 ? given(0, t) : (time - t) * given(0, t);
  };
  return start + boost::math::quadrature::gauss<double, 7>::integrate(integrand, begin, time);
}

double SineSweep::harmonic_displacement(double time) const {
  const double a = definition_.amplitude * envelope(definition_, time)[0];
  const double omega = frequency(time);
  return definition_.given == Given::velocity ? -a * std::cos(phase(time)) / omega
                                              : -a * std::sin(phase(time)) / (omega * omega);
}

void SineSweep::choose_constants() {
  const double end = definition_.duration;
  if (definition_.given == Given::velocity) {
    constant_ = harmonic_displacement(end) - integral(1, end);
  } else {
    constant_ = harmonic_displacement(0);
    velocity_constant_ = (harmonic_displacement(end) - constant_ - integral(2, end)) / end;
  }
}

void SineSweep::continue_outside() {
  const double end = definition_.duration;
  const int times = sweep_integrations(definition_.given);
  std::array<double, 2> at_start{};
  std::array<double, 2> at_end{};
  for (int order = 0; order < times; ++order) {
    at_start[order] = during(order, 0);
    at_end[order] = during(order, end);
  }
  before_ = {.origin = 0, .terms = {}, .polynomial = {}};
  after_ = {.origin = end, .terms = {}, .polynomial = {}};
  if (definition_.hold) {
    const std::complex<double> at_once = std::polar(1.0, phase(end));
    after_.terms = {
        {.amplitude = definition_.amplitude * std::complex<double>(at_once.imag(), -at_once.real()),
         .exponent = {0, frequency(end)}}};
  }
  for (int order = times; order-- > 0;) {
    before_ = before_.integral(at_start[order]);
    after_ = after_.integral(at_end[order]);
  }
}

double SineSweep::derivative(int order, double time) const {
  if (time >= 0 && time < definition_.duration)
    return during(order, time);
  const ExponentialForm &form = time < 0 ? before_ : after_;
  return order == 0 ? form.value(time) : order == 1 ? form.rate(time) : form.acceleration(time);
}

double SineSweep::during(int order, double time) const {
  const int times = sweep_integrations(definition_.given) - order;
  if (times <= 0)
    return given(-times, time);
  if (times == 2)
    return constant_ + velocity_constant_ * time + integral(2, time);
  return (definition_.given == Given::velocity ? constant_ : velocity_constant_) +
         integral(1, time);
}

double SineSweep::highest_frequency() const { return std::max(definition_.from, definition_.to); }

double SineSweep::next_break(double time) const {
  const auto next = std::upper_bound(breaks_.begin(), breaks_.end(), time);
  return next == breaks_.end() ? std::numeric_limits<double>::infinity() : *next;
}

std::optional<ExponentialForm> SineSweep::exponential_form(double time) const {
  if (time < 0)
    return before_.about(time);
  if (time >= definition_.duration)
    return after_.about(time);
  return std::nullopt;
}

void SineSweep::declare(parameters::Section &excitation) {
  using namespace parameters;
  excitation
      .subsection("Sine sweep", "A sine of constant amplitude whose frequency runs from one value "
                                "to another, from t = 0 on.")
      .quantity("From", "", dimension::frequency, range::positive, "f_1", "First frequency.")
      .required("History = sine sweep")
      .quantity("To", "", dimension::frequency, range::positive, "f_2", "Last frequency.")
      .required("History = sine sweep")
      .quantity("Duration", "", dimension::time, range::positive, "T", "Of the way between them.")
      .required("History = sine sweep")
      .choice("Law", "linear", {"linear", "logarithmic"},
              "The frequency changes by equal steps, or by equal factors, in equal times.")
      .choice("After", "hold", {"hold", "stop"},
              "What follows: a harmonic of the last frequency, or nothing.")
      .quantity("Fade-in", "0 s", dimension::time, range::non_negative, "",
                "Time in which the amplitude rises smoothly from zero.")
      .quantity("Fade-out", "0 s", dimension::time, range::non_negative, "",
                "Time in which it falls smoothly to zero at the end, for After = stop.");
}

namespace {

SweepDefinition read_sweep(const parameters::Values &excitation, const HistoryContext &context) {
  const parameters::Values sweep = excitation.subsection("Sine sweep");
  excitation.require("Amplitude");
  for (const char *key : {"From", "To", "Duration"})
    sweep.require(key);
  return {.given = context.given,
          .amplitude = excitation.quantity_of("Amplitude", context.dimension),
          .phase = excitation.quantity("Phase"),
          .from = sweep.quantity("From"),
          .to = sweep.quantity("To"),
          .duration = sweep.quantity("Duration"),
          .logarithmic = sweep.choice("Law") == "logarithmic",
          .hold = sweep.choice("After") == "hold",
          .fade_in = sweep.quantity("Fade-in"),
          .fade_out = sweep.quantity("Fade-out")};
}

} // namespace

TimeFunctionPointer SineSweep::create(const parameters::Values &excitation,
                                      const HistoryContext &context) {
  const SweepDefinition definition = read_sweep(excitation, context);
  const parameters::Values sweep = excitation.subsection("Sine sweep");
  if (definition.hold && definition.fade_out > 0)
    sweep.reject("Fade-out", "Fade-out must not be set when After = hold; it needs After = stop");
  if (definition.fade_in + definition.fade_out > definition.duration)
    sweep.reject("Fade-in", "Fade-in and Fade-out together must not be longer than Duration");
  const bool jumps = context.moves_base && definition.given != Given::acceleration;
  if (jumps && !definition.hold && definition.fade_out == 0)
    sweep.reject("After", "a " + context.type +
                              " that stops at once would need an infinite acceleration; give a "
                              "Fade-out");
  return std::make_shared<SineSweep>(definition);
}

} // namespace vibroimpact::model
