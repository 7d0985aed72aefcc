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

} // namespace vibroimpact::model
