#include "model/side.h"

#include <algorithm>

namespace vibroimpact::model {

Sides read_sides(const parameters::Values &section, const std::vector<std::string> &fixed,
                 std::vector<std::string> known, const std::string &form) {
  section.require("Between");
  std::vector<std::string> ends = section.names("Between");
  if (ends.size() == 1 && !fixed.empty())
    ends.push_back(fixed.front());
  const auto is_fixed = [&](const std::string &end) {
    return std::find(fixed.begin(), fixed.end(), end) != fixed.end();
  };
  if (ends.size() != 2 || is_fixed(ends[0]))
    section.reject(
        "Between",
        "Between must be two different " + form +
            (fixed.empty() ? "." : "; the second may be " + fixed[0] + " or " + fixed[1] + "."));
  known.insert(known.end(), fixed.begin(), fixed.end());
  for (const std::string &end : ends)
    section.require_known("Between", end, known);
  return {.a = ends[0], .b = ends[1]};
}

Sides read_sides(const parameters::Values &section, const std::vector<std::string> &fixed,
                 const Model &model) {
  return read_sides(section, fixed, model.point_names(), "points as BODY.POINT, BODY.POINT");
}

Projection relative_displacement(const PointReference &a, const std::optional<PointReference> &b,
                                 bool absolute, const MotionAxis &axis, const Model &model) {
  Projection difference = model.displacement(a, axis, absolute);
  difference.row *= -1;
  for (double &base_coefficients : difference.base_coefficients)
    base_coefficients *= -1;
  if (!b)
    return difference;
  const Projection other = model.displacement(*b, axis, true);
  difference.row += other.row;
  for (std::size_t k = 0; k < difference.base_coefficients.size(); ++k)
    difference.base_coefficients[k] += other.base_coefficients[k];
  return difference;
}

Projection relative_displacement(const Sides &sides, const MotionAxis &axis, const Model &model) {
  PointReference a;
  model.find_point(sides.a, a);
  PointReference b;
  const bool two_points = model.find_point(sides.b, b);
  return relative_displacement(a, two_points ? std::optional(b) : std::nullopt,
                               sides.b != side_base, axis, model);
}

} // namespace vibroimpact::model
