// The numbers of an isolator in any units, and what is taken from a branch that is known
// beforehand.
#include "analyses/isolators/isolator_branches.h"
#include "common/error.h"
#include "simulation.h"

#include <gtest/gtest.h>

namespace vibroimpact::analyses {
namespace isolator_branches_tests {

// m = 2 kg, k0 = 800 N/m: omega = 20 rad/s, critical damping 80 N s/m.
constexpr IsolatorSystem isolator{.mass = 2,
                                  .stiffness = 800,
                                  .damping = 0.8,
                                  .stop_stiffness = 200,
                                  .stop_damping = 16,
                                  .clearance = 0.002,
                                  .force = 0.832,
                                  .point = "isolator.mass",
                                  .axis = 'y'};

TEST(IsolatorBranchesTest, AnIsolatorHasDimensionlessNumbers) {
  EXPECT_DOUBLE_EQ(isolator.natural_frequency(), 20);
  EXPECT_DOUBLE_EQ(isolator.damping_ratios().isolator, 0.01);
  EXPECT_DOUBLE_EQ(isolator.damping_ratios().stop, 0.2);
  EXPECT_DOUBLE_EQ(isolator.stop().stiffness, 0.25);
  EXPECT_DOUBLE_EQ(isolator.stop().force, 0.52);
  EXPECT_DOUBLE_EQ(isolator.clearance_of({.stiffness = 1, .force = 1.04}), 0.001);
}

using Arrays = std::map<std::string, std::vector<double>>;

class KnownBranch : public Outcomes {
public:
  explicit KnownBranch(Arrays arrays) : arrays_(std::move(arrays)) {}
  void check(const std::string &, const std::vector<parameters::Override> &) const override {}
  Evaluated evaluate(const std::string &, const std::vector<parameters::Override> &overrides,
                     const std::vector<std::string> &names,
                     const std::function<void(double)> &progress) const override {
    progress(0.5);
    asked = overrides;
    Evaluated evaluated;
    for (const std::string &name : names) {
      Outcome outcome;
      outcome.values = arrays_.at(name);
      outcome.one.value = name.ends_with("frequency") ? 2 * M_PI : 1; // Hz
      evaluated.outcomes.push_back(outcome);
    }
    return evaluated;
  }
  mutable std::vector<parameters::Override> asked;

private:
  Arrays arrays_;
};

constexpr double hertz = 20 / (2 * M_PI); ///< of lambda = 1

Arrays turning_branch() {
  return {{"frequency", {hertz, 3 * hertz, 2 * hertz, 4 * hertz}},
          {"stable", {1, 1, 0, 1}},
          {"point/isolator.mass/displacement_y/maximum", {0.001, 0.002, 0.003, 0.001}},
          {"point/isolator.mass/displacement_y/minimum", {-0.001, -0.006, -0.003, -0.001}},
          {"end/reason", {0, 1}},
          {"special/frequency", {3.5 * hertz, 3.1 * hertz, 1.9 * hertz}},
          {"special/kind", {6, 1, 7}}};
}

IsolatorBranches branches() {
  const std::string text = R"(set Variables = k1 = 1, d = 1
subsection Analysis curve
  set Type = branch
end
subsection Analysis design
  set Type = isolator design
  subsection Isolator design
    set Repeat = curve
    set Stiffness key = Variables/k1
    set Clearance key = Variables/d
  end
end
)";
  const auto set =
      parameters::ParameterSet::parse(declare_parameters(), text, "test.prm", false, {});
  return IsolatorBranches(set->root().instance("Analysis", "design").subsection("Isolator design"));
}

ExactResponse follow(const Outcomes &outcomes, const StopChoice &stop) {
  return branches().follow(stop, isolator, outcomes, [](double) {});
}

TEST(IsolatorBranchesTest, FoldsAreThoseAndGrazingFoldsByFrequencyRatio) {
  const KnownBranch known(turning_branch());
  const ExactResponse exact = follow(known, {.stiffness = 2, .force = 1.04});
  ASSERT_EQ(exact.folds.size(), 2);
  EXPECT_NEAR(exact.folds[0], 1.9, 1e-14);
  EXPECT_NEAR(exact.folds[1], 3.1, 1e-14);
  EXPECT_NEAR(exact.ratios[3], 4, 1e-14);
  EXPECT_NEAR(exact.amplitudes[1], 6, 1e-12); // clearances of 1 mm, of the larger side
  EXPECT_NEAR(exact.peak, 6, 1e-12);
  EXPECT_EQ(exact.stable, (std::vector<double>{1, 1, 0, 1}));
  EXPECT_EQ(exact.failure, "");
  ASSERT_EQ(known.asked.size(), 2);
  EXPECT_EQ(known.asked[0].path, "Variables/k1");
  EXPECT_DOUBLE_EQ(std::stod(known.asked[0].value), 1600);
  EXPECT_DOUBLE_EQ(std::stod(known.asked[1].value), 0.001);
}

// Without a turn there may be no special point at all, and no array of them.
TEST(IsolatorBranchesTest, ABranchThatDoesNotTurnHasNoFolds) {
  Arrays arrays = turning_branch();
  arrays["frequency"] = {hertz, 2 * hertz, 3 * hertz, 4 * hertz};
  arrays.erase("special/frequency");
  arrays.erase("special/kind");
  EXPECT_TRUE(follow(KnownBranch(arrays), {.stiffness = 2, .force = 1}).folds.empty());
}

TEST(IsolatorBranchesTest, ABranchThatEndsEarlyIsAFailure) {
  Arrays arrays = turning_branch();
  arrays["end/reason"] = {0, 4};
  const ExactResponse exact = follow(KnownBranch(arrays), {.stiffness = 2, .force = 1});
  EXPECT_NE(exact.failure.find("end/reason of the branch: 4"), std::string::npos) << exact.failure;
}

} // namespace isolator_branches_tests
} // namespace vibroimpact::analyses
