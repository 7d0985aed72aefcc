// The wavelet transform on sines and on a swept sine.
#include "analyses/signals/wavelet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {
namespace wavelet_tests {

constexpr double pi = std::numbers::pi;

const Wavelet wavelets[] = {Wavelet::bump(5, 0.6), Wavelet::morlet(6)};

TEST(WaveletTest, ASineShowsItsAmplitudeAndPhaseOnItsRidge) {
  const double interval = 0.002, frequency = 11, amplitude = 1.7;
  std::vector<double> samples;
  for (int n = 0; n < 20000; ++n)
    samples.push_back(amplitude * std::cos(2 * pi * frequency * n * interval + 0.5));
  for (const Wavelet &wavelet : wavelets) {
    const WaveletTransform transform(wavelet, samples, interval, 5);
    const auto ridge = transform.at(frequency);
    EXPECT_NEAR(std::abs(ridge[10000]), amplitude, 1e-6);
    EXPECT_NEAR(std::arg(ridge[10000] * std::polar(1.0, -2 * pi * frequency * 10000 * interval)),
                0.5, 1e-6);
    for (const double factor : {1.1, 3.0}) // off the ridge what the filter passes
      EXPECT_NEAR(std::abs(transform.at(factor * frequency)[10000]),
                  amplitude * wavelet.response(1 / factor) / 2, 1e-6);
  }
}

// The envelope of the Morlet wavelet is exp(-(2 pi t / mu)^2 / 2), t in periods.
TEST(WaveletTest, DecayOfTheMorletWavelet) {
  EXPECT_NEAR(Wavelet::morlet(6).decay_periods(), std::sqrt(2.0) * 6 / (2 * pi), 1e-6);
  const double bump = Wavelet::bump(5, 0.6).decay_periods();
  EXPECT_GT(bump, 2);
  EXPECT_LT(bump, 8);
}

// f(t) = f0 + r t: the ridge is at the instantaneous frequency.
TEST(WaveletTest, RidgeOfAChirpFollowsItsFrequency) {
  const double interval = 0.002, first = 10, rate = 0.5;
  std::vector<double> samples;
  for (int n = 0; n < 16000; ++n) {
    const double t = n * interval;
    samples.push_back(std::sin(2 * pi * (first + 0.5 * rate * t) * t));
  }
  for (const Wavelet &wavelet : wavelets) {
    const WaveletTransform transform(wavelet, samples, interval, 8);
    std::vector<double> best(samples.size(), 0), ridge(samples.size(), 0);
    for (double frequency = 11; frequency < 27; frequency *= 1.004) {
      const auto row = transform.at(frequency);
      for (std::size_t n = 0; n < row.size(); ++n)
        if (std::abs(row[n]) > best[n]) {
          best[n] = std::abs(row[n]);
          ridge[n] = frequency;
        }
    }
    for (std::size_t n = 4000; n < 13000; n += 1000) {
      const double instantaneous = first + rate * static_cast<double>(n) * interval;
      EXPECT_NEAR(ridge[n] / instantaneous, 1, 0.01);
      EXPECT_NEAR(best[n], 1, 0.03);
    }
  }
}

// A burst at the end of a record of 2^n samples does not show at its beginning: in a transform that
// closed the record to a ring the two would be neighbours.
TEST(WaveletTest, TheEndOfTheRecordDoesNotShowAtItsBeginning) {
  constexpr double interval = 0.002, frequency = 10;
  std::vector<double> samples(2048, 0);
  for (std::size_t n = 1748; n < samples.size(); ++n)
    samples[n] = std::sin(2 * pi * frequency * static_cast<double>(n) * interval);
  for (const Wavelet &wavelet : wavelets) {
    const auto ridge = WaveletTransform(wavelet, samples, interval, 8).at(frequency);
    EXPECT_GT(std::abs(ridge[1950]), 0.3);
    EXPECT_LT(std::abs(ridge[0]), 0.01);
    EXPECT_LT(std::abs(ridge[100]), 0.01);
  }
}

TEST(WaveletTest, ShortTimeAmplitudes) {
  std::vector<double> samples;
  for (int n = 0; n < 1000; ++n)
    samples.push_back(n < 500 ? 2 * std::sin(2 * pi * n / 20) : 3 * std::sin(2 * pi * n / 10));
  const auto early = short_time_amplitudes(samples, 250, 200);
  EXPECT_NEAR(early[10], 2, 1e-12);
  EXPECT_NEAR(early[20], 0, 1e-12);
  const auto late = short_time_amplitudes(samples, 750, 200);
  EXPECT_NEAR(late[10], 0, 1e-12);
  EXPECT_NEAR(late[20], 3, 1e-12);
  EXPECT_NEAR(short_time_amplitudes(samples, 0, 200)[10], 1, 0.05); // half the stretch is there
}

} // namespace wavelet_tests
} // namespace vibroimpact::analyses
