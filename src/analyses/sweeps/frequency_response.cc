#include "analyses/sweeps/frequency_response.h"

#include "analyses/keys/keyed_system.h"
#include "analyses/keys/swept_parameter.h"
#include "analyses/recorders/observables.h"
#include "analyses/results/fields.h"
#include "analyses/run/single_point.h"
#include "common/error.h"
#include "common/zero.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace vibroimpact::analyses {

namespace {

constexpr const char *frequency_response_section = "Frequency response";

std::complex<double> amplitude(const LinearResponse &response, const Observable &quantity,
                               const ComplexAmplitudes &at) {
  const std::complex<double> rate(0, at.angular_frequency);
  const auto &form = std::get<motion::PointForm>(quantity.form);
  std::complex<double> value = response.observed(form.projection, at);
  for (int k = 0; k < form.order; ++k)
    value *= rate;
  return value;
}

struct Peak {
  double value = 0;
  double frequency = 0; ///< [Hz]
};

// The largest listed value, or a larger one between its neighbours.
Peak find_peak(const std::vector<double> &frequencies, const std::vector<double> &values,
               const std::function<double(double)> &value_at) {
  const auto largest = std::max_element(values.begin(), values.end());
  const auto place = static_cast<std::size_t>(largest - values.begin());
  const Peak listed{.value = *largest, .frequency = frequencies[place]};
  if (place == 0 || place + 1 == values.size())
    return listed;
  const auto [frequency, negative] = minimum_between(
      [&](double f) { return -value_at(f); }, frequencies[place - 1], frequencies[place + 1]);
  return -negative > listed.value ? Peak{.value = -negative, .frequency = frequency} : listed;
}

void add_peak(const FieldWriter &result, const Observable &quantity, const Peak &peak) {
  const std::string path = "peak/" + quantity.path;
  result.number(path + "/amplitude", peak.value, quantity.unit,
                "largest amplitude over frequency, " + quantity.meaning);
  result.line(path, peak.value, quantity.unit);
  result.listed().number(path + "/frequency", peak.frequency, "Hz",
                         "frequency of the largest amplitude");
}

} // namespace

void FrequencyResponse::declare(parameters::Section &analysis) {
  using namespace parameters;
  analysis
      .subsection(frequency_response_section,
                  "Exact steady response of the linear model to a harmonic "
                  "excitation, as if no contact could close, or some could not open.")
      .quantity("First frequency", "", dimension::frequency, range::positive, "f_1",
                "Lowest frequency.")
      .required()
      .quantity("Last frequency", "", dimension::frequency, range::positive, "f_2",
                "Highest frequency.")
      .required()
      .integer("Points", "200", Range{.lower = 1, .upper = 1e6}, "", "Number of frequencies.")
      .choice("Spacing", "linear", {"linear", "logarithmic"}, "How the frequencies are spaced.")
      .text("Excitation", "",
            "Excitation whose response is computed; empty when only one has a period. The others "
            "do not act.");
  declare_tied_contacts(analysis.subsection(frequency_response_section, ""));
}

std::shared_ptr<const Analysis> FrequencyResponse::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(frequency_response_section);
  return std::make_shared<FrequencyResponse>(Settings{.frequencies = read_frequencies(values),
                                                      .excitation = values.text("Excitation"),
                                                      .tied = read_tied_contacts(values)});
}

LinearResponse FrequencyResponse::response(const System &system) const {
  return {system.model, sweep_source(system, settings_.excitation),
          settings_.tied ? settings_.tied(system) : std::vector<model::Projection>{}};
}

void FrequencyResponse::check(const System &system) const { response(system); }

PointResult FrequencyResponse::compute(const System &system, LineContext &context) const {
  const LinearResponse response = this->response(system);
  const auto at = [&](double frequency) { return response.at(2 * std::numbers::pi * frequency); };
  std::vector<ComplexAmplitudes> motions;
  const auto share = [&] {
    return static_cast<double>(motions.size()) / static_cast<double>(settings_.frequencies.size());
  };
  for (const double frequency : settings_.frequencies) {
    motions.push_back(at(frequency));
    context.note_progress(share() / 2); // the other half goes into the quantities
  }
  PointResult point;
  const FieldWriter result(point);
  result.series("frequency", "frequency", settings_.frequencies, "Hz", "excitation frequency");
  for (const Observable &quantity : point_observables(system.model, {}, true)) {
    std::vector<double> amplitudes, phases;
    for (const ComplexAmplitudes &motion : motions) {
      const std::complex<double> value = amplitude(response, quantity, motion);
      amplitudes.push_back(std::abs(value));
      phases.push_back(std::arg(value));
    }
    add_peak(result, quantity, find_peak(settings_.frequencies, amplitudes, [&](double frequency) {
               return std::abs(amplitude(response, quantity, at(frequency)));
             }));
    result.series(quantity.path + "/amplitude", "frequency", amplitudes, quantity.unit,
                  "amplitude, " + quantity.meaning);
    result.series(quantity.path + "/phase", "frequency", phases, "rad",
                  "phase of the sine, " + quantity.meaning);
  }
  return point;
}

void FrequencyResponse::run_line(std::size_t /*line*/, System &system, LineContext &context) const {
  run_single_point(context, [&] { return compute(system, context); });
}

} // namespace vibroimpact::analyses
