// Means along axes.
#include "derived/operation.h"

#include <cmath>

namespace vibroimpact::derived {

namespace {

/// Sums along one axis, written over the array's other axes.
DerivedArray sum_along(const Request &request, const LabelledArray &array, const Axis &axis) {
  const Frame frame({array});
  const std::size_t along = frame.position(axis.name);
  const auto [dimensions, shape] = frame.without(along);
  DerivedArray result = request.result(array.unit, "mean " + array.name, dimensions, shape);
  for_each_line(frame, along, {frame.operand(array)}, [&](std::size_t k, const auto &lines) {
    result.values[k] = 0;
    for (std::size_t i = 0; i < axis.size(); ++i)
      result.values[k] += lines[0][i];
  });
  return result;
}

} // namespace

// Missing values count in neither the sum nor their number.
DerivedArray mean(const Request &request) {
  const LabelledArray array = request.array("Field");
  const std::size_t size = [&] {
    std::size_t product = 1;
    for (const std::size_t length : array.shape)
      product *= length;
    return product;
  }();
  std::vector<double> present(size), values(array.values, array.values + size);
  for (std::size_t i = 0; i < size; ++i) {
    present[i] = std::isnan(values[i]) ? 0 : 1;
    values[i] = std::isnan(values[i]) ? 0 : values[i];
  }
  LabelledArray sum = array, count = array;
  sum.values = values.data();
  count.values = present.data();
  DerivedArray sums, counts; // what the views look at
  for (const Axis &axis : request.along(array)) {
    DerivedArray next_sums = sum_along(request, sum, axis);
    DerivedArray next_counts = sum_along(request, count, axis);
    sums = std::move(next_sums);
    counts = std::move(next_counts);
    sum = sums.view();
    count = counts.view();
  }
  sums.axis = array.axis;
  for (std::size_t i = 0; i < sums.values.size(); ++i)
    sums.values[i] /= counts.values[i]; // 0 / 0 where there is none
  return sums;
}

} // namespace vibroimpact::derived
