#include "motion/interval/peak_force.h"

#include "common/zero.h"

#include <algorithm>
#include <array>

namespace vibroimpact::motion {

namespace {

constexpr int samples = 4; // intervals per step

// Around the largest sample: a maximum inside the interval next to an end shows in a difference
// that has shrunk to less than half of the one before (to a third, for a parabola).
bool may_peak_inside(const std::array<double, samples + 1> &values, int best) {
  if (best > 0 && best < samples)
    return true;
  const int next = best == 0 ? 1 : samples - 1;
  const int after = best == 0 ? 2 : samples - 2;
  return values[best] - values[next] < 0.5 * (values[next] - values[after]);
}

} // namespace

PeakForce sampled_peak(const std::function<double(double)> &force) {
  std::array<double, samples + 1> values{};
  for (int i = 0; i <= samples; ++i)
    values[i] = force(static_cast<double>(i) / samples);
  const auto best =
      static_cast<int>(std::max_element(values.begin(), values.end()) - values.begin());
  const PeakForce sample{.force = values[best], .tau = static_cast<double>(best) / samples};
  if (sample.force <= 0 || !may_peak_inside(values, best))
    return sample;
  const double lower = std::max(0, best - 1) / static_cast<double>(samples);
  const double upper = std::min(samples, best + 1) / static_cast<double>(samples);
  const Minimum minimum = minimum_between([&](double tau) { return -force(tau); }, lower, upper);
  return -minimum.value > sample.force ? PeakForce{-minimum.value, minimum.place} : sample;
}

PeakForce sampled_peak_force(const StepView &view, std::size_t contact) {
  const ContactCurves curves = view.contact_curves(contact);
  return sampled_peak([&](double tau) { return view.force(contact, curves, tau); });
}

double peak_force(const StepView &view, std::size_t contact) {
  const contact::Mode &mode = view.equations().mode(contact);
  return mode.affine ? view.indicator(contact, mode.affine->force).maximum()
                     : sampled_peak_force(view, contact).force;
}

} // namespace vibroimpact::motion
