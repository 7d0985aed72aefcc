#include "motion/interval/extremum.h"

#include "common/zero.h"

#include <algorithm>
#include <array>

namespace vibroimpact::motion {

namespace {

constexpr int step_samples = 32;  // intervals of a step; polynomials are of degree nine at most
constexpr double close_by = 1e-3; // of a step

struct Largest {
  double tau = 0, value = 0;
};

template <class Curve> Largest largest_of(const Curve &curve) {
  std::array<double, step_samples + 1> values{};
  for (int i = 0; i <= step_samples; ++i)
    values[static_cast<std::size_t>(i)] = curve(static_cast<double>(i) / step_samples);
  const auto best = std::max_element(values.begin(), values.end()) - values.begin();
  const double middle = static_cast<double>(best) / step_samples, width = 1.0 / step_samples;
  const Minimum inside =
      minimum_between([&](double tau) { return -curve(tau); }, std::max(0.0, middle - width),
                      std::min(1.0, middle + width));
  const double at_sample = values[static_cast<std::size_t>(best)];
  if (-inside.value > at_sample)
    return {inside.place, -inside.value};
  return {middle, at_sample};
}

// Values are equal to half of their digits within 1e-8 of their maximum; its slope has a simple
// zero.
double sharpened(const Bernstein &curve, double tau) {
  const Bernstein slope = curve.derivative(), curvature = slope.derivative();
  for (int i = 0; i < 3; ++i)
    if (const double change = -slope(tau) / curvature(tau); std::abs(change) < 1e-6)
      tau = std::clamp(tau + change, 0.0, 1.0);
  return tau;
}

void keep(Extremum &extremum, const StepView &view, const Largest &found) {
  using Side = Extremum::Side;
  if (!(found.value > extremum.value))
    return;
  const double time = found.tau == 1 ? view.end() : view.start() + found.tau * view.length();
  const double aside = (found.tau > 0.5 ? -close_by : close_by) * view.length();
  extremum = {.value = found.value,
              .time = time,
              .beside = time + aside,
              .side = found.tau == 0   ? Side::start
                      : found.tau == 1 ? Side::end
                                       : Side::inside};
}

} // namespace

void Extremum::include(const StepView &view, const Bernstein &curve) {
  if (!(curve.maximum() > value))
    return;
  Largest found = largest_of(curve);
  if (found.tau > 0 && found.tau < 1)
    found.tau = sharpened(curve, found.tau);
  keep(*this, view, found);
}

void Extremum::include_force(const StepView &view, std::size_t contact) {
  if (const contact::Mode &mode = view.equations().mode(contact); mode.affine)
    return include(view, view.indicator(contact, mode.affine->force));
  const ContactCurves curves = view.contact_curves(contact);
  keep(*this, view, largest_of([&](double tau) { return view.force(contact, curves, tau); }));
}

} // namespace vibroimpact::motion
