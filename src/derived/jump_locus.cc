// Where a field changes most from one point of an axis to the next.
#include "derived/operation.h"

#include <cmath>

namespace vibroimpact::derived {

DerivedArray locus_of_jump(const Request &request) {
  const LabelledArray array = request.array("Field");
  const Axis axis = request.along_one(array, true);
  const Frame frame({array});
  const std::size_t along = frame.position(axis.name);
  const auto [dimensions, shape] = frame.without(along);
  DerivedArray result = request.result(
      axis.unit, axis.name + " of the largest step of " + array.name, dimensions, shape);
  result.axis = axis.name;
  const double threshold = request.number("Threshold", array.unit);
  for_each_line(frame, along, {frame.operand(array)}, [&](std::size_t k, const auto &lines) {
    double largest = threshold;
    for (std::size_t i = 0; i + 1 < axis.size(); ++i)
      if (const double step = std::abs(lines[0][i + 1] - lines[0][i]); step > largest) {
        largest = step;
        result.values[k] = (axis.values[i] + axis.values[i + 1]) / 2;
      }
  });
  return result;
}

} // namespace vibroimpact::derived
