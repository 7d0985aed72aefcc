// Sums of decaying, growing and oscillating exponentials: the first zero is found, none is passed.
#include "integration/flight_kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace vibroimpact::integration {
namespace {

using Complex = std::complex<double>;

struct Sum {
  double constant = 0;
  std::vector<Complex> coefficients, exponents;

  double operator()(double t) const {
    double value = constant;
    for (std::size_t j = 0; j < exponents.size(); ++j)
      value += (coefficients[j] * std::exp(exponents[j] * t)).real();
    return value;
  }
};

// Two functions with the same exponents.
struct Flight {
  FlightKernel::End end;
  FlightKernel kernel;
  double reached() const {
    return kernel.flown() + (end == FlightKernel::End::guard ? kernel.time_to_guard() : 0.0);
  }
};

Flight fly(const std::vector<Sum> &functions, double limit) {
  GuardSums sums;
  Amplitudes amplitudes;
  amplitudes.resize(functions[0].exponents.size());
  for (std::size_t j = 0; j < functions[0].exponents.size(); ++j) {
    sums.add_exponent(functions[0].exponents[j]);
    amplitudes.real[j] = 1;
    amplitudes.imaginary[j] = 0;
  }
  for (const Sum &function : functions) {
    std::vector<double> sizes;
    for (const Complex coefficient : function.coefficients)
      sizes.push_back(std::abs(coefficient));
    sums.add_guard(function.constant, function.coefficients, sizes);
  }
  Flight flight;
  flight.kernel.start(sums, amplitudes);
  flight.end = flight.kernel.fly(limit);
  return flight;
}

TEST(FlightKernelTest, WithoutGuardsTheLimitIsReached) {
  GuardSums sums;
  sums.add_exponent({-1, 2});
  Amplitudes amplitudes;
  amplitudes.resize(1);
  amplitudes.real[0] = 3;
  FlightKernel kernel;
  kernel.start(sums, amplitudes);
  EXPECT_EQ(kernel.fly(1.5), FlightKernel::End::limit);
  EXPECT_NEAR(kernel.amplitudes().real[0], 3 * std::exp(-1.5) * std::cos(3.0), 1e-15);
  EXPECT_NEAR(kernel.amplitudes().imaginary[0], 3 * std::exp(-1.5) * std::sin(3.0), 1e-15);
}

// exp(-t) - 0.1 is zero at t = ln 10.
TEST(FlightKernelTest, AZeroIsFoundToRounding) {
  const Flight flight = fly({{.constant = -0.1, .coefficients = {1}, .exponents = {-1}}}, 10);
  EXPECT_EQ(flight.end, FlightKernel::End::guard);
  EXPECT_NEAR(flight.reached(), std::log(10.0), 4e-15);
  EXPECT_LT(flight.kernel.residual(), 1e-14);
}

// 1 + d - cos t touches d above zero, or dips below it for 2 sqrt(2 d): both far shorter than a
// piece.
TEST(FlightKernelTest, GrazingIsDecidedOnBothSides) {
  for (int k = 2; k <= 12; ++k) {
    const double depth = std::pow(10.0, -k);
    const auto graze = [&](double constant) {
      // starts at t = -1.3
      return fly({{.constant = constant,
                   .coefficients = {-std::polar(1.0, -1.3)},
                   .exponents = {Complex(0, 1)}}},
                 3);
    };
    EXPECT_EQ(graze(1 + depth).end, FlightKernel::End::limit) << k;
    const Flight dip = graze(1 - depth);
    EXPECT_EQ(dip.end, FlightKernel::End::guard) << k;
    EXPECT_NEAR(dip.reached(), 1.3 - std::acos(1 - depth), 1e-15 / std::sqrt(2 * depth)) << k;
  }
}

// Where rounding hides whether 1 + d - cos t touches zero, the pieces must not creep past it, each
// too short to change anything: the kernel gives up soon, and leaves the touch to others.
TEST(FlightKernelTest, GrazingWithinRoundingIsLeftToOthers) {
  const double hidden = 64 * std::numeric_limits<double>::epsilon() * 2;
  for (int k = 0; k < 200; ++k) {
    const double start = 1.3 + 0.01 * k;
    const double share = -1.4 + 0.01 * k; // of what may be hidden
    const Flight flight = fly({{.constant = 1 + share * hidden,
                                .coefficients = {-std::polar(1.0, -start)},
                                .exponents = {Complex(0, 1)}}},
                              start + 1);
    EXPECT_TRUE(flight.end == FlightKernel::End::unclear ||
                (share < -1 && flight.end == FlightKernel::End::guard))
        << share;
    EXPECT_LT(flight.reached(), start) << share;
    EXPECT_LE(flight.kernel.pieces(), 60) << share;
  }
}

// sin t and t exp(-t)-like rises from an exact zero are not taken for falls.
TEST(FlightKernelTest, ARiseFromZeroIsNoFall) {
  GuardSums sums;
  sums.add_exponent({0, 1});
  const std::vector<Complex> sine = {Complex(0, -1)};
  const std::vector<double> sizes = {1};
  sums.add_guard(0, sine, sizes);
  Amplitudes amplitudes;
  amplitudes.resize(1);
  amplitudes.real[0] = 1;
  FlightKernel kernel;
  kernel.start(sums, amplitudes);
  kernel.zero_at_start(0);
  EXPECT_EQ(kernel.fly(10), FlightKernel::End::guard);
  EXPECT_NEAR(kernel.flown() + kernel.time_to_guard(), M_PI, 4e-15);
}

// Two guards that fall together are left to others.
TEST(FlightKernelTest, SimultaneousFallsAreUnclear) {
  const Sum falling{.constant = -0.1, .coefficients = {1}, .exponents = {-1}};
  const Flight flight = fly({falling, falling}, 10);
  EXPECT_EQ(flight.end, FlightKernel::End::unclear);
  EXPECT_LT(flight.reached(), std::log(10.0));
  EXPECT_GT(flight.reached(), 0.9 * std::log(10.0));
}

// Twenty thousand pairs of sums against samples.
TEST(FlightKernelTest, RandomSums) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  int falls = 0;
  int unclear = 0;
  for (int i = 0; i < 20000; ++i) {
    std::vector<Sum> sums(2);
    for (int j = 0; j < 4; ++j) {
      const Complex exponent(0.5 * unit(random) - 0.2, j == 0 ? 0 : 6 * unit(random));
      for (Sum &sum : sums) {
        sum.coefficients.emplace_back(unit(random), unit(random));
        sum.exponents.push_back(exponent);
      }
    }
    for (Sum &sum : sums)
      sum.constant = std::max(0.0, 0.1 - sum(0)) + unit(random) + 1;
    const Flight flight = fly(sums, 4);
    falls += flight.end == FlightKernel::End::guard;
    unclear += flight.end == FlightKernel::End::unclear;
    ASSERT_LE(flight.reached(), 4);
    for (int k = 0; k < 64; ++k)
      for (const Sum &sum : sums)
        ASSERT_GT(sum(flight.reached() * k / 64), 0) << i;
    if (flight.end == FlightKernel::End::guard) {
      EXPECT_NEAR(sums[flight.kernel.guard()](flight.reached()), 0, 1e-13) << i;
      EXPECT_GT(sums[1 - flight.kernel.guard()](flight.reached()), 0) << i;
    }
  }
  EXPECT_GT(falls, 5000);
  EXPECT_EQ(unclear, 0);
}

} // namespace
} // namespace vibroimpact::integration
