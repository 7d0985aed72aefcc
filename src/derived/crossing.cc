// Where a field crosses a level or another field along an axis.
#include "derived/difference.h"

#include <cmath>
#include <optional>

namespace vibroimpact::derived {

namespace {

struct Sought {
  bool rising = true;
  bool falling = true;
  bool last = false;
};

Sought sought(const parameters::Values &section) {
  const std::string sense = section.choice("Sense");
  return {.rising = sense != "falling",
          .falling = sense != "rising",
          .last = section.choice("Take") == "last"};
}

/// Does the difference change its sign between two neighbours? Reaching zero counts, leaving it
/// does not, so that a crossing on a grid point is met once.
bool crosses(const Sought &sought, double before, double after) {
  return (sought.rising && before < 0 && after >= 0) ||
         (sought.falling && before > 0 && after <= 0);
}

std::optional<double> find_crossing(const Sought &sought, const Axis &axis,
                                    const Difference &difference) {
  std::optional<double> found;
  for (std::size_t i = 0; i + 1 < axis.size() && (sought.last || !found); ++i)
    if (crosses(sought, difference[i], difference[i + 1]))
      found = zero_between(axis.values[i], difference[i], axis.values[i + 1], difference[i + 1]);
  return found;
}

} // namespace

DerivedArray crossing(const Request &request) {
  const Compared compared(request);
  const Axis axis = compared.axis();
  DerivedArray result = compared.result(request, axis.name + " where " + compared.name() +
                                                     " crosses " + compared.other_name());
  const Sought what = sought(request.section());
  compared.for_each([&](std::size_t k, const Difference &difference) {
    if (const auto found = find_crossing(what, axis, difference))
      result.values[k] = *found;
  });
  return result;
}

} // namespace vibroimpact::derived
