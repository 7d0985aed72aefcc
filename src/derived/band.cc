// The intervals along an axis in which a field lies above or below a level or another field.
#include "derived/difference.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vibroimpact::derived {

namespace {

struct Interval {
  double start;
  double end;
};

/// `sign`: 1 for above, -1 for below. An interval ends where a point is missing.
std::vector<Interval> intervals(const Axis &axis, const Difference &difference, double sign) {
  std::vector<Interval> found;
  bool inside = false;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    const double here = sign * difference[i];
    const double before = i > 0 ? sign * difference[i - 1] : here;
    const double between =
        i > 0 ? zero_between(axis.values[i - 1], before, axis.values[i], here) : axis.values[i];
    if (here > 0 && !inside)
      found.push_back({before <= 0 ? between : axis.values[i], axis.values[i]});
    if (here > 0)
      found.back().end = axis.values[i];
    else if (inside && here <= 0)
      found.back().end = between;
    inside = here > 0;
  }
  return found;
}

/// Adds the dimensions (interval, bound) to those of `result` and fills them.
void store(const std::vector<std::vector<Interval>> &all, const std::string &name,
           DerivedArray &result) {
  std::size_t most = 1;
  for (const std::vector<Interval> &list : all)
    most = std::max(most, list.size());
  Axis interval{"interval_" + name, std::vector<double>(most), {}, "1", "index from 1"};
  std::iota(interval.values.begin(), interval.values.end(), 1);
  result.own_dimensions = {interval,
                           {"bound", {}, {"start", "end"}, "1", "start or end of an interval"}};
  result.dimensions.insert(result.dimensions.end(), {interval.name, "bound"});
  result.shape.insert(result.shape.end(), {most, 2});
  result.values.assign(number_of_values(result.shape), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < all.size(); ++k)
    for (std::size_t i = 0; i < all[k].size(); ++i) {
      result.values[2 * (k * most + i)] = all[k][i].start;
      result.values[2 * (k * most + i) + 1] = all[k][i].end;
    }
}

} // namespace

DerivedArray band(const Request &request) {
  const Compared compared(request);
  const std::string side = request.section().choice("Side");
  DerivedArray result =
      compared.result(request, compared.axis().name + " where " + compared.name() + " is " + side +
                                   " " + compared.other_name());
  std::vector<std::vector<Interval>> all(result.values.size());
  compared.for_each([&](std::size_t k, const Difference &difference) {
    all[k] = intervals(compared.axis(), difference, side == "above" ? 1 : -1);
  });
  store(all, request.name(), result);
  return result;
}

} // namespace vibroimpact::derived
