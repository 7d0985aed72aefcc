// The recorder of stresses on motions in closed form.
#include "analyses/recorders/stresses.h"

#include "reduction/beam_bodies.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

#include <numbers>

namespace vibroimpact::analyses {
namespace stresses_tests {

using reduction::BodyPoint;
using reduction::ReducedBody;
using testing::has_field;
using testing::recorded;
using testing::value_of;

constexpr double pi = std::numbers::pi;

/// A square beam, so that it bends in two planes with the same frequencies, and its first modes.
std::shared_ptr<const ReducedBody> beam(int modes) {
  structure::BeamDefinition definition = examples::square_beam(10);
  definition.points.push_back({"root", {"start", {}}, 0, Vector3::Zero()});
  auto body = std::make_shared<ReducedBody>(examples::reduced(definition, modes));
  body->name = "beam";
  return body;
}

double von_mises(const Matrix &rows, const Vector &q) {
  const Vector stress = rows * q;
  double largest = 0;
  for (Index i = 0; i < stress.size(); i += 3)
    largest =
        std::max(largest, stress[i] * stress[i] - stress[i] * stress[i + 1] +
                              stress[i + 1] * stress[i + 1] + 3 * stress[i + 2] * stress[i + 2]);
  return std::sqrt(largest);
}

System moving(const std::shared_ptr<const ReducedBody> &body, const Vector &displacement) {
  System system = testing::system_of(model::Model({body}));
  system.initial.displacement = displacement;
  return system;
}

TEST(StressesTest, AVibrationInOneMode) {
  const auto body = beam(3);
  Vector q = Vector::Zero(3);
  q[2] = 1e-3;
  const double period = 2 * pi / body->omega()[2];
  // The window leaves out the start: the first peak inside comes after half a period.
  const PointResult result =
      recorded<Stresses>(moving(body, q), Window{.end = 0.6 * period}, std::vector<std::string>{});
  const double expected = von_mises(body->point("root").stress, q);
  EXPECT_GT(expected, 1e6);
  EXPECT_NEAR(value_of(result, "point/beam.root/von_mises_stress/maximum") / expected, 1, 1e-12);
}

// Tension along one axis, compression across it, and shear: 2, -1 and 0.5 give the root of 7.75.
TEST(StressesTest, AllComponentsTogether) {
  const auto body = std::make_shared<ReducedBody>(*beam(1));
  for (BodyPoint &point : body->points)
    point.stress = Eigen::Vector3d(2e9, -1e9, 0.5e9);
  const double period = 2 * pi / body->omega()[0];
  const PointResult result =
      recorded<Stresses>(moving(body, Vector::Constant(1, 1e-3)), Window{.end = 0.6 * period},
                         std::vector<std::string>{"beam.root"});
  EXPECT_NEAR(value_of(result, "point/beam.root/von_mises_stress/maximum"), std::sqrt(7.75) * 1e6,
              1e-6);
}

// The same growing through many short steps: what was seen before must hide nothing of what comes.
TEST(StressesTest, AllComponentsThatGrowStepByStep) {
  const auto body = std::make_shared<ReducedBody>(*beam(1));
  for (BodyPoint &point : body->points)
    point.stress = Eigen::Vector3d(2e9, -1e9, 0.5e9);
  const double omega = body->omega()[0];
  System system = moving(body, Vector::Zero(1));
  system.initial.velocity[0] = 1e-3 * omega;
  const double end = 0.5 * pi / omega; // the first peak of the sine
  const PointResult result = recorded<Stresses>(system, periods_window(0, end / 40, 40),
                                                std::vector<std::string>{"beam.root"});
  EXPECT_NEAR(value_of(result, "point/beam.root/von_mises_stress/maximum"), std::sqrt(7.75) * 1e6,
              1e-6);
}

// Modes of different frequency: the largest stress is somewhere between, in any fibre.
TEST(StressesTest, SeveralModesTogether) {
  const auto body = beam(6);
  Vector q = Vector::Zero(6);
  q[0] = 1e-3;
  q[2] = 3e-4;
  q[3] = -2e-4;
  q[5] = 1e-4;
  const double end = 1.3 * 2 * pi / body->omega()[0];
  double expected = 0;
  for (int i = 0; i <= 100000; ++i)
    expected =
        std::max(expected,
                 von_mises(body->point("root").stress,
                           (q.array() * (body->omega().array() * (end * i / 1e5)).cos()).matrix()));
  const PointResult result = recorded<Stresses>(moving(body, q), Window{.end = end},
                                                std::vector<std::string>{"beam.root"});
  EXPECT_NEAR(value_of(result, "point/beam.root/von_mises_stress/maximum") / expected, 1, 1e-7);
  EXPECT_FALSE(has_field(result, "point/beam.head/von_mises_stress/maximum"));
}

TEST(StressesTest, LumpedBodiesHaveNone) {
  const System system = testing::system_of(testing::linked_block());
  const PointResult result =
      recorded<Stresses>(system, Window{.end = 1}, std::vector<std::string>{});
  EXPECT_TRUE(result.fields.empty());
}

} // namespace stresses_tests
} // namespace vibroimpact::analyses
