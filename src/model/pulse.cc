#include "model/pulse.h"

#include "model/piecewise_function.h"

#include <numbers>
#include <utility>

namespace vibroimpact::model {

using std::numbers::pi;

int smoothness(PulseShape shape) {
  if (shape == PulseShape::rectangular)
    return 0;
  return shape == PulseShape::versed_sine ? 2 : 1;
}

double area_factor(PulseShape shape) {
  if (shape == PulseShape::rectangular)
    return 1;
  return shape == PulseShape::half_sine ? 2 / pi : 0.5;
}

namespace {

ExponentialForm polynomial(double origin, std::vector<double> coefficients) {
  return {.origin = origin, .terms = {}, .polynomial = std::move(coefficients)};
}

ExponentialForm single_form(PulseShape shape, double peak, double start, double duration) {
  if (shape == PulseShape::half_sine)
    return {.origin = start,
            .terms = {{.amplitude = {0, -peak}, .exponent = {0, pi / duration}}},
            .polynomial = {}};
  if (shape == PulseShape::versed_sine)
    return {.origin = start,
            .terms = {{.amplitude = -peak / 2, .exponent = {0, 2 * pi / duration}}},
            .polynomial = {peak / 2}};
  return polynomial(start, {peak});
}

Pieces pulse_pieces(PulseShape shape, double peak, double start, double duration) {
  const double end = start + duration;
  if (shape != PulseShape::triangular)
    return {.breaks = {start, end},
            .forms = {polynomial(start, {}), single_form(shape, peak, start, duration),
                      polynomial(end, {})}};
  const double top = start + duration / 2;
  const double slope = 2 * peak / duration;
  return {.breaks = {start, top, end},
          .forms = {polynomial(start, {}), polynomial(start, {0, slope}),
                    polynomial(top, {peak, -slope}), polynomial(end, {})}};
}

} // namespace

std::shared_ptr<const TimeFunction> make_pulse(Given given, PulseShape shape, double peak,
                                               double start, double duration) {
  return std::make_shared<PiecewiseFunction>(given, pulse_pieces(shape, peak, start, duration),
                                             2 * pi / duration);
}

void declare_pulse(parameters::Section &excitation) {
  using namespace parameters;
  excitation
      .subsection("Impulse", "One pulse; the given quantity is zero before and after. Its peak is "
                             "the Amplitude, or follows from Impulse.")
      .choice("Shape", "half sine", {"half sine", "rectangular", "triangular", "versed sine"},
              "A versed sine is (1 - cos) / 2 over a full turn. A base velocity cannot be "
              "rectangular, a base displacement must be a versed sine.")
      .quantity("Start", "0 s", dimension::time, range::any, "t_0", "When it begins.")
      .quantity("Duration", "", dimension::time, range::positive, "T", "How long it lasts.")
      .required("History = impulse")
      .quantity("Impulse", "", dimension::any, range::any, "I",
                "Integral of the given quantity over the pulse, for example N s. Either this or "
                "Amplitude.");
}

namespace {

PulseShape read_shape(const parameters::Values &pulse, const HistoryContext &context) {
  const std::string name = pulse.choice("Shape");
  const PulseShape shape = name == "rectangular"  ? PulseShape::rectangular
                           : name == "triangular" ? PulseShape::triangular
                           : name == "half sine"  ? PulseShape::half_sine
                                                  : PulseShape::versed_sine;
  const int needed = !context.moves_base                    ? 0
                     : context.given == Given::displacement ? 2
                     : context.given == Given::velocity     ? 1
                                                            : 0;
  if (smoothness(shape) < needed)
    pulse.reject("Shape", "a " + context.type +
                              " of this shape would need an infinite "
                              "acceleration; choose versed sine" +
                              (needed == 1 ? ", half sine or triangular" : ""));
  return shape;
}

} // namespace

TimeFunctionPointer create_pulse(const parameters::Values &excitation,
                                 const HistoryContext &context) {
  const parameters::Values pulse = excitation.subsection("Impulse");
  pulse.require("Duration");
  const double duration = pulse.quantity("Duration");
  const PulseShape shape = read_shape(pulse, context);
  if (pulse.has("Impulse") == excitation.has("Amplitude"))
    pulse.reject("Impulse", "Impulse or Amplitude (the peak) must be given, and not both");
  parameters::Dimension integral = context.dimension;
  integral.time += 1;
  const double peak =
      excitation.has("Amplitude")
          ? excitation.quantity_of("Amplitude", context.dimension)
          : pulse.quantity_of("Impulse", integral) / (area_factor(shape) * duration);
  return make_pulse(context.given, shape, peak, pulse.quantity("Start"), duration);
}

} // namespace vibroimpact::model
