#include "model/direction.h"

#include <boost/algorithm/string.hpp>

#include <cmath>
#include <vector>

namespace vibroimpact::model {

std::optional<Vector3> parse_direction(const std::string &text) {
  std::string name = boost::trim_copy(text);
  const double sign = boost::starts_with(name, "-") ? -1 : 1;
  const std::string axis = boost::trim_left_copy_if(name, boost::is_any_of("+-"));
  if (axis.size() == 1 && axis[0] >= 'x' && axis[0] <= 'z')
    return sign * Vector3::Unit(axis[0] - 'x');
  std::vector<std::string> parts;
  boost::split(parts, name, boost::is_any_of(","));
  if (parts.size() != 3)
    return std::nullopt;
  Vector3 vector;
  for (int i = 0; i < 3; ++i) {
    const std::string part = boost::trim_copy(parts[i]);
    std::size_t used = 0;
    try {
      vector[i] = std::stod(part, &used);
    } catch (const std::exception &) {
      return std::nullopt;
    }
    if (used != part.size())
      return std::nullopt;
  }
  if (!(vector.norm() > 0) || !std::isfinite(vector.norm()))
    return std::nullopt;
  return vector.normalized();
}

Vector3 read_direction(const parameters::Values &values, const std::string &key) {
  const std::optional<Vector3> direction = parse_direction(values.text(key));
  if (!direction)
    values.reject(key, key + " must be x, y, z, -x, -y, -z or three numbers such as 1, 0, 1.");
  return *direction;
}

MotionAxis read_motion_axis(const parameters::Values &values, const std::string &key) {
  std::string text = boost::trim_copy(values.text(key));
  const auto letter = text.find('r');
  const bool rotation = letter != std::string::npos;
  if (rotation)
    text.erase(letter, 1);
  const std::optional<Vector3> direction = parse_direction(text);
  if (!direction || (rotation && text.find(',') != std::string::npos))
    values.reject(key, key + " must be x, y, z, -x, -y, -z or three numbers such as 1, 0, 1, or "
                             "for a rotation rx, ry, rz, -rx, -ry or -rz.");
  return {*direction, rotation};
}

void check_axis_keys(const parameters::Values &values, const MotionAxis &axis,
                     std::initializer_list<const char *> of_displacements,
                     std::initializer_list<const char *> of_rotations) {
  for (const char *key : axis.rotation ? of_displacements : of_rotations)
    if (values.given(key))
      values.reject(key, std::string(key) + " must not be set when Direction is that of a " +
                             (axis.rotation ? "rotation." : "displacement."));
}

} // namespace vibroimpact::model
