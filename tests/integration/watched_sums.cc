// Extreme values of sums of exponentials: as dense samples show them, and in closed form.
#include "integration/watched_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vibroimpact::integration {
namespace {

struct Sum {
  ExponentialBasis basis;
  WatchedForm form;
  Amplitudes amplitudes;

  explicit Sum(const std::vector<Complex> &exponents) {
    const auto size = static_cast<Index>(2 * exponents.size());
    basis.columns = Matrix::Identity(size, size);
    form.row.row = RowVector::Zero(size);
    amplitudes.resize(exponents.size());
    for (std::size_t j = 0; j < exponents.size(); ++j)
      basis.groups.push_back({.exponent = exponents[j],
                              .column = static_cast<Index>(2 * j),
                              .is_pair = exponents[j].imag() != 0});
  }

  Amplitudes at(double t) const {
    Amplitudes moved = amplitudes;
    for (std::size_t j = 0; j < basis.groups.size(); ++j) {
      const Complex a = Complex(amplitudes.real[j], amplitudes.imaginary[j]) *
                        std::exp(basis.groups[j].exponent * t);
      moved.real[j] = a.real();
      moved.imaginary[j] = a.imag();
    }
    return moved;
  }

  double operator()(double t) const {
    const Amplitudes now = at(t);
    double value = form.differentiated ? 0 : form.row.constant;
    for (std::size_t j = 0; j < basis.groups.size(); ++j) {
      const auto column = static_cast<Index>(2 * j);
      Complex a(now.real[j], now.imaginary[j]);
      if (form.differentiated)
        a *= basis.groups[j].exponent;
      value += form.row.row[column] * a.real() + form.row.row[column + 1] * a.imag();
    }
    return value;
  }

  Extent extent_over(double h) {
    Extent extent;
    form.extent = &extent;
    WatchedSums(WatchedForms({form}), basis).include(amplitudes, at(h), h);
    return extent;
  }
};

// 1 + cos(3 t) over four and a half turns, and its derivative.
TEST(WatchedSumsTest, Vibration) {
  Sum sum({Complex(0, 3)});
  sum.amplitudes.real[0] = 1;
  sum.form.row.row[0] = 1;
  sum.form.row.constant = 1;
  const double h = 9.5;
  Extent extent = sum.extent_over(h);
  EXPECT_NEAR(extent.maximum, 2, 1e-14);
  EXPECT_NEAR(extent.minimum, 0, 1e-14);
  sum.form.differentiated = true;
  extent = sum.extent_over(h);
  EXPECT_NEAR(extent.maximum, 3, 1e-14);
  EXPECT_NEAR(extent.minimum, -3, 1e-14);
}

// exp(-t) - exp(-3 t) has its largest value 2/3^1.5 at t = ln(3)/2 and none before.
TEST(WatchedSumsTest, Decay) {
  Sum sum({-1.0, -3.0});
  sum.amplitudes.real = {1, 1};
  sum.form.row.row[0] = 1;
  sum.form.row.row[2] = -1;
  EXPECT_NEAR(sum.extent_over(5).maximum, 2 / std::pow(3, 1.5), 1e-15);
  EXPECT_NEAR(sum.extent_over(0.5).maximum, std::exp(-0.5) - std::exp(-1.5), 1e-15);
}

// A decay a million times faster than the vibration is over at once and costs nothing later.
TEST(WatchedSumsTest, FastDecayBesideAVibration) {
  Sum sum({Complex(0, 1), -1e6});
  sum.amplitudes.real = {1, 5};
  sum.form.row.row[0] = 1;
  sum.form.row.row[2] = 1;
  const Extent extent = sum.extent_over(20);
  EXPECT_NEAR(extent.maximum, 6, 1e-14);
  EXPECT_NEAR(extent.minimum, -1, 1e-14);
}

TEST(WatchedSumsTest, AConstantOverAnyLength) {
  Sum sum({0.0});
  sum.amplitudes.real[0] = 2;
  sum.form.row.row[0] = 1;
  for (const double h : {1e-300, 1.0, 1e150}) {
    const Extent extent = sum.extent_over(h);
    EXPECT_EQ(extent.minimum, 2);
    EXPECT_EQ(extent.maximum, 2);
  }
}

// Samples lie within the extent, and the extent within what samples can miss of it.
TEST(WatchedSumsTest, RandomSumsAndSamples) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Complex> exponents;
    for (int j = 0; j < 1 + trial % 6; ++j)
      exponents.emplace_back(-uniform(random) + (trial % 3 == 0 ? 0.5 : 0.0),
                             j % 3 == 2 ? 0.0 : std::exp(3 * uniform(random)));
    Sum sum(exponents);
    sum.form.differentiated = trial % 2 == 1;
    sum.form.row.constant = normal(random);
    double curvature = 0;
    const double h = 3 * uniform(random);
    for (std::size_t j = 0; j < exponents.size(); ++j) {
      const auto column = static_cast<Index>(2 * j);
      sum.amplitudes.real[j] = normal(random);
      sum.amplitudes.imaginary[j] = exponents[j].imag() != 0 ? normal(random) : 0;
      sum.form.row.row[column] = normal(random);
      sum.form.row.row[column + 1] = exponents[j].imag() != 0 ? normal(random) : 0;
      curvature += 30 * std::pow(std::abs(exponents[j]), 3) + 1;
    }
    const Extent extent = sum.extent_over(h);
    double lowest = sum(0);
    double highest = lowest;
    constexpr int samples = 4000;
    for (int i = 0; i <= samples; ++i) {
      lowest = std::min(lowest, sum(h * i / samples));
      highest = std::max(highest, sum(h * i / samples));
    }
    const double missed = curvature * 8 * (h / samples) * (h / samples);
    EXPECT_LE(extent.minimum, lowest + 1e-12 * (1 + std::abs(lowest))) << trial;
    EXPECT_GE(extent.maximum, highest - 1e-12 * (1 + std::abs(highest))) << trial;
    EXPECT_GE(extent.minimum, lowest - missed) << trial;
    EXPECT_LE(extent.maximum, highest + missed) << trial;
  }
}

} // namespace
} // namespace vibroimpact::integration
