// How the values along an axis scatter: of the members of an ensemble, or of parameters at random.
#include "derived/operation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::derived {

namespace {

/// What `of` makes of the values along the axis that are no gaps.
template <class Of>
DerivedArray of_present(const Request &request, const std::string &meaning, Of of) {
  const LabelledArray array = request.array("Field");
  const Axis axis = request.along_one(array, false);
  const Frame frame({array});
  const std::size_t along = frame.position(axis.name);
  const auto [dimensions, shape] = frame.without(along);
  DerivedArray result = request.result(array.unit, meaning + " " + array.name, dimensions, shape);
  for_each_line(frame, along, {frame.operand(array)}, [&](std::size_t k, const auto &lines) {
    std::vector<double> present;
    for (std::size_t i = 0; i < axis.size(); ++i)
      if (!std::isnan(lines[0][i]))
        present.push_back(lines[0][i]);
    result.values[k] = of(std::move(present));
  });
  return result;
}

double mean_of(const std::vector<double> &values) {
  double sum = 0;
  for (const double value : values)
    sum += value;
  return sum / static_cast<double>(values.size());
}

// With n - 1, in two passes; nothing of a single value.
double deviation_of(const std::vector<double> &values) {
  if (values.size() < 2)
    return std::numeric_limits<double>::quiet_NaN();
  const double mean = mean_of(values);
  double squares = 0;
  for (const double value : values)
    squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

// Straight lines between the ordered values, the least at 0 and the largest at 1 (type 7 of Hyndman
// and Fan 1996).
double quantile_of(std::vector<double> values, double probability) {
  if (values.empty())
    return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const double place = probability * static_cast<double>(values.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), values.size() - 1);
  const double share = place - static_cast<double>(below);
  return share > 0 ? (1 - share) * values[below] + share * values[below + 1] : values[below];
}

} // namespace

DerivedArray standard_deviation(const Request &request) {
  return of_present(request, "standard deviation of", deviation_of);
}

DerivedArray standard_error(const Request &request) {
  return of_present(request, "standard error of the mean of",
                    [](const std::vector<double> &values) {
                      return deviation_of(values) / std::sqrt(static_cast<double>(values.size()));
                    });
}

DerivedArray quantile(const Request &request) {
  const double probability = request.section().quantity("Probability");
  return of_present(request, "quantile of", [&](std::vector<double> values) {
    return quantile_of(std::move(values), probability);
  });
}

} // namespace vibroimpact::derived
