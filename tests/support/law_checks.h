// What every contact law must satisfy, whatever its physics: derivatives, power balance, affine
// forms, and guards that are positive while their mode holds.
#pragma once

#include "contact/contact_law.h"
#include "motion/interval/observer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace vibroimpact::testing {

/// One state of a law with its mode.
struct LawPoint {
  int mode = 0;
  double gap = 0;
  double gap_rate = 0;
  std::vector<double> internal{};

  contact::LocalState state() const {
    return {.gap = gap, .gap_rate = gap_rate, .internal = internal};
  }
  /// Variable 0 is the gap, 1 its rate, the others are the internal states.
  double &variable(std::size_t i) { return i == 0 ? gap : i == 1 ? gap_rate : internal[i - 2]; }
};

inline contact::LawResponse response_of(const contact::ContactLaw &law, const LawPoint &point) {
  contact::LawResponse response;
  law.evaluate(point.mode, point.state(), response);
  return response;
}

/// Derivative of `value(response)` by a variable: central differences with one Richardson step.
template <class Value>
double derivative(const contact::ContactLaw &law, const LawPoint &point, std::size_t variable,
                  Value value) {
  LawPoint at = point;
  const double h = 1e-3 * std::max(std::abs(at.variable(variable)), 1e-6);
  const auto slope = [&](double step) {
    LawPoint up = point;
    LawPoint down = point;
    up.variable(variable) += step;
    down.variable(variable) -= step;
    return (value(response_of(law, up)) - value(response_of(law, down))) / (2 * step);
  };
  return (4 * slope(h / 2) - slope(h)) / 3;
}

inline void expect_relative(double actual, double expected, double scale, const std::string &what) {
  EXPECT_NEAR(actual, expected, 1e-8 * (std::abs(expected) + scale)) << what;
}

/// All partial derivatives that the law reports, against differences of what it reports.
inline void check_derivatives(const contact::ContactLaw &law, const LawPoint &point) {
  const contact::LawResponse at = response_of(law, point);
  const auto n = static_cast<std::size_t>(law.n_internal());
  const auto force = [](const contact::LawResponse &r) { return r.force; };
  const std::string where = law.name() + ", mode " + std::to_string(point.mode);
  for (std::size_t v = 0; v < n + 2; ++v) {
    const double reported = v == 0   ? at.force_by_gap
                            : v == 1 ? at.force_by_gap_rate
                                     : at.force_by_internal[v - 2];
    expect_relative(reported, derivative(law, point, v, force), 1e-3, where + ": force");
    for (std::size_t i = 0; i < n; ++i) {
      const auto rate = [i](const contact::LawResponse &r) { return r.internal_rate[i]; };
      const double rate_slope = v == 0   ? at.internal_rate_by_gap[i]
                                : v == 1 ? at.internal_rate_by_gap_rate[i]
                                         : at.internal_rate_by_internal[i * n + v - 2];
      expect_relative(rate_slope, derivative(law, point, v, rate), 1e-3, where + ": rate");
    }
  }
}

/// What the force takes from the motion, -F gap_rate, is stored or dissipated.
inline void check_power(const contact::ContactLaw &law, const LawPoint &point) {
  const contact::LawResponse at = response_of(law, point);
  const auto energy = [](const contact::LawResponse &r) { return r.stored_energy; };
  double stored = derivative(law, point, 0, energy) * point.gap_rate;
  for (std::size_t i = 0; i < point.internal.size(); ++i)
    stored += derivative(law, point, i + 2, energy) * at.internal_rate[i];
  const std::string where = law.name() + ", mode " + std::to_string(point.mode);
  expect_relative(-at.force * point.gap_rate, stored + at.dissipated_power,
                  std::abs(stored) + std::abs(at.dissipated_power), where);
}

/// The affine form of a mode says what evaluate() does.
inline void check_affine(const contact::ContactLaw &law, const LawPoint &point) {
  const auto &affine = law.modes()[static_cast<std::size_t>(point.mode)].affine;
  if (!affine)
    return;
  const contact::LawResponse at = response_of(law, point);
  EXPECT_DOUBLE_EQ(affine->force(point.state()), at.force) << law.name();
  ASSERT_EQ(affine->internal_rate.size(), point.internal.size()) << law.name();
  for (std::size_t i = 0; i < point.internal.size(); ++i)
    EXPECT_DOUBLE_EQ(affine->internal_rate[i](point.state()), at.internal_rate[i]) << law.name();
}

inline void check_law(const contact::ContactLaw &law, const LawPoint &point) {
  check_derivatives(law, point);
  check_power(law, point);
  check_affine(law, point);
}

/// Watches a motion: each guard is positive while its mode holds, up to 1e-8 of the largest value
/// it has there: ten times the relative tolerance that the polynomial of a step is held to, of
/// which a guard combines several.
class GuardWatch : public motion::Observer {
public:
  GuardWatch() = default;
  GuardWatch(const GuardWatch &) = delete;
  GuardWatch &operator=(const GuardWatch &) = delete;
  ~GuardWatch() override {
    for (const auto &[where, extent] : ranges_)
      EXPECT_GE(extent.first, -1e-8 * extent.second)
          << "contact " << where[0] << ", mode " << where[1] << ", guard " << where[2];
  }
  void step(const motion::StepView &view) override {
    const motion::Equations &equations = view.equations();
    for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
      const auto mode = static_cast<std::size_t>(equations.modes()[c]);
      const auto &guards = equations.contacts().pairs()[c].law->modes()[mode].guards;
      for (std::size_t g = 0; g < guards.size(); ++g) {
        const motion::Bernstein indicator = view.indicator(c, guards[g].indicator);
        auto &[lowest, highest] = ranges_[{c, mode, g}];
        lowest = std::min(lowest, indicator.end());
        highest = std::max(highest, indicator.maximum());
      }
    }
  }

private:
  std::map<std::array<std::size_t, 3>, std::pair<double, double>> ranges_;
};

} // namespace vibroimpact::testing
