#include "output/beam_curve.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace vibroimpact::output {
namespace beam_curve_tests {

const Vector3 first(0.1, -0.2, 0.3);
const Vector3 second(0.5, 0.4, 0.9);

/// Any cubic deflection is reproduced: w(s) = s^3 - 2 s^2 + 0.3 s + 0.1 across the axis.
TEST(BeamCurve, CubicDeflectionIsExact) {
  const double length = (second - first).norm();
  const Vector3 axis = (second - first) / length;
  const Vector3 across = axis.cross(Vector3::UnitX()).normalized();
  const auto motion_at = [&](double s) {
    Vector6 motion;
    motion.head<3>() = (s * s * s - 2 * s * s + 0.3 * s + 0.1) * across;
    motion.tail<3>() = axis.cross((3 * s * s - 4 * s + 0.3) * across);
    return motion;
  };
  for (const double position : {0.0, 0.2, 0.5, 0.75, 1.0}) {
    const Vector6 motion = beam_curve(first, second, motion_at(0), motion_at(length), position);
    EXPECT_LT((motion - motion_at(position * length)).norm(), 1e-14) << position;
  }
}

TEST(BeamCurve, RigidMotionStaysRigid) {
  const Vector3 shift(1, 2, 3);
  const Vector3 turn(0.4, -0.1, 0.2);
  const auto motion_at = [&](const Vector3 &place) {
    Vector6 motion;
    motion << shift + turn.cross(place), turn;
    return motion;
  };
  const Vector3 middle = 0.7 * first + 0.3 * second;
  EXPECT_LT(
      (beam_curve(first, second, motion_at(first), motion_at(second), 0.3) - motion_at(middle))
          .norm(),
      1e-14);
}

TEST(BeamCurve, StretchAndTwistAreLinear) {
  const Vector3 axis = (second - first).normalized();
  Vector6 end;
  end << 2 * axis, 4 * axis;
  EXPECT_LT((beam_curve(first, second, Vector6::Zero(), end, 0.25) - 0.25 * end).norm(), 1e-14);
}

} // namespace beam_curve_tests
} // namespace vibroimpact::output
