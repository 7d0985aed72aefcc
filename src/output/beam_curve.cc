#include "output/beam_curve.h"

#include <Eigen/Geometry>

namespace vibroimpact::output {

Vector6 beam_curve(const Vector3 &first, const Vector3 &second, const Vector6 &motion_first,
                   const Vector6 &motion_second, double position) {
  const double length = (second - first).norm();
  const Vector3 axis = (second - first) / length;
  const double x = position;
  const double y = 1 - position;
  const Vector6 linear = y * motion_first + x * motion_second;

  // A rotation r turns the axis by r x axis, the slope of the deflection.
  const Vector3 slope_first = motion_first.tail<3>().cross(axis);
  const Vector3 slope_second = motion_second.tail<3>().cross(axis);
  const Vector3 difference = motion_second.head<3>() - motion_first.head<3>();
  const Vector3 cubic = y * y * (1 + 2 * x) * motion_first.head<3>() +
                        x * x * (1 + 2 * y) * motion_second.head<3>() +
                        length * x * y * (y * slope_first - x * slope_second);
  const Vector3 slope = 6 * x * y / length * difference + y * (1 - 3 * x) * slope_first +
                        x * (1 - 3 * y) * slope_second;

  const auto along = [&](const Vector3 &vector) -> Vector3 { return vector.dot(axis) * axis; };
  Vector6 motion;
  motion.head<3>() = along(linear.head<3>()) + cubic - along(cubic);
  motion.tail<3>() = along(linear.tail<3>()) + axis.cross(slope);
  return motion;
}

} // namespace vibroimpact::output
