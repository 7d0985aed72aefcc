// Random histories: variance, spectrum, distribution and coherence of their amplitudes, envelope,
// and what they depend on.
#include "model/random_history.h"

#include "common/fourier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace vibroimpact::model {
namespace random_history_tests {

constexpr double pi = std::numbers::pi;

RandomDefinition definition() {
  return {.density = [](double omega) { return 3 / (1 + omega); },
          .lowest = 2,
          .highest = 50,
          .duration = 100,
          .samples_per_period = 8,
          .own = {.seed = 7, .member = 1, .name = "noise"},
          .common = {.seed = 7, .member = 1, .name = "shared"},
          .decay_from = 200};
}

std::vector<double> samples_of(const RandomDefinition &of) {
  double interval = 0;
  return random_samples(of, interval);
}

/// (A - i B) / sqrt(G dw) of the lines between the frequencies: real and imaginary parts have the
/// variance 1.
std::vector<std::complex<double>> amplitudes(const RandomDefinition &of) {
  double interval = 0;
  const std::vector<double> samples = random_samples(of, interval);
  const std::vector<std::complex<double>> lines = forward_transform(samples);
  const auto count = static_cast<double>(samples.size());
  const double spacing = 2 * pi / (interval * count);
  std::vector<std::complex<double>> found;
  for (std::size_t k = 1; 2 * k < samples.size(); ++k) {
    const double omega = spacing * static_cast<double>(k);
    const std::complex<double> line = 2.0 / count * lines[k];
    if (omega >= of.lowest && omega <= of.highest)
      found.push_back(line / std::sqrt(of.density(omega) * spacing));
    else
      EXPECT_LT(std::abs(line), 1e-13) << omega;
  }
  return found;
}

// Means of a thousand numbers and more: within four standard errors.
TEST(RandomHistoryTest, AmplitudesAreNormalWithTheGivenDensity) {
  double first = 0, second = 0, fourth = 0, products = 0, count = 0;
  for (std::uint64_t member = 1; member <= 20; ++member) {
    RandomDefinition of = definition();
    of.own.member = member;
    for (const std::complex<double> &amplitude : amplitudes(of)) {
      products += amplitude.real() * amplitude.imag();
      for (const double x : {amplitude.real(), amplitude.imag()}) {
        first += x;
        second += x * x;
        fourth += x * x * x * x;
        ++count;
      }
    }
  }
  EXPECT_GT(count, 30000);
  EXPECT_NEAR(first / count, 0, 4 / std::sqrt(count));
  EXPECT_NEAR(second / count, 1, 4 * std::sqrt(2 / count));
  EXPECT_NEAR(fourth / count, 3, 4 * std::sqrt(96 / count));
  EXPECT_NEAR(2 * products / count, 0, 4 * std::sqrt(2 / count));
}

TEST(RandomHistoryTest, DependsOnSeedMemberAndStreamAlone) {
  const RandomDefinition of = definition();
  EXPECT_EQ(samples_of(of), samples_of(of));
  RandomDefinition louder = of;
  louder.density = [&](double omega) { return 4 * of.density(omega); };
  const std::vector<double> twice = samples_of(louder), once = samples_of(of);
  for (std::size_t k = 0; k < once.size(); ++k)
    EXPECT_NEAR(twice[k], 2 * once[k], 1e-12);
  for (const RandomStream &other :
       {RandomStream{8, 1, "noise"}, RandomStream{7, 2, "noise"}, RandomStream{7, 1, "other"}}) {
    RandomDefinition changed = of;
    changed.own = other;
    EXPECT_NE(samples_of(changed).front(), once.front());
  }
}

TEST(RandomHistoryTest, CommonStreamsMakeCoherence) {
  RandomDefinition one = definition(), other = definition();
  one.common_share = 0.9;
  other.common_share = 0.7;
  other.own.name = "second";
  std::complex<double> cross = 0;
  double squares = 0, other_squares = 0, count = 0;
  for (std::uint64_t member = 1; member <= 20; ++member) {
    one.own.member = one.common.member = other.own.member = other.common.member = member;
    const auto a = amplitudes(one), b = amplitudes(other);
    for (std::size_t k = 0; k < a.size(); ++k, ++count) {
      cross += a[k] * std::conj(b[k]);
      squares += std::norm(a[k]);
      other_squares += std::norm(b[k]);
    }
  }
  const double coherence = std::norm(cross) / (squares * other_squares);
  EXPECT_NEAR(coherence, std::pow(0.9 * 0.7, 2), 4 / std::sqrt(count));
  other.common_share = one.common_share = 1; // then both are the common one
  EXPECT_EQ(samples_of(one), samples_of(other));
}

TEST(RandomHistoryTest, Envelope) {
  RandomDefinition shaped = definition();
  shaped.rise = 20;
  shaped.decay_from = 60;
  shaped.decay_rate = 0.1;
  double interval = 0;
  const std::vector<double> flat = random_samples(definition(), interval);
  const std::vector<double> found = random_samples(shaped, interval);
  for (std::size_t k = 0; k < flat.size(); k += 97) {
    const double t = interval * static_cast<double>(k);
    const double factor = t < 20 ? t * t / 400 : t > 60 ? std::exp(-0.1 * (t - 60)) : 1;
    EXPECT_NEAR(found[k], factor * flat[k], 1e-13);
  }
}

TEST(RandomHistoryTest, SampleCountsAreFastAndLongEnough) {
  for (const double duration : {0.1, 1.0, 37.0, 100.0}) {
    RandomDefinition of = definition();
    of.duration = duration;
    const std::size_t count = random_sample_count(of);
    const double interval = 2 * pi / (50 * 8);
    EXPECT_GE(static_cast<double>(count - 1) * interval, duration * (1 - 1e-9));
    EXPECT_EQ(count % 2, 0U);
  }
}

} // namespace random_history_tests
} // namespace vibroimpact::model
