// Branches, loci and harmonic balances that go on from the steps of a run that was killed: the same
// numbers, and only the rest computed.
#include "analyses/curves/balance_branch.h"
#include "analyses/curves/orbit_branch.h"
#include "analyses/curves/orbit_locus.h"
#include "support/isolator.h"
#include "support/steps_in_memory.h"

#include <gtest/gtest.h>

#include <cstring>
#include <numbers>

namespace vibroimpact::analyses {
namespace resumed_curves_tests {

using testing::field_of;
using testing::first_of;
using testing::StepsInMemory;

constexpr double pi = std::numbers::pi;

enum class Stops { both, right };

/// The isolator, or with a single stop that takes no energy.
System oscillator(double lambda, double mu, double f, Stops stops) {
  System system = testing::isolator_system(lambda, mu, f);
  if (stops == Stops::right)
    system.contacts = contact::ContactSet({testing::contact_along_x(
        system.model, "block.head", "", 1, std::make_shared<contact::BilinearStop>(mu, 0.0))});
  return system;
}

/// One point of oscillators whose keys are "mu" and "f".
class Resumed : public LineContext {
public:
  Resumed(double lambda, double mu, double f, Stops stops)
      : lambda_(lambda), mu_(mu), f_(f), stops_(stops) {}
  const PointResult *find(const std::vector<std::size_t> & /*index*/) const override {
    return nullptr;
  }
  void store(PointResult stored) override { result = std::move(stored); }
  void skip() override {}
  System build(const std::vector<parameters::Override> &overrides) const override {
    double mu = mu_, f = f_;
    for (const parameters::Override &one : overrides)
      (one.path == "mu" ? mu : f) = std::stod(one.value);
    return oscillator(lambda_, mu, f, stops_);
  }
  std::unique_ptr<StepRecord> steps(const std::vector<std::size_t> & /*index*/) override {
    return std::make_unique<testing::HandedSteps>(known, fresh);
  }
  System system() const { return oscillator(lambda_, mu_, f_, stops_); }

  PointResult result;
  std::vector<std::string> known, fresh;

private:
  double lambda_, mu_, f_;
  Stops stops_;
};

void expect_same(const PointResult &one, const PointResult &other) {
  EXPECT_EQ(one.status, other.status);
  EXPECT_EQ(one.reason, other.reason);
  ASSERT_EQ(one.fields.size(), other.fields.size());
  for (std::size_t i = 0; i < one.fields.size(); ++i) {
    const Field &a = one.fields[i], &b = other.fields[i];
    EXPECT_EQ(a.label, b.label);
    EXPECT_EQ(a.shape, b.shape);
    ASSERT_EQ(a.values.size(), b.values.size()) << a.name();
    EXPECT_EQ(std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(double)), 0)
        << a.name();
  }
}

/// Behind some of its steps and behind all of them.
void expect_goes_on(const Analysis &analysis, const Resumed &plan) {
  Resumed whole = plan;
  System system = whole.system();
  analysis.run_line(0, system, whole);
  ASSERT_EQ(whole.result.status, Status::finished) << whole.result.reason;
  const std::size_t all = whole.fresh.size();
  ASSERT_GT(all, 20u);
  for (int part = 0; part <= 12; ++part) {
    const std::size_t kept = all * static_cast<std::size_t>(part) / 12;
    Resumed rest = plan;
    rest.known = first_of(whole.fresh, kept);
    System again = rest.system();
    analysis.run_line(0, again, rest);
    expect_same(rest.result, whole.result);
    EXPECT_EQ(rest.fresh.size(), all - kept);
  }
}

SweptParameter frequency(double first, double last) {
  return {.path = {}, .values = {first / (2 * pi), last / (2 * pi)}};
}
SweptParameter key(const std::string &path, double first, double last) {
  return {.path = path, .unit = "1", .values = {first, last}};
}
continuation::Range range(const SweptParameter &key) {
  return {.lower = key.values[0], .upper = key.values[1]};
}

OrbitBranch branch(const SweptParameter &parameter, double start, long levels) {
  OrbitBranch::Settings settings{.parameter = parameter,
                                 .start_value = start,
                                 .start = {.state = {0, 0}},
                                 .levels = levels,
                                 .excitation = {}};
  settings.continuation.first_key = range(parameter);
  return OrbitBranch(settings);
}

TEST(ResumedCurvesTest, BranchOverTheFrequency) {
  expect_goes_on(branch(frequency(0.6, 2), 0, 0), {1.9, 2, 0.52, Stops::both});
}

TEST(ResumedCurvesTest, BranchOverAnotherKey) {
  expect_goes_on(branch(key("mu", 0.5, 5), 2, 0), {1.3, 2, 0.52, Stops::both});
}

// The period doubles, and the branch of twice the period is followed too.
TEST(ResumedCurvesTest, BranchesThatBeginAtOthers) {
  const OrbitBranch doubling = branch(frequency(1.5, 4), 0, 1);
  const Resumed plan(1.6, 20, 4, Stops::right);
  Resumed one = plan;
  System system = one.system();
  doubling.run_line(0, system, one);
  const std::vector<double> &number = field_of(one.result, "branch").values;
  ASSERT_GT(*std::max_element(number.begin(), number.end()), 0);
  expect_goes_on(doubling, plan);
}

// The grazes pass the resonance at f = 0.02, where their instant moves by most of half a period.
TEST(ResumedCurvesTest, LociOfFoldsAndGrazes) {
  for (const LocusOf kind : {LocusOf::fold, LocusOf::graze}) {
    OrbitLocus::Settings settings{.keys = {frequency(0.5, 2), kind == LocusOf::fold
                                                                  ? key("mu", 0.5, 3)
                                                                  : key("f", 0.01, 0.9)},
                                  .start_values = {0, kind == LocusOf::fold ? 2 : 0.52},
                                  .kinds = {kind},
                                  .start = {.state = {0, -1}},
                                  .excitation = {}};
    settings.continuation.first_key = range(settings.keys[0]);
    settings.continuation.second_key = range(settings.keys[1]);
    expect_goes_on(OrbitLocus(settings), {1.3, 2, 0.52, Stops::both});
  }
}

TEST(ResumedCurvesTest, HarmonicBalance) {
  BalanceBranch::Settings settings{
      .parameter = frequency(0.6, 2), .harmonics = 5, .guess = {}, .excitation = {}};
  settings.continuation.first_key = range(settings.parameter);
  expect_goes_on(BalanceBranch(settings), {1.9, 2, 0.52, Stops::both});
}

} // namespace resumed_curves_tests
} // namespace vibroimpact::analyses
