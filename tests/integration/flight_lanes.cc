// Kernels in vector lanes fly as they do alone, to the last bit.
#include "integration/flight_lanes.h"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>
#include <random>

namespace vibroimpact::integration {
namespace {

using Complex = std::complex<double>;
using End = FlightKernel::End;

// A phase and where its flight starts.
struct Start {
  GuardSums sums;
  Amplitudes amplitudes;
  double limit = 0;
  std::vector<std::size_t> zero;
};

class Random {
public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()() { return unit_(engine_); } ///< in (-1, 1)
  std::size_t up_to(std::size_t largest) { return engine_() % (largest + 1); }

private:
  std::mt19937 engine_;
  std::uniform_real_distribution<double> unit_{-1, 1};
};

// Guards that are positive or zero at the start; real, oscillating, fast and growing groups.
Start random_start(Random &random, std::size_t most_groups, std::size_t most_guards) {
  Start start;
  const std::size_t n_groups = random.up_to(most_groups);
  start.amplitudes.resize(n_groups);
  for (std::size_t j = 0; j < n_groups; ++j) {
    const bool real = random() > 0.2;
    const double rate = random.up_to(5) == 0 ? 0 : 0.5 * random() - 0.3;
    start.sums.add_exponent({random.up_to(7) == 0 ? 30 * rate : rate, real ? 0 : 6 * random()});
    start.amplitudes.real[j] = random();
    start.amplitudes.imaginary[j] = real ? 0 : random();
  }
  const std::size_t n_guards = random.up_to(most_guards);
  for (std::size_t g = 0; g < n_guards; ++g) {
    std::vector<Complex> coefficients;
    std::vector<double> sizes;
    double value = 0;
    for (std::size_t j = 0; j < n_groups; ++j) {
      coefficients.emplace_back(random(), start.sums.frequency[j] == 0 ? 0 : random());
      sizes.push_back(std::abs(coefficients[j]));
      value += coefficients[j].real() * start.amplitudes.real[j] -
               coefficients[j].imag() * start.amplitudes.imaginary[j];
    }
    const bool zero = random.up_to(6) == 0;
    if (zero)
      start.zero.push_back(g);
    start.sums.add_guard((zero ? 0 : 0.5 * random() + 0.5001) - value, coefficients, sizes);
  }
  start.limit = random.up_to(3) == 0 ? 0.3 : 8;
  return start;
}

void begin(const Start &start, FlightKernel &kernel) {
  kernel.start(start.sums, start.amplitudes);
  for (const std::size_t guard : start.zero)
    kernel.zero_at_start(guard);
}

bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (a == 0 && b == 0); }

void expect_same(const Amplitudes &a, const Amplitudes &b) {
  for (std::size_t j = 0; j < a.real.size(); ++j) {
    EXPECT_TRUE(same(a.real[j], b.real[j])) << a.real[j] - b.real[j];
    EXPECT_TRUE(same(a.imaginary[j], b.imaginary[j])) << a.imaginary[j] - b.imaginary[j];
    EXPECT_TRUE(same(a.size[j], b.size[j])) << a.size[j] - b.size[j];
  }
}

void expect_same(End end, const FlightKernel &alone, End end_in_lane, const FlightKernel &lane) {
  ASSERT_EQ(end_in_lane, end);
  EXPECT_TRUE(same(lane.flown(), alone.flown()));
  EXPECT_EQ(lane.pieces(), alone.pieces());
  expect_same(alone.amplitudes(), lane.amplitudes());
  if (end != End::guard)
    return;
  ASSERT_EQ(lane.guard(), alone.guard());
  EXPECT_TRUE(same(lane.time_to_guard(), alone.time_to_guard()));
  EXPECT_TRUE(same(lane.residual(), alone.residual()));
  expect_same(alone.amplitudes_at_guard(), lane.amplitudes_at_guard());
  EXPECT_TRUE(same(lane.value_at_guard(alone.guard()), alone.value_at_guard(alone.guard())));
  EXPECT_TRUE(same(lane.slope_at_guard(alone.guard()), alone.slope_at_guard(alone.guard())));
}

struct Tally {
  int limits = 0, guards = 0, unclear = 0;
  void add(End end) { ++(end == End::limit ? limits : end == End::guard ? guards : unclear); }
};

// Each lane is filled again as soon as it is free.
void fly_all(const std::vector<Start> &starts, FlightLanes &lanes,
             std::vector<FlightKernel> &kernels,
             const std::function<void(std::size_t, End)> &land) {
  std::size_t next = 0;
  while (next < starts.size() || !lanes.empty()) {
    for (; next < starts.size() && !lanes.full(); ++next) {
      begin(starts[next], kernels[next]);
      if (const auto end = lanes.add(kernels[next], starts[next].limit, next))
        land(next, *end);
    }
    if (!lanes.empty())
      for (const FlightLanes::Landing &landing : lanes.fly())
        land(landing.owner, landing.end);
  }
}

Tally compare(VectorUnit unit, const std::vector<Start> &starts) {
  std::vector<FlightKernel> kernels(starts.size());
  std::vector<bool> landed(starts.size());
  FlightLanes lanes(unit);
  Tally tally;
  const auto land = [&](std::size_t i, End end) {
    FlightKernel alone;
    begin(starts[i], alone);
    expect_same(alone.fly(starts[i].limit), alone, end, kernels[i]);
    EXPECT_FALSE(landed[i]);
    landed[i] = true;
    tally.add(end);
  };
  fly_all(starts, lanes, kernels, land);
  return tally;
}

class FlightLanesTest : public testing::TestWithParam<VectorUnit> {
protected:
  void SetUp() override {
    if (GetParam() > best_vector_unit())
      GTEST_SKIP() << "this machine has no such vectors";
  }
};

// Thousands of flights, of different sizes next to each other; the lanes grow on the way.
TEST_P(FlightLanesTest, LikeTheKernelAlone) {
  Random random(5);
  std::vector<Start> starts;
  for (int i = 0; i < 6000; ++i)
    starts.push_back(random_start(random, 2 + i / 1000, 1 + i / 1500));
  const Tally tally = compare(GetParam(), starts);
  EXPECT_GT(tally.limits, 1000);
  EXPECT_GT(tally.guards, 1000);
  EXPECT_GT(tally.unclear, 10);
  EXPECT_EQ(tally.limits + tally.guards + tally.unclear, 6000);
}

// 1 + d - cos t with d within what rounding may hide: lanes give up where the kernel does, instead
// of creeping past the touch.
TEST_P(FlightLanesTest, GrazingWithinRounding) {
  const double hidden = 64 * std::numeric_limits<double>::epsilon() * 2;
  std::vector<Start> starts(200);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const double angle = 1.3 + 0.01 * static_cast<double>(i);
    const double share = -1.4 + 0.01 * static_cast<double>(i);
    const std::vector<Complex> coefficients = {-std::polar(1.0, -angle)};
    const std::vector<double> sizes = {1};
    starts[i].sums.add_exponent({0, 1});
    starts[i].sums.add_guard(1 + share * hidden, coefficients, sizes);
    starts[i].amplitudes.resize(1);
    starts[i].amplitudes.real[0] = 1;
    starts[i].limit = angle + 1;
  }
  const Tally tally = compare(GetParam(), starts);
  EXPECT_EQ(tally.limits, 0);
  EXPECT_GT(tally.unclear, 150);
}

// A kernel that is not a number ends by itself and leaves its neighbours alone.
TEST_P(FlightLanesTest, AFailingNeighbour) {
  Random random(11);
  std::vector<Start> starts;
  for (int i = 0; i < 300; ++i) {
    starts.push_back(random_start(random, 4, 2));
    if (i % 7 == 3 && !starts.back().amplitudes.real.empty())
      starts.back().amplitudes.real[0] =
          i % 2 == 0 ? std::numeric_limits<double>::quiet_NaN() : 1e300;
  }
  FlightLanes lanes(GetParam());
  std::vector<FlightKernel> kernels(starts.size());
  const auto land = [&](std::size_t i, End end) {
    FlightKernel alone;
    begin(starts[i], alone);
    EXPECT_EQ(end, alone.fly(starts[i].limit)) << i;
    if (i % 7 != 3)
      expect_same(alone.amplitudes(), kernels[i].amplitudes());
  };
  fly_all(starts, lanes, kernels, land);
}

INSTANTIATE_TEST_SUITE_P(Units, FlightLanesTest,
                         testing::Values(VectorUnit::none, VectorUnit::sse2, VectorUnit::avx2,
                                         VectorUnit::avx512));

} // namespace
} // namespace vibroimpact::integration
