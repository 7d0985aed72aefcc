// Sums of decaying, growing and oscillating exponentials: the first zero is found, none is passed.
#include "exponential_sums.h"
#include "motion/kernel/interpolation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace vibroimpact::motion {
namespace exact_kernel_tests {

class ExactKernelTest : public ::testing::TestWithParam<const Kernel *> {
protected:
  const Kernel &kernel() const { return *GetParam(); }
};

std::string name_of(const ::testing::TestParamInfo<const Kernel *> &info) {
  return info.param->name;
}

INSTANTIATE_TEST_SUITE_P(Machines, ExactKernelTest, ::testing::ValuesIn(kernels()), name_of);

TEST_P(ExactKernelTest, ExponentialsAndAngles) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 20000; ++i) {
    double x[8];
    double e[8];
    double s[8];
    double c[8];
    const double range = std::pow(10.0, 1.5 + 1.5 * unit(random));
    for (double &value : x)
      value = unit(random) * range;
    kernel().exponential(x, e);
    kernel().sine_cosine(x, s, c);
    for (int j = 0; j < 8; ++j) {
      const long double exact = std::exp(static_cast<long double>(x[j]));
      if (std::abs(x[j]) < 700) {
        EXPECT_NEAR(e[j] / static_cast<double>(exact), 1, 3e-16) << x[j];
      }
      EXPECT_NEAR(s[j], static_cast<double>(std::sin(static_cast<long double>(x[j]))), 2.5e-16);
      EXPECT_NEAR(c[j], static_cast<double>(std::cos(static_cast<long double>(x[j]))), 2.5e-16);
    }
  }
}

TEST_P(ExactKernelTest, WithoutGuardsInReachTheLimitIsReached) {
  SumsPhase phase({{.constant = 10, .coefficients = {3}, .exponents = {{-1, 2}}}});
  EXPECT_EQ(phase.advance(kernel(), 1.5), MarchEnd::limit);
  EXPECT_EQ(phase.walk.time, 1.5);
  double f[4];
  kernel().derivatives(phase.phase->view(), 0, phase.walk.amplitudes, f);
  const Complex moved = 3.0 * std::exp(Complex(-1.5, 3));
  EXPECT_NEAR(f[0], 10 + moved.real(), 4e-15);
  EXPECT_NEAR(f[1], (moved * Complex(-1, 2)).real(), 1e-14);
  EXPECT_NEAR(f[2], (moved * Complex(-1, 2) * Complex(-1, 2)).real(), 1e-14);
}

// exp(-t) - 0.1 is zero at t = ln 10.
TEST_P(ExactKernelTest, AZeroIsFoundToRounding) {
  SumsPhase phase({{.constant = -0.1, .coefficients = {1}, .exponents = {-1}}});
  const MarchEnd end = phase.advance(kernel(), 10);
  EXPECT_EQ(end, MarchEnd::guard);
  EXPECT_NEAR(phase.reached(end), std::log(10.0), 4e-15);
  EXPECT_NEAR(phase.walk.value, 0, 1e-16);
  EXPECT_NEAR(phase.walk.slope, -0.1, 1e-15);
}

// A zero behind the limit is none.
TEST_P(ExactKernelTest, AZeroBehindTheLimitIsNone) {
  SumsPhase phase({{.constant = -0.1, .coefficients = {1}, .exponents = {-1}}});
  const double zero = std::log(10.0);
  EXPECT_EQ(phase.advance(kernel(), zero - 1e-9), MarchEnd::limit);
  EXPECT_EQ(phase.advance(kernel(), zero + 1e-9), MarchEnd::guard);
  EXPECT_NEAR(phase.reached(MarchEnd::guard), zero, 4e-15);
}

// Where a limit falls on a zero, that is found by the next call, at once.
TEST_P(ExactKernelTest, ALimitOnAZero) {
  SumsPhase phase({{.constant = -0.1, .coefficients = {1}, .exponents = {-1}}});
  const double zero = std::log(10.0);
  const MarchEnd first = phase.advance(kernel(), zero);
  const MarchEnd second = first == MarchEnd::guard ? first : phase.advance(kernel(), 10);
  EXPECT_EQ(second, MarchEnd::guard);
  EXPECT_NEAR(phase.reached(second), zero, 1e-13);
  EXPECT_LT(phase.walk.pieces, 60);
}

// 1 + d - cos t touches d above zero, or dips below it for 2 sqrt(2 d): both far shorter than a
// piece.
TEST_P(ExactKernelTest, GrazingIsDecidedOnBothSides) {
  for (int k = 2; k <= 12; ++k) {
    const double depth = std::pow(10.0, -k);
    const auto grazing = [](double constant) { // starts at t = -1.3
      return SumsPhase({{.constant = constant,
                         .coefficients = {-std::polar(1.0, -1.3)},
                         .exponents = {Complex(0, 1)}}});
    };
    SumsPhase above = grazing(1 + depth);
    EXPECT_EQ(above.advance(kernel(), 3), MarchEnd::limit) << k;
    EXPECT_LT(above.walk.pieces, 20) << k;
    SumsPhase below = grazing(1 - depth);
    const MarchEnd end = below.advance(kernel(), 3);
    EXPECT_EQ(end, MarchEnd::guard) << k;
    EXPECT_NEAR(below.reached(end), 1.3 - std::acos(1 - depth), 1e-15 / std::sqrt(2 * depth)) << k;
  }
}

// Where rounding hides whether 1 + d - cos t touches zero, the touch is counted, in a few pieces.
TEST_P(ExactKernelTest, GrazingWithinRoundingIsCounted) {
  const double hidden = guard_rounding * 2;
  for (int i = 0; i < 200; ++i) {
    const double start = 1.3 + 0.01 * i;
    const double share = -0.9 + 0.009 * i; // of what may be hidden
    SumsPhase phase({{.constant = 1 + share * hidden,
                      .coefficients = {-std::polar(1.0, -start)},
                      .exponents = {Complex(0, 1)}}});
    EXPECT_EQ(phase.advance(kernel(), start + 1), MarchEnd::limit) << share;
    EXPECT_EQ(phase.walk.undecided, 1) << share;
    EXPECT_LE(phase.walk.pieces, 60) << share;
  }
}

// sin t, and 1 - cos t with its double zero, rise from zeros that are declared.
TEST_P(ExactKernelTest, ARiseFromADeclaredZeroIsNoFall) {
  SumsPhase sine({{.constant = 0, .coefficients = {Complex(0, -1)}, .exponents = {{0, 1}}}});
  sine.order[0] = 1;
  MarchEnd end = sine.advance(kernel(), 10);
  EXPECT_EQ(end, MarchEnd::guard);
  EXPECT_NEAR(sine.reached(end), M_PI, 4e-15);
  SumsPhase square(
      {{.constant = 1, .coefficients = {-1, 0}, .exponents = {Complex(0, 1), Complex(-0.1, 0)}}});
  square.order[0] = 2;
  end = square.advance(kernel(), 6);
  EXPECT_EQ(end, MarchEnd::limit);
  EXPECT_LT(square.walk.pieces, 20);
}

// Of two guards that fall at the same instant the first is reported; the other is below zero by
// rounding alone.
TEST_P(ExactKernelTest, SimultaneousFalls) {
  const Sum falling{.constant = -0.1, .coefficients = {1}, .exponents = {-1}};
  SumsPhase phase({falling, falling});
  const MarchEnd end = phase.advance(kernel(), 10);
  EXPECT_EQ(end, MarchEnd::guard);
  EXPECT_NEAR(phase.reached(end), std::log(10.0), 1e-14);
  EXPECT_LT(phase.walk.pieces, 100);
}

// Twenty thousand pairs of sums against samples.
TEST_P(ExactKernelTest, RandomSums) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  int falls = 0;
  for (int i = 0; i < 4000; ++i) {
    std::vector<Sum> sums(2);
    for (int j = 0; j < 4; ++j) {
      const Complex exponent(0.5 * unit(random) - 0.2, j == 0 ? 0 : 6 * unit(random));
      for (Sum &sum : sums) {
        sum.coefficients.emplace_back(unit(random), j == 0 ? 0 : unit(random));
        sum.exponents.push_back(exponent);
      }
    }
    for (Sum &sum : sums)
      sum.constant = std::max(0.0, 0.1 - sum(0)) + unit(random) + 1;
    SumsPhase phase(sums, 4);
    const MarchEnd end = phase.advance(kernel(), 4);
    ASSERT_NE(end, MarchEnd::unclear);
    falls += end == MarchEnd::guard;
    const double reached = phase.reached(end);
    ASSERT_LE(reached, 4);
    for (int k = 0; k < 64; ++k)
      for (const Sum &sum : sums)
        ASSERT_GT(sum(reached * k / 64), 0) << i;
    if (end == MarchEnd::guard) {
      const auto guard = static_cast<std::size_t>(phase.walk.guard);
      EXPECT_NEAR(sums[guard](reached), 0, 1e-13) << i;
      EXPECT_GT(sums[1 - guard](reached), -1e-13) << i;
    } else {
      EXPECT_EQ(reached, 4);
    }
  }
  EXPECT_GT(falls, 1000);
}

// The polynomials of degree 7, against what is said of their error: cos(k tau) as the real part of
// an exponential with |e h| = k, by dense samples of the remainder's own factor.
TEST(ExactKernelTablesTest, ErrorConstants) {
  for (int order = 0; order < 3; ++order) {
    double largest = 0;
    for (int i = 1; i <= 20000; ++i) {
      const double tau = i / 20000.0;
      double product = std::pow(tau, 3 - order) / 40320;
      for (const double node : interpolation_nodes)
        product *= std::abs(tau - node);
      largest = std::max(largest, product);
    }
    EXPECT_LE(largest, interpolation_error[static_cast<std::size_t>(order)]);
    EXPECT_GE(largest, 0.99 * interpolation_error[static_cast<std::size_t>(order)]);
  }
}

TEST(ExactKernelTablesTest, PolynomialsOfItsDegreeAreExact) {
  for (int degree = 0; degree <= 7; ++degree) {
    std::array<double, 8> data{};
    for (int k = 0; k < 3; ++k)
      data[static_cast<std::size_t>(k)] = degree == k ? 1 : 0;
    for (std::size_t i = 0; i < 5; ++i)
      data[3 + i] = std::pow(interpolation_nodes[i], degree);
    double end = 0;
    for (std::size_t k = 0; k < 8; ++k)
      end += interpolation_matrix()[7][k] * data[k];
    EXPECT_NEAR(end, 1, 1e-13) << degree;
  }
}

// AVX2 and AVX-512 give the same bits.
TEST(ExactKernelMachinesTest, SameBits) {
  if (!machine_has(kernel_avx512) || !machine_has(kernel_avx2))
    GTEST_SKIP() << "this machine has one of the two at most";
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 500; ++i) {
    std::vector<Sum> sums(3);
    for (int j = 0; j < 6; ++j) {
      const Complex exponent(-0.3 + 0.3 * unit(random), j < 2 ? 0 : 5 * unit(random) + 6);
      for (Sum &sum : sums) {
        sum.coefficients.emplace_back(unit(random), j < 2 ? 0 : unit(random));
        sum.exponents.push_back(exponent);
      }
    }
    for (Sum &sum : sums)
      sum.constant = 3;
    SumsPhase one(sums);
    SumsPhase other(sums);
    const MarchEnd end = one.advance(kernel_avx2, 30);
    ASSERT_EQ(end, other.advance(kernel_avx512, 30));
    EXPECT_EQ(one.reached(end), other.reached(end));
    EXPECT_EQ(one.walk.pieces, other.walk.pieces);
    EXPECT_EQ(std::memcmp(one.walk.amplitudes, other.walk.amplitudes,
                          one.phase->n_amplitudes() * sizeof(double)),
              0);
  }
}

} // namespace exact_kernel_tests
} // namespace vibroimpact::motion
