#include "model/ramped_harmonic.h"

#include <numbers>

namespace vibroimpact::model {

namespace {

Pieces ramped(Given given, double amplitude, double omega, double phase, double ramp_rate) {
  const int integrations = given == Given::displacement ? 0 : given == Given::velocity ? 1 : 2;
  const std::complex<double> c = std::complex<double>(0, -amplitude) * std::polar(1.0, phase);
  ExponentialForm after{.origin = 0,
                        .terms = {{.amplitude = c, .exponent = {0, omega}},
                                  {.amplitude = -c, .exponent = {-ramp_rate, omega}}},
                        .polynomial = {}};
  for (ExponentialForm::Term &term : after.terms)
    for (int i = 0; i < integrations; ++i)
      term.amplitude /= term.exponent;
  ExponentialForm before;
  if (integrations > 0)
    before.polynomial = {after.value(0), integrations == 2 ? after.rate(0) : 0};
  return {.breaks = {0}, .forms = {std::move(before), std::move(after)}};
}

} // namespace

RampedHarmonic::RampedHarmonic(Given given, double amplitude, double angular_frequency,
                               double phase, double ramp_rate)
    : PiecewiseFunction(ramped(given, amplitude, angular_frequency, phase, ramp_rate),
                        angular_frequency),
      given_(given), amplitude_(amplitude), phase_(phase), ramp_rate_(ramp_rate) {}

void RampedHarmonic::declare(parameters::Section &excitation) {
  using namespace parameters;
  excitation
      .subsection("Ramp", "Start of a ramped harmonic: amplitude (1 - exp(-rate t)) "
                          "sin(frequency t + phase) from t = 0 on.")
      .quantity("Rate", "", dimension::inverse_time, range::positive, "\\alpha",
                "Inverse of the time in which all but 1/e of the amplitude is reached.")
      .required("History = ramped harmonic");
}

TimeFunctionPointer RampedHarmonic::create(const parameters::Values &excitation,
                                           const HistoryContext &context) {
  const parameters::Values ramp = excitation.subsection("Ramp");
  for (const char *key : {"Amplitude", "Frequency"})
    excitation.require(key);
  ramp.require("Rate");
  return std::make_shared<RampedHarmonic>(
      context.given, excitation.quantity_of("Amplitude", context.dimension),
      excitation.quantity("Frequency"), excitation.quantity("Phase"), ramp.quantity("Rate"));
}

double RampedHarmonic::period() const { return 2 * std::numbers::pi / highest_frequency(); }

std::shared_ptr<const TimeFunction> RampedHarmonic::with_frequency(double angular_frequency) const {
  return std::make_shared<RampedHarmonic>(given_, amplitude_, angular_frequency, phase_,
                                          ramp_rate_);
}

} // namespace vibroimpact::model
