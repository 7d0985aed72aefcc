#include "analyses/bilinear/bilinear_fields.h"

#include "analyses/recorders/observables.h"
#include "analyses/results/fields.h"
#include "common/fourier.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

namespace {

/// A displacement, or the gap, as a form of the state.
struct Signal {
  std::string path, unit, meaning;
  RowVector form;
};

std::vector<Signal> signals_of(const System &system, const TiedSystem &tied) {
  std::vector<Signal> signals;
  const ObservedSelection displacements{
      .points = {}, .kinds = {"displacement", "absolute_displacement", "rotation", "elongation"}};
  for (const Observable &observed : point_observables(system.model, displacements))
    signals.push_back({observed.path, observed.unit, observed.meaning,
                       tied.form(std::get<motion::PointForm>(observed.form).projection)});
  return signals;
}

void include(FormRange &range, const FormRange &other) {
  range.minimum = std::min(range.minimum, other.minimum);
  range.maximum = std::max(range.maximum, other.maximum);
}

void add_bounds(const FieldWriter &result, const Signal &signal, const FormRange &range) {
  result.number(signal.path + "/minimum", range.minimum, signal.unit, "smallest " + signal.meaning);
  result.number(signal.path + "/maximum", range.maximum, signal.unit, "largest " + signal.meaning);
}

void add_extremes(const FieldWriter &result, const TiedSystem &tied, const BilinearMotion &motion,
                  const std::vector<Signal> &signals, const std::string &contact,
                  std::size_t samples) {
  std::vector<RowVector> forms;
  for (const Signal &signal : signals)
    forms.push_back(signal.form);
  forms.push_back(tied.gap());
  std::vector<FormRange> all = ranges(tied, motion, forms, false, samples);
  const std::vector<FormRange> closed = ranges(tied, motion, forms, true, samples);
  for (std::size_t k = 0; k < all.size(); ++k)
    include(all[k], closed[k]);
  for (std::size_t k = 0; k < signals.size(); ++k) {
    result.number(signals[k].path + "/peak_to_peak", all[k].maximum - all[k].minimum,
                  signals[k].unit, "largest minus smallest " + signals[k].meaning);
    result.number(signals[k].path + "/amplitude", (all[k].maximum - all[k].minimum) / 2,
                  signals[k].unit, "half of the largest minus the smallest " + signals[k].meaning);
    add_bounds(result, signals[k], all[k]);
  }
  const std::string base = "contact/" + contact + "/";
  add_bounds(result, {.path = base + "gap", .unit = "m", .meaning = "gap", .form = {}}, all.back());
  const FormRange force = ranges(tied, motion, {tied.force()}, true, samples)[0];
  result.number(base + "normal_force/maximum", std::max(0.0, force.maximum), "N",
                "largest force of the tie, without the impulse of closing");
}

void add_character(const FieldWriter &result, const BilinearMotion &motion,
                   const std::string &contact, double angular_frequency) {
  const FieldWriter of = result.below("contact/" + contact + "/");
  of.number("contact_fraction", motion.contact_angle / full_turn, "1",
            "share of the period in contact");
  of.number("contact_time", motion.contact_angle / angular_frequency, "s",
            "time in contact in each period");
  of.number("impacts_per_period", motion.closes ? 1 : 0, "1", "closings in each period");
  of.number("closing_phase", motion.closing_phase, "rad", "phase of the excitation at closing");
  of.number("approach_speed/maximum", motion.approach_speed, "m/s", "rate of the gap at closing");
  result.number("largest_multiplier", motion.largest_multiplier, "1",
                "largest modulus of largest modulus of the multipliers: growth of small "
                "perturbations over a period");
  result.number("stable", motion.largest_multiplier < 1 ? 1 : 0, "1",
                "1 when the largest multiplier is smaller than 1");
}

/// At equal intervals over the period, its end included.
struct Samples {
  Vector angles;
  Matrix states;
};

Samples sampled(const TiedSystem &tied, const BilinearMotion &motion, std::size_t count) {
  Samples samples;
  samples.angles = Vector::LinSpaced(static_cast<Index>(count) + 1, 0, full_turn);
  samples.states = states_of(tied, motion, samples.angles);
  return samples;
}

std::vector<double> values(const Samples &samples, const RowVector &form) {
  const RowVector row = form * samples.states;
  return {row.begin(), row.end()};
}

void add_history(const FieldWriter &result, const TiedSystem &tied, const BilinearMotion &motion,
                 const Samples &samples, const std::vector<Signal> &signals,
                 const std::string &contact) {
  const auto add = [&](const std::string &name, std::vector<double> series, const std::string &unit,
                       const std::string &meaning) {
    result.series("history/" + name, "history_time", std::move(series), unit, meaning);
  };
  const Vector time = samples.angles / tied.angular_frequency();
  add("history_time", {time.begin(), time.end()}, "s", "time");
  for (const Signal &signal : signals)
    add(signal.path, values(samples, signal.form), signal.unit, signal.meaning);
  add("contact/" + contact + "/gap", values(samples, tied.gap()), "m", "gap");
  std::vector<double> force = values(samples, tied.force());
  for (std::size_t i = 0; i < force.size(); ++i)
    if (!is_closed(motion, samples.angles[static_cast<Index>(i)]))
      force[i] = 0;
  add("contact/" + contact + "/normal_force", std::move(force), "N",
      "normal force, > 0 pushes apart");
}

void add_orders(const FieldWriter &result, const Samples &samples, double frequency,
                const std::vector<Signal> &signals, std::size_t orders) {
  std::vector<double> order, line;
  for (std::size_t k = 0; k <= orders; ++k) {
    order.push_back(static_cast<double>(k));
    line.push_back(static_cast<double>(k) * frequency);
  }
  const auto series = [&](const std::string &name, const std::vector<double> &numbers,
                          const std::string &unit, const std::string &meaning) {
    result.series("spectrum/" + name, "spectrum_frequency", numbers, unit, meaning);
  };
  series("frequency", line, "Hz", "frequency of a line");
  series("order", order, "1", "frequency of a line over forcing frequency");
  for (const Signal &signal : signals) {
    std::vector<double> period = values(samples, signal.form);
    period.pop_back();
    std::vector<double> amplitude = amplitude_spectrum(period, taper("none", period.size()));
    amplitude.resize(orders + 1);
    series(signal.path, amplitude, signal.unit, "amplitude of the " + signal.meaning);
  }
}

} // namespace

void add_bilinear_motion(const FieldWriter &result, const System &system, const TiedSystem &tied,
                         const BilinearMotion &motion, std::size_t samples, std::size_t orders) {
  const std::string &contact = system.contacts.pairs()[0].name;
  const std::vector<Signal> signals = signals_of(system, tied);
  add_extremes(result, tied, motion, signals, contact, samples);
  add_character(result, motion, contact, tied.angular_frequency());
  const Samples over_period = sampled(tied, motion, samples);
  add_history(result, tied, motion, over_period, signals, contact);
  add_orders(result, over_period, tied.angular_frequency() / full_turn, signals, orders);
}

} // namespace vibroimpact::analyses
