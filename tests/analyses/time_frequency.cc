// Wavelet maps and spectrograms of a forced vibration: where their instants lie, and what a sine
// shows.
#include "analyses/recorders/time_frequency.h"
#include "support/recorded_windows.h"
#include "support/recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace vibroimpact::analyses {
namespace time_frequency_tests {

constexpr double pi = std::numbers::pi;
constexpr double frequency = 4, omega = 2 * pi * frequency; // of the force
constexpr double interval = 1 / (16 * frequency);
constexpr long settling = 40, cycles = 120;

// Well damped, so that the free vibration is gone when the window begins.
System forced() {
  model::Model model({testing::single_mass("block", 1, 400, 20)});
  model.add_force("push",
                  std::make_shared<model::Harmonic>(model::Given::displacement, 300, omega, 0), {},
                  Vector3::UnitX());
  return testing::system_of(std::move(model));
}

double amplitude() { return 300 / std::abs(std::complex<double>(400 - omega * omega, 20 * omega)); }

std::vector<Observable> displacement_of(const System &system) {
  Observable displacement = observables({}, system).front();
  displacement.path = "x";
  return {displacement};
}

template <class Kind> PointResult recorded(Kind &&recorder, const System &system) {
  testing::record(system, recorder, 1 / frequency, settling, cycles);
  PointResult result;
  recorder.add_fields(result);
  return result;
}

PointResult wavelet(long instants) {
  const System system = forced();
  return recorded(WaveletRecorder(displacement_of(system), {.wavelet = Wavelet::morlet(6),
                                                            .frequencies = {3, frequency, 6},
                                                            .interval = interval,
                                                            .instants = instants}),
                  system);
}

PointResult spectrogram(long instants) {
  const System system = forced();
  return recorded(
      SpectrogramRecorder(
          displacement_of(system),
          {.window = 2, .interval = interval, .highest_frequency = 8, .instants = instants}),
      system);
}

// The window is a whole number of intervals: the first instant is its start, the last one its end.
void expect_instants(const std::vector<double> &times, std::size_t count) {
  ASSERT_EQ(times.size(), count);
  const double start = settling / frequency;
  const double end = (settling + cycles) / frequency;
  for (std::size_t i = 0; i < count; ++i)
    EXPECT_NEAR(times[i],
                start + (end - start) * static_cast<double>(i) / static_cast<double>(count - 1),
                interval)
        << i;
  EXPECT_NEAR(times.front(), start, 1e-9);
  EXPECT_NEAR(times.back(), end, 1e-9);
}

TEST(TimeFrequencyTest, InstantsReachFromStartToEnd) {
  expect_instants(testing::field_of(wavelet(7), "wavelet_time").values, 7);
  expect_instants(testing::field_of(spectrogram(9), "spectrogram_time").values, 9);
}

// In the middle of the window, on the ridge (scale frequency by time) and on the line of the
// spectrogram (lines of 0.5 Hz by time).
TEST(TimeFrequencyTest, ASineShowsItsAmplitude) {
  const Field ridge = testing::field_of(wavelet(5), "wavelet/x");
  ASSERT_EQ(ridge.shape, (std::vector<std::size_t>{3, 5}));
  EXPECT_NEAR(ridge.values[1 * 5 + 2], amplitude(), 1e-4 * amplitude());
  const Field lines = testing::field_of(spectrogram(5), "spectrogram/x");
  ASSERT_EQ(lines.shape, (std::vector<std::size_t>{17, 5}));
  EXPECT_NEAR(lines.values[8 * 5 + 2], amplitude(), 1e-4 * amplitude());
  EXPECT_NEAR(lines.values[6 * 5 + 2], 0, 1e-4 * amplitude());
}

} // namespace time_frequency_tests
} // namespace vibroimpact::analyses
