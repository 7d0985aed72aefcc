// The force of a contact along a Fourier series of its gap, for every law: against the law itself
// at many instants, and its derivative against differences.
#include "periodic/harmonic_contact.h"

#include "common/error.h"
#include "contact/laws/bilinear_stop.h"
#include "contact/laws/crushable_table.h"
#include "contact/laws/formula.h"
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/kuwabara_kono.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/table.h"
#include "contact/laws/tsuji.h"
#include "continuation/harmonic_series.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::periodic {
namespace harmonic_contacts_tests {

using std::numbers::pi;

struct Case {
  const char *name;
  std::shared_ptr<const contact::ContactLaw> law;
  double slope_error = 1e-7; ///< of derivatives, over the largest
};

void PrintTo(const Case &shown, std::ostream *out) { *out << shown.name; }

contact::ContactPair pair_of(std::shared_ptr<const contact::ContactLaw> law) {
  contact::ContactPair pair;
  pair.name = "stop";
  pair.law = std::move(law);
  return pair;
}

// Below zero twice in a period, in contact at phase 0.
RowVector gap_of(Index harmonics) {
  RowVector gap = RowVector::Zero(2 * harmonics + 1);
  gap.head(7) << 0.1, -0.3, 0.15, 0.2, -0.35, 0.07, 0.11;
  return gap;
}

/// Force at a phase by the law with equal steps from contact change to contact change.
class Stepped {
public:
  Stepped(const contact::ContactLaw &law, const RowVector &gap, double frequency)
      : law_{law}, gap_{gap},
        frequency_{frequency}, rate_{frequency * gap * continuation::harmonic_rate(gap.size() / 2)},
        internal_{law.initial_internal()} {}

  // Explicit steps of second order; modes change at the end of one.
  std::pair<RowVector, double> series() {
    constexpr int steps = 40000;
    RowVector force = RowVector::Zero(gap_.size());
    double largest = 0;
    mode_ = settle(law_, state(0)).mode;
    for (int i = 0; i < 2 * steps; ++i) {
      const double phase = 2 * pi * (i + 0.5) / steps, half = pi / steps / frequency_;
      advance(phase - pi / steps, half);
      const contact::LawResponse at = advance(phase, half);
      const Vector basis = continuation::harmonic_basis(phase, gap_.size() / 2);
      if (i >= steps) {
        force += at.force * continuation::harmonic_projection(basis).transpose() * (2 * pi / steps);
        largest = std::max(largest, at.force);
      }
    }
    return {force, largest};
  }

private:
  contact::LocalState state(double phase) const {
    const Vector basis = continuation::harmonic_basis(phase, gap_.size() / 2);
    return {.gap = gap_.dot(basis), .gap_rate = rate_.dot(basis), .internal = internal_};
  }
  contact::LawResponse advance(double phase, double time) {
    change(phase);
    contact::LawResponse at;
    law_.evaluate(mode_, state(phase), at);
    for (std::size_t k = 0; k < internal_.size(); ++k)
      internal_[k] += time * at.internal_rate[k];
    return at;
  }
  void change(double phase) {
    for (int k = 0; k < 4; ++k)
      for (const contact::Guard &guard : law_.modes()[static_cast<std::size_t>(mode_)].guards)
        if (guard.indicator(state(phase)) < 0) {
          std::vector<double> internal = internal_;
          for (std::size_t i = 0; i < guard.reset.size(); ++i)
            internal[i] = guard.reset[i](state(phase));
          internal_ = internal;
          mode_ = guard.target;
          break;
        }
  }

  const contact::ContactLaw &law_;
  RowVector gap_;
  double frequency_;
  RowVector rate_;
  std::vector<double> internal_;
  int mode_ = 0;
};

class HarmonicContactsTable : public ::testing::TestWithParam<Case> {};

TEST_P(HarmonicContactsTable, force_of_the_law) {
  const contact::ContactPair pair = pair_of(GetParam().law);
  const RowVector gap = gap_of(5);
  const HarmonicGrid grid(5, 20);
  const double frequency = 1.7;
  const ContactSeries series = contact_series(pair, gap, frequency, grid);
  const auto [expected, largest] = Stepped(*pair.law, gap, frequency).series();
  EXPECT_GT(expected.norm(), 0.1);
  EXPECT_LT((series.force - expected).norm(), 2e-4 * expected.norm());
  EXPECT_NEAR(series.largest, largest, 2e-3 * largest);
}

TEST_P(HarmonicContactsTable, derivative) {
  const contact::ContactPair pair = pair_of(GetParam().law);
  const RowVector gap = gap_of(3);
  const HarmonicGrid grid(3, 24);
  const Matrix slope = contact_series(pair, gap, 1.7, grid).by_gap;
  const auto force = [&](Index i, double by) {
    RowVector moved = gap;
    moved(i) += by;
    return contact_series(pair, moved, 1.7, grid).force;
  };
  const double h = 1e-4;
  for (Index i = 0; i < gap.size(); ++i) {
    const RowVector difference =
        (8 * (force(i, h) - force(i, -h)) - force(i, 2 * h) + force(i, -2 * h)) / (12 * h);
    EXPECT_LT((slope.col(i).transpose() - difference).norm(), GetParam().slope_error * slope.norm())
        << i;
  }
}

contact::HertzConstants hertz() { return {.stiffness = 20, .exponent = 1.5}; }

std::shared_ptr<const contact::ContactLaw> comes_back() {
  return std::make_shared<contact::CrushableTable>(
      contact::CrushCurves(contact::ForceCurve({0, 0.3, 0.9}, {0, 12, 20}),
                           contact::ForceCurve({0, 0.5, 0.9}, {0, 2, 7}), 60));
}

std::shared_ptr<const contact::FormulaLaw> formula(const std::string &text,
                                                   double largest_penetration = 5) {
  return std::make_shared<contact::FormulaLaw>(parameters::Formula(text, {}, {"x", "v"}),
                                               largest_penetration, contact::Tension::refused);
}

INSTANTIATE_TEST_SUITE_P(
    of, HarmonicContactsTable,
    ::testing::Values(
        Case{"linear_penalty", std::make_shared<contact::LinearPenalty>(30)},
        Case{"bilinear_stop", std::make_shared<contact::BilinearStop>(30, 2)},
        Case{"kelvin_voigt", std::make_shared<contact::KelvinVoigt>(30, 4)},
        Case{"kelvin_voigt_bumper", std::make_shared<contact::KelvinVoigtBumper>(30, 20)},
        Case{"hertz", std::make_shared<contact::Hertz>(hertz()), 1e-4},
        Case{"hunt_crossley", contact::HuntCrossley::with_dissipation(hertz(), 0.4), 1e-4},
        Case{"hunt_crossley_of_each_impact",
             contact::HuntCrossley::with_dimensionless_damping(hertz(), 0.3, 1e-6), 1e-4},
        Case{"table",
             std::make_shared<contact::Table>(contact::ForceCurve({0, 0.2, 0.6}, {0, 4, 30}), 2,
                                              false)},
        Case{"table_that_comes_back", comes_back()},
        Case{"formula", formula("30*x + 20*x^2*(1 + 0.2*v)")},
        // Slopes that are infinite at the touch, u^(-3/4) and u^(-1/2), are integrated roughly.
        Case{"tsuji", std::make_shared<contact::Tsuji>(20, 1), 2e-2},
        Case{"kuwabara_kono", std::make_shared<contact::KuwabaraKono>(20, 0.1), 1e-2}),
    [](const auto &named) { return named.param.name; });

TEST(HarmonicContactsTest, AFormulaThatPullsOrEndsIsRefused) {
  for (const auto &law :
       {formula("20*x^1.5*(1 + 9*v)"), formula("20*x^1.5 + 90*x^2*v"), formula("20*x^1.5", 0.1)})
    EXPECT_THROW(contact_series(pair_of(law), gap_of(5), 1.7, {5, 20}), NumericalError);
}

// F = k max(0, cos phi - c) pushes where |phi| < p = acos c: a_0 = k (sin p - p c) / pi,
// a_h = 2 k / pi (...) in closed form.
TEST(HarmonicContactsTest, ElasticStopInClosedForm) {
  const double k = 3, c = 0.4, p = std::acos(c);
  RowVector gap = RowVector::Zero(11);
  gap(0) = c;
  gap(1) = -1;
  const ContactSeries series =
      contact_series(pair_of(std::make_shared<contact::LinearPenalty>(k)), gap, 1, {5, 20});
  EXPECT_NEAR(series.force(0), k / pi * (std::sin(p) - p * c), 1e-12);
  EXPECT_NEAR(series.force(1), k / pi * (p + std::sin(2 * p) / 2 - 2 * c * std::sin(p)), 1e-12);
  for (int h = 2; h <= 5; ++h) {
    const double expected = k / pi *
                            (std::sin((h - 1) * p) / (h - 1) + std::sin((h + 1) * p) / (h + 1) -
                             2 * c * std::sin(h * p) / h);
    EXPECT_NEAR(series.force(2 * h - 1), expected, 1e-12) << h;
    EXPECT_NEAR(series.force(2 * h), 0, 1e-12) << h;
  }
}

// A dip between the nodes is found: cos phi - c with a contact of 2 acos(c) = 0.02 rad.
TEST(HarmonicContactsTest, ShortContacts) {
  for (const double shift : {0.0, 0.1, 0.37, 1.0}) {
    const double p = 0.01;
    RowVector gap = RowVector::Zero(3);
    gap << std::cos(p), -std::cos(shift), -std::sin(shift);
    const ContactSeries series =
        contact_series(pair_of(std::make_shared<contact::LinearPenalty>(1)), gap, 1, {1, 16});
    EXPECT_NEAR(series.force(0), (std::sin(p) - p * std::cos(p)) / pi, 1e-14) << shift;
  }
}

TEST(HarmonicContactsTest, NodesOfGauss) {
  const Matrix &a = HarmonicGrid::collocation();
  for (int k = 0; k < HarmonicGrid::nodes; ++k) {
    const Vector power = HarmonicGrid::places().array().pow(k);
    const Vector integral = HarmonicGrid::places().array().pow(k + 1) / (k + 1);
    EXPECT_LT((a * power - integral).norm(), 1e-13) << k;
  }
  for (int k = 0; k < 2 * HarmonicGrid::nodes; ++k)
    EXPECT_NEAR(HarmonicGrid::weights().dot(Vector(HarmonicGrid::places().array().pow(k))),
                1.0 / (k + 1), 1e-14);
}

} // namespace harmonic_contacts_tests
} // namespace vibroimpact::periodic
