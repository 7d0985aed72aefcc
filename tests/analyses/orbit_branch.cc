// Branches of periodic motions as an analysis: the S-curve of the isolator with its folds, against
// an independent shooting solver, and a linear vibration in closed form.
#include "analyses/curves/orbit_branch.h"

#include "analyses/keys/keyed_map.h"
#include "common/error.h"
#include "support/isolator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact::analyses {
namespace orbit_branch_tests {

using testing::field_of;
using testing::isolator_system;
using testing::IsolatorPoint;
using testing::value_of;

constexpr double pi = std::numbers::pi;

OrbitBranch::Settings along_frequency(double first, double last) {
  OrbitBranch::Settings settings{
      .parameter = {.path = {}, .values = {first / (2 * pi), last / (2 * pi)}},
      .start = {.state = {0, 0}},
      .excitation = {}};
  settings.continuation.first_key = {.lower = settings.parameter.values[0],
                                     .upper = settings.parameter.values[1]};
  return settings;
}

PointResult run(const OrbitBranch::Settings &settings, System system) {
  IsolatorPoint point(1.3);
  OrbitBranch(settings).run_line(0, system, point);
  return point.result;
}

std::vector<double> places(const PointResult &result, double kind, const std::string &key) {
  std::vector<double> found;
  if (!testing::has_field(result, "special/kind"))
    return found;
  const std::vector<double> &kinds = field_of(result, "special/kind").values;
  for (std::size_t i = 0; i < kinds.size(); ++i)
    if (kinds[i] == kind)
      found.push_back(field_of(result, "special/" + key).values[i]);
  std::sort(found.begin(), found.end());
  return found;
}

// A trial step may ask for one, and the next one must find its way back.
TEST(OrbitBranchTest, FrequenciesThatAreNoneLeaveTheMapAsItWas) {
  System system = isolator_system(1.3, 2);
  const IsolatorPoint context(1.3);
  const OrbitBranch::Settings settings = along_frequency(1, 2);
  KeyedMap maps({settings.parameter}, "", system, context,
                {.scale = Vector::Ones(2), .tolerance = 1e-10}, 1);
  for (const double none : {0.0, -0.2, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(maps.at(Vector::Constant(1, none)), NumericalError);
  EXPECT_NEAR(maps.at(Vector::Constant(1, 0.2)).period(), 5, 1e-12);
}

TEST(OrbitBranchTest, FoldsOfTheIsolator) {
  struct Row {
    double mu;
    std::vector<double> folds;
    double tolerance;
  };
  const Row rows[] = {{0.5, {}, 0},
                      {1, {1.226409, 1.242077}, 6e-7},
                      {2, {1.23127927195557, 1.36274825262772}, 1e-10},
                      {5, {1.232439, 1.651114}, 6e-7}};
  for (const Row &row : rows) {
    const PointResult result = run(along_frequency(0.6, 2), isolator_system(1.9, row.mu));
    ASSERT_EQ(result.status, Status::finished) << result.reason;
    const std::vector<double> folds = places(result, 1, "frequency");
    ASSERT_EQ(folds.size(), row.folds.size()) << row.mu;
    for (std::size_t i = 0; i < folds.size(); ++i)
      EXPECT_NEAR(2 * pi * folds[i], row.folds[i], row.tolerance) << row.mu;
  }
}

// Between the folds the motions are unstable; at both ends of the frequency they are stable.
TEST(OrbitBranchTest, StabilityChangesAtTheFolds) {
  const PointResult result = run(along_frequency(0.6, 2), isolator_system(1.9, 2));
  const std::vector<double> &stable = field_of(result, "stable").values;
  int changes = 0;
  for (std::size_t i = 1; i < stable.size(); ++i)
    changes += stable[i] != stable[i - 1] ? 1 : 0;
  EXPECT_EQ(changes, 2);
  EXPECT_EQ(stable.front(), 1);
  EXPECT_EQ(stable.back(), 1);
  const Field &peak = field_of(result, "special/point/block.head/displacement_x/largest");
  std::vector<double> at_folds;
  for (std::size_t i = 0; i < peak.values.size(); ++i)
    if (field_of(result, "special/kind").values[i] == 1)
      at_folds.push_back(peak.values[i]);
  std::sort(at_folds.begin(), at_folds.end());
  ASSERT_EQ(at_folds.size(), 2u);
  EXPECT_NEAR(at_folds[0], 1.0203894, 1e-6);
  EXPECT_NEAR(at_folds[1], 1.9268029, 1e-6);
  EXPECT_EQ(field_of(result, "end/reason").values, (std::vector<double>{0, 1}));
}

// The same fold over the stiffness of the stop: along mu at the frequency of a fold for mu = 2.
TEST(OrbitBranchTest, FoldAlongAnotherKey) {
  OrbitBranch::Settings settings = along_frequency(1, 2);
  settings.parameter = {.path = "Contact/right/Stiffness", .unit = "1", .values = {1, 4}};
  settings.continuation.first_key = {.lower = 1, .upper = 4};
  settings.start_value = 2.5;
  settings.start.state = {-1.9, 1.0};
  const double lambda = 1.36274825262772;
  IsolatorPoint point(lambda);
  System system = isolator_system(lambda, 2.5);
  OrbitBranch(settings).run_line(0, system, point);
  ASSERT_EQ(point.result.status, Status::finished) << point.result.reason;
  const std::vector<double> folds = places(point.result, 1, "Contact.right.Stiffness");
  ASSERT_EQ(folds.size(), 1u);
  EXPECT_NEAR(folds[0], 2, 1e-9);
}

// Beyond its ends the key has no systems, nor are there any for differences. The branch turns on
// the way.
TEST(OrbitBranchTest, GoesToTheEndsThatItsKeyAllows) {
  class Limited : public IsolatorPoint {
  public:
    using IsolatorPoint::IsolatorPoint;
    System build(const std::vector<parameters::Override> &overrides) const override {
      const double mu = std::stod(overrides.at(0).value);
      if (mu < 1.1 || mu > 2.9)
        throw InputError("mu must be between 1.1 and 2.9");
      return IsolatorPoint::build(overrides);
    }
  };
  OrbitBranch::Settings settings = along_frequency(1, 2);
  settings.parameter = {.path = "Contact/right/Stiffness", .unit = "1", .values = {1.1, 2.9}};
  settings.continuation.first_key = {.lower = 1.1, .upper = 2.9};
  settings.start_value = 2.5;
  settings.start.state = {-1.9, 1.0};
  Limited point(1.3);
  System system = isolator_system(1.3, 2.5);
  OrbitBranch(settings).run_line(0, system, point);
  ASSERT_EQ(point.result.status, Status::finished) << point.result.reason;
  EXPECT_EQ(point.result.reason, "");
  const std::vector<double> &mu = field_of(point.result, "Contact.right.Stiffness").values;
  EXPECT_EQ(mu.front(), 2.9);
  EXPECT_EQ(mu.back(), 2.9);
  EXPECT_EQ(field_of(point.result, "end/reason").values, (std::vector<double>{1, 1}));
}

// A free mass may be anywhere; one on a spring may not.
TEST(OrbitBranchTest, FailuresOfAFreeBodyNameItsMotion) {
  const NumericalError why("Newton's method diverges");
  for (const double stiffness : {0.0, 1.0}) {
    const System system =
        testing::system_of(model::Model({testing::single_mass("block", 1, stiffness, 0.1),
                                         testing::single_mass("other", 2, 3, 0.1)}));
    const std::string said = no_orbit(system, why).what();
    EXPECT_EQ(said.find(why.what()), 0u);
    EXPECT_EQ(said.find("against the motion of block.head along x") != std::string::npos,
              stiffness == 0)
        << said;
  }
}

// A recorder that fails leaves the motions, with what has failed as the reason.
TEST(OrbitBranchTest, MotionsThatAreNotRecordedSayWhy) {
  class Failing : public Recorder {
  public:
    void begin(const Window & /*window*/, const motion::Trajectory & /*trajectory*/) override {
      throw NumericalError("the pen is broken");
    }
    void add_fields(const FieldWriter & /*result*/) const override {}
  };
  OrbitBranch::Settings settings = along_frequency(1.8, 2);
  settings.recorders = {[](const System & /*system*/) { return std::make_unique<Failing>(); }};
  const PointResult result = run(settings, isolator_system(1.9, 2));
  ASSERT_EQ(result.status, Status::finished) << result.reason;
  const std::vector<double> &recorded = field_of(result, "recorded").values;
  EXPECT_EQ(recorded, std::vector<double>(field_of(result, "frequency").values.size(), 0));
  EXPECT_NE(result.reason.find("is not recorded: the pen is broken"), std::string::npos)
      << result.reason;
  EXPECT_EQ(field_of(run(along_frequency(1.8, 2), isolator_system(1.9, 2)), "recorded").values[0],
            1);
}

TEST(OrbitBranchTest, LinearVibrationInClosedForm) {
  model::Model model({testing::single_mass("block", 2, 30, 0.6)});
  model.add_force("push", std::make_shared<model::Harmonic>(model::Given::displacement, 5, 3.1, 0),
                  {}, Vector3::UnitX());
  const PointResult result = run(along_frequency(2, 6), testing::system_of(std::move(model)));
  ASSERT_EQ(result.status, Status::finished) << result.reason;
  const std::vector<double> &frequency = field_of(result, "frequency").values;
  const Field &peak = field_of(result, "point/block.head/displacement_x/largest");
  const Field &modulus = field_of(result, "multiplier_real");
  EXPECT_GE(frequency.size(), 10u);
  EXPECT_EQ(modulus.shape, (std::vector<std::size_t>{frequency.size(), 2}));
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    const double w = 2 * pi * frequency[i];
    EXPECT_NEAR(peak.values[i], 5 / std::hypot(30 - 2 * w * w, 0.6 * w), 1e-9) << w;
  }
  EXPECT_TRUE(std::is_sorted(frequency.begin(), frequency.end()));
  EXPECT_FALSE(testing::has_field(result, "special/kind"));
}

} // namespace orbit_branch_tests
} // namespace vibroimpact::analyses
