#include "model/side.h"

#include <algorithm>

namespace vibroimpact {

Sides read_sides(const parameters::Values &section, const std::vector<std::string> &fixed,
                 const Model &model) {
  std::vector<std::string> ends = section.names("Between");
  if (ends.size() == 1)
    ends.push_back(fixed.front());
  const auto is_fixed = [&](const std::string &end) {
    return std::find(fixed.begin(), fixed.end(), end) != fixed.end();
  };
  if (ends.size() != 2 || ends[0] == ends[1] || is_fixed(ends[0]))
    section.reject("Between", "two different points as BODY.POINT, BODY.POINT; the second may be " +
                                  fixed[0] + " or " + fixed[1] + ".");
  std::vector<std::string> known = model.point_names();
  known.insert(known.end(), fixed.begin(), fixed.end());
  for (const std::string &end : ends)
    section.require_known("Between", end, known);
  return {.a = ends[0], .b = ends[1]};
}

Projection relative_displacement(const Sides &sides, const Vector3 &direction, const Model &model) {
  PointReference a;
  model.find_point(sides.a, a);
  Projection difference = model.displacement(a, direction, sides.b != side_base);
  difference.row *= -1;
  for (double &carrier : difference.carrier)
    carrier *= -1;
  PointReference b;
  if (!model.find_point(sides.b, b))
    return difference;
  const Projection other = model.displacement(b, direction, true);
  difference.row += other.row;
  for (std::size_t k = 0; k < difference.carrier.size(); ++k)
    difference.carrier[k] += other.carrier[k];
  return difference;
}

} // namespace vibroimpact
