// Random histories: variance, spectrum, distribution and coherence of their amplitudes, envelope,
// and what they depend on.
#include "model/random_history.h"

#include "common/fourier.h"
#include "model/coherence.h"

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
          .streams = {{.seed = 7, .member = 1, .name = "noise"}},
          .shares = [](double) { return std::vector<std::complex<double>>{1}; },
          .decay_from = 200};
}

/// Takes a share of a common stream.
RandomDefinition partly_common(double share, const std::string &own) {
  RandomDefinition of = definition();
  of.streams = {{7, 1, "shared"}, {7, 1, own}};
  of.shares = [share](double) {
    return std::vector<std::complex<double>>{share, std::sqrt(1 - share * share)};
  };
  return of;
}

RandomDefinition of_member(RandomDefinition of, std::uint64_t member) {
  for (RandomStream &stream : of.streams)
    stream.member = member;
  return of;
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
    for (const std::complex<double> &amplitude : amplitudes(of_member(definition(), member))) {
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
    changed.streams = {other};
    EXPECT_NE(samples_of(changed).front(), once.front());
  }
}

/// Lines of twenty members, one behind the other, with their frequencies [rad/s]; c = A - i B.
struct Lines {
  std::vector<double> omega;
  std::vector<std::complex<double>> value;
};

Lines lines_of_members(const RandomDefinition &of) {
  double interval = 0;
  const auto size = static_cast<double>(random_samples(of, interval).size());
  const double spacing = 2 * pi / (interval * size);
  Lines lines;
  for (std::uint64_t member = 1; member <= 20; ++member) {
    double omega = spacing * std::ceil(of.lowest / spacing);
    for (const std::complex<double> &value : amplitudes(of_member(of, member))) {
      lines.omega.push_back(omega);
      lines.value.push_back(value);
      omega += spacing;
    }
  }
  return lines;
}

struct Coherency {
  std::complex<double> value;
  double count = 0;
};

/// E[a conj(b)] over the root mean squares, of the lines between two frequencies; turned by `later`
/// [s], the time by which the first comes behind the second.
Coherency coherency(const Lines &a, const Lines &b, double lowest, double highest, double later) {
  std::complex<double> cross = 0;
  double squares = 0, other_squares = 0, count = 0;
  for (std::size_t k = 0; k < a.omega.size(); ++k) {
    if (a.omega[k] < lowest || a.omega[k] > highest)
      continue;
    cross += a.value[k] * std::conj(b.value[k]) * std::polar(1.0, a.omega[k] * later);
    squares += std::norm(a.value[k]);
    other_squares += std::norm(b.value[k]);
    ++count;
  }
  return {cross / std::sqrt(squares * other_squares), count};
}

TEST(RandomHistoryTest, CommonStreamsMakeCoherence) {
  const Coherency found = coherency(lines_of_members(partly_common(0.9, "noise")),
                                    lines_of_members(partly_common(0.7, "second")), 0, 100, 0);
  EXPECT_NEAR(std::norm(found.value), std::pow(0.9 * 0.7, 2), 4 / std::sqrt(found.count));
  // with a share of 1 both are the common one
  EXPECT_EQ(samples_of(partly_common(1, "noise")), samples_of(partly_common(1, "second")));
}

/// The excitation at the last of the places.
RandomDefinition at_places(const std::vector<double> &x, double slowness) {
  RandomDefinition of = definition();
  CoherentPlaces coherent{.law = [](double argument) { return std::exp(-argument); },
                          .decay_per_speed = 0.02,
                          .slowness = {slowness, 0, 0},
                          .streams = {},
                          .places = {}};
  of.streams.clear();
  for (std::size_t k = 0; k < x.size(); ++k) {
    coherent.streams.push_back("place " + std::to_string(k));
    coherent.places.emplace_back(x[k], 3, -1);
    of.streams.push_back({.seed = 7, .member = 1, .name = coherent.streams.back()});
  }
  of.shares = [coherent](double omega) { return coherent.shares(omega); };
  return of;
}

// In bands of the frequency, over which the law changes by less than the standard error.
TEST(RandomHistoryTest, CoherenceFallsWithFrequencyAndDistanceBehindAWave) {
  const std::vector<double> x = {0, 2, 7};
  const double slowness = 0.05;
  std::vector<Lines> lines;
  for (std::size_t k = 1; k <= x.size(); ++k)
    lines.push_back(lines_of_members(
        at_places({x.begin(), x.begin() + static_cast<std::ptrdiff_t>(k)}, slowness)));
  for (std::size_t i = 1; i < x.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (double lowest = 2; lowest < 50; lowest += 4) {
        const double distance = x[i] - x[j];
        const Coherency found =
            coherency(lines[i], lines[j], lowest, lowest + 4, slowness * distance);
        const double expected = std::exp(-0.02 * (lowest + 2) * distance);
        EXPECT_NEAR(found.value.real(), expected, 4 / std::sqrt(2 * found.count));
        EXPECT_NEAR(found.value.imag(), 0, 4 / std::sqrt(2 * found.count));
      }
}

TEST(RandomHistoryTest, OnePlaceHasOneMotion) {
  const std::vector<double> first = samples_of(at_places({4}, 0)),
                            same = samples_of(at_places({4, 4}, 0)),
                            again = samples_of(at_places({4, 9, 4}, 0));
  for (std::size_t k = 0; k < first.size(); ++k) {
    EXPECT_EQ(first[k], same[k]);
    EXPECT_NEAR(first[k], again[k], 1e-12);
  }
}

// A wave alone brings the same motion later: by whole samples.
TEST(RandomHistoryTest, AWaveIsADelay) {
  RandomDefinition later = at_places({0, 6}, 0);
  double interval = 0;
  const std::vector<double> first = random_samples(at_places({0}, 0), interval);
  CoherentPlaces coherent{.law = [](double) { return 1.0; },
                          .slowness = {5 * interval / 6, 0, 0},
                          .streams = {"place 0", "place 1"},
                          .places = {{0, 0, 0}, {6, 0, 0}}};
  later.shares = [coherent](double omega) { return coherent.shares(omega); };
  const std::vector<double> second = samples_of(later);
  for (std::size_t k = 5; k < first.size(); ++k)
    EXPECT_NEAR(second[k], first[k - 5], 1e-11);
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
