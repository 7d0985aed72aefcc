// Transforms and order amplitudes against signals whose Fourier series are known.
#include "common/fourier.h"

#include "analyses/signals/order_integrals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {
namespace fourier_tests {

constexpr double pi = std::numbers::pi;

std::vector<double> some_samples(std::size_t count) {
  std::vector<double> samples;
  for (std::size_t n = 0; n < count; ++n)
    samples.push_back(std::sin(1.7 * static_cast<double>(n * n)) + 0.3);
  return samples;
}

TEST(FourierTest, Parseval) {
  for (const std::size_t count : {64u, 75u}) {
    const std::vector<double> samples = some_samples(count);
    double energy = 0, lines = 0;
    for (const double x : samples)
      energy += x * x;
    const auto transform = forward_transform(samples);
    for (std::size_t j = 0; j < transform.size(); ++j)
      lines += (j == 0 || 2 * j == count ? 1 : 2) * std::norm(transform[j]);
    EXPECT_NEAR(lines / static_cast<double>(count), energy, 1e-12 * energy);
  }
}

TEST(FourierTest, InverseReturnsTheSamples) {
  const std::vector<double> samples = some_samples(30);
  const auto half = forward_transform(samples);
  std::vector<std::complex<double>> lines(samples.size());
  for (std::size_t j = 0; j < half.size(); ++j) {
    lines[j] = half[j];
    lines[(samples.size() - j) % samples.size()] = std::conj(half[j]);
  }
  const auto back = inverse_transform(lines);
  for (std::size_t n = 0; n < samples.size(); ++n)
    EXPECT_LT(std::abs(back[n] - samples[n]), 1e-14 * 10);
}

// Mean, a line in the middle and the highest line, with both windows.
TEST(FourierTest, AmplitudesOfSines) {
  const std::size_t count = 120;
  std::vector<double> samples;
  for (std::size_t n = 0; n < count; ++n) {
    const double t = 2 * pi * static_cast<double>(n) / static_cast<double>(count);
    samples.push_back(0.7 + 2.5 * std::sin(7 * t + 0.4) + 0.1 * std::cos(60 * t));
  }
  const auto plain = amplitude_spectrum(samples, taper("none", count));
  EXPECT_NEAR(plain[0], 0.7, 1e-13);
  EXPECT_NEAR(plain[7], 2.5, 1e-13);
  EXPECT_NEAR(plain[60], 0.1, 1e-13);
  EXPECT_NEAR(plain[8], 0, 1e-13);
  const auto hann = amplitude_spectrum(samples, taper("hann", count));
  EXPECT_NEAR(hann[7], 2.5, 1e-13);
  EXPECT_NEAR(hann[8], 1.25, 1e-13); // half of it leaks to each neighbour
  EXPECT_NEAR(hann[9], 0, 1e-13);
}

// The triangle wave of amplitude 1 has 8 / (pi j)^2 in odd orders; steps of unequal length, one of
// them so long that the highest order turns several times in it.
TEST(FourierTest, OrdersOfATriangleWave) {
  const double period = 0.7, origin = 3;
  OrderIntegrals orders(origin, 2 * pi / period, 9, 1);
  const std::vector<double> knots = {0, 0.11, 0.25, 0.3, 0.75, 1};
  for (std::size_t cycle = 0; cycle < 3; ++cycle)
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      const auto wave = [&](double tau) {
        const double phase = knots[i] + tau * (knots[i + 1] - knots[i]);
        return 0.2 + (phase < 0.25 ? 4 * phase : (phase < 0.75 ? 2 - 4 * phase : 4 * phase - 4));
      };
      // Where the wave has its corners, the rounded phase may fall on the wrong side: no matter,
      // it is continuous.
      orders.add(origin + (static_cast<double>(cycle) + knots[i]) * period,
                 (knots[i + 1] - knots[i]) * period, {wave});
    }
  EXPECT_NEAR(orders.mean(0), 0.2, 1e-12);
  for (std::size_t j = 1; j <= 9; ++j) {
    const auto order = static_cast<double>(j);
    EXPECT_NEAR(orders.amplitude(0, j), j % 2 ? 8 / (pi * pi * order * order) : 0, 1e-12);
  }
  EXPECT_NEAR(orders.phase(0, 1), -pi / 2, 1e-12); // begins like a sine
}

} // namespace fourier_tests
} // namespace vibroimpact::analyses
