#include "analyses/design/stored_evaluations.h"

#include "analyses/results/fields.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace vibroimpact::analyses {

namespace {

std::vector<double> counted(std::size_t first, std::size_t size) {
  std::vector<double> numbers(size);
  std::iota(numbers.begin(), numbers.end(), static_cast<double>(first));
  return numbers;
}

} // namespace

void skip_the_rest(std::size_t most, std::size_t points, LineContext &context) {
  for (std::size_t i = points; i < most + 1; ++i)
    context.skip();
}

Axis evaluation_axis(std::size_t most) {
  return {.name = "evaluation",
          .values = counted(0, most + 1),
          .labels = {},
          .unit = "1",
          .description = "evaluation of a search, in their order; 0 is the result"};
}

std::vector<Axis> search_axes(std::size_t starts, std::size_t most) {
  return {{.name = "start",
           .values = counted(1, starts),
           .labels = {},
           .unit = "1",
           .description = "start of a search"},
          evaluation_axis(most)};
}

void add_keys(const FieldWriter &point, const std::vector<DesignKey> &keys,
              const Vector &coordinates) {
  const std::vector<double> values = values_at(keys, coordinates);
  for (std::size_t k = 0; k < keys.size(); ++k)
    point.number("key/" + keys[k].name, values[k], keys[k].parameter.unit,
                 "value of the key " + keys[k].parameter.path);
}

double bound_at(const DesignKey &key, double value, double tolerance) {
  const double coordinate = key.coordinate(value);
  if (std::isfinite(key.lower) && coordinate - key.coordinate(key.lower) <= tolerance)
    return -1;
  return std::isfinite(key.upper) && key.coordinate(key.upper) - coordinate <= tolerance ? 1 : 0;
}

std::string stored_failure(const PointResult &point) {
  return point.reason.empty() ? "an evaluation that was left out" : point.reason;
}

} // namespace vibroimpact::analyses
