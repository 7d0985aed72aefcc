// How much of an axis it is along which the two directions of a sweep differ.
#include "derived/operation.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::derived {

namespace {

/// The part of an axis that belongs to point i: half of the way to each neighbour.
double share(const std::vector<double> &x, std::size_t i) {
  const double before = i > 0 ? x[i] - x[i - 1] : 0;
  const double after = i + 1 < x.size() ? x[i + 1] - x[i] : 0;
  return (before + after) / 2;
}

bool differ(double one, double other, double tolerance) {
  return std::abs(one - other) > tolerance * std::max(std::abs(one), std::abs(other));
}

/// The forward and the backward part of a field.
struct Directions {
  Frame frame; ///< without the direction
  std::vector<Operand> parts;
};

Directions directions(const LabelledArray &array, std::size_t direction) {
  Operand forward = Frame({array}).operand(array);
  const std::size_t step = forward.strides[direction];
  const auto at = static_cast<std::ptrdiff_t>(direction);
  LabelledArray part = array;
  part.dimensions.erase(part.dimensions.begin() + at);
  part.shape.erase(part.shape.begin() + at);
  forward.strides.erase(forward.strides.begin() + at);
  Operand backward = forward;
  backward.values += step;
  return {Frame({part}), {forward, backward}};
}

} // namespace

DerivedArray hysteresis_width(const Request &request) {
  const LabelledArray array = request.array("Field");
  const Axis axis = request.along_one(array, true);
  const auto direction = array.find("direction");
  if (!direction || array.shape[*direction] != 2)
    request.section().reject("Field", "must be a field of a sweep in both directions");
  const auto [frame, parts] = directions(array, *direction);
  const std::size_t along = frame.position(axis.name);
  const auto [dimensions, shape] = frame.without(along);
  DerivedArray result = request.result(
      axis.unit, "how much of " + axis.name + " differs in " + array.name + " between directions",
      dimensions, shape);
  const double tolerance = request.section().quantity("Tolerance");
  for_each_line(frame, along, parts, [&](std::size_t k, const auto &lines) {
    for (std::size_t i = 0; i < axis.size(); ++i)
      if (!std::isnan(lines[0][i] + lines[1][i])) {
        const double width =
            differ(lines[0][i], lines[1][i], tolerance) ? share(axis.values, i) : 0;
        result.values[k] = std::isnan(result.values[k]) ? width : result.values[k] + width;
      }
  });
  return result;
}

} // namespace vibroimpact::derived
