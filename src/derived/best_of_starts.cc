#include "derived/best_of_starts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::derived {

namespace {

constexpr std::size_t no_start = static_cast<std::size_t>(-1);

const LabelledArray *find(const Source &source, const std::string &name) {
  const auto found = std::find_if(source.arrays.begin(), source.arrays.end(),
                                  [&](const LabelledArray &array) { return array.name == name; });
  return found == source.arrays.end() ? nullptr : &*found;
}

/// Fields go over the axes of a grid, then start, then evaluation, of which 0 is the result.
class Starts {
public:
  explicit Starts(const Shape &shape)
      : starts_(shape[shape.size() - 2]), evaluations_(shape.back()),
        cells_(number_of_values(shape) / (starts_ * evaluations_)) {}

  std::size_t cells() const { return cells_; }
  std::size_t number() const { return starts_; }
  double value(const double *values, std::size_t cell, std::size_t start) const {
    return values[(cell * starts_ + start) * evaluations_];
  }
  /// nowhere when no start has a result
  std::size_t best(const double *objective, std::size_t cell, double sign) const {
    std::size_t best = no_start;
    for (std::size_t start = 0; start < starts_; ++start) {
      const double here = sign * value(objective, cell, start);
      if (!std::isnan(here) && (best == no_start || here < sign * value(objective, cell, best)))
        best = start;
    }
    return best;
  }

private:
  std::size_t starts_, evaluations_, cells_;
};

DerivedArray result(const LabelledArray &like, const std::string &name, const std::string &unit,
                    const std::string &description) {
  DerivedArray array{name, unit, description};
  array.operation = "best of starts";
  array.dimensions = {like.dimensions.begin(), like.dimensions.end() - 2};
  array.shape = {like.shape.begin(), like.shape.end() - 2};
  array.values.assign(number_of_values(array.shape), std::numeric_limits<double>::quiet_NaN());
  return array;
}

} // namespace

std::vector<DerivedArray> best_of_starts(const Source &source, const analyses::BestOf &by) {
  const LabelledArray *objective = find(source, by.field);
  if (objective == nullptr)
    return {};
  const Starts starts(objective->shape);
  std::vector<DerivedArray> results;
  std::vector<std::size_t> best;
  for (std::size_t cell = 0; cell < starts.cells(); ++cell)
    best.push_back(starts.best(objective->values, cell, by.largest ? -1 : 1));
  const auto add = [&](const LabelledArray &array, const std::string &title) {
    DerivedArray &values = results.emplace_back(
        result(array, title, array.unit, array.description + ", at the best of all starts"));
    for (std::size_t cell = 0; cell < starts.cells(); ++cell)
      if (best[cell] != no_start)
        values.values[cell] = starts.value(array.values, cell, best[cell]);
  };
  add(*objective, "best_" + by.field);
  for (const LabelledArray &array : source.arrays)
    if (array.name.starts_with("key/"))
      add(array, "best_" + array.name.substr(4));
    else if (array.name.starts_with("standard_error/"))
      add(array, "standard_error_" + array.name.substr(15));
  if (starts.number() > 1) {
    results.push_back(
        result(*objective, "best_start", "1", "start whose search has found the best, from 1"));
    for (std::size_t cell = 0; cell < starts.cells(); ++cell)
      if (best[cell] != no_start)
        results.back().values[cell] = static_cast<double>(best[cell] + 1);
  }
  return results;
}

} // namespace vibroimpact::derived
