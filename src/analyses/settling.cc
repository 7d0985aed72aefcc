#include "analyses/settling.h"

#include "analyses/steadiness.h"

#include <algorithm>
#include <deque>

namespace vibroimpact {

namespace {

void find_range(const std::deque<Vector> &states, std::size_t count, SettledMotion &motion) {
  motion.lowest = motion.highest = states.front();
  for (std::size_t i = 1; i < std::min(count, states.size()); ++i) {
    motion.lowest = motion.lowest.cwiseMin(states[i]);
    motion.highest = motion.highest.cwiseMax(states[i]);
  }
}

double largest(const Vector &states, const Vector &scale) {
  return states.cwiseProduct(scale).cwiseAbs().maxCoeff();
}

} // namespace

void declare_settling(parameters::Section &section) {
  using namespace parameters;
  section
      .integer("Minimum settling cycles", "5", Range{.lower = 0}, "",
               "Periods before the motion can be judged steady.")
      .integer("Settling cycles", "200", Range{.lower = 0}, "",
               "Periods after which it is recorded, steady or not.")
      .quantity("Steadiness tolerance", "1e-6", dimension::none, Range{.lower = 0, .upper = 1}, "",
                "Relative distance to the periodic motion at which it counts as steady; 0 always "
                "takes all settling cycles.")
      .integer("Longest period", "4", Range{.lower = 1, .upper = 1000}, "",
               "Longest period looked for, in forcing periods.");
}

SettlingRule read_settling(const parameters::Values &section) {
  if (section.integer("Minimum settling cycles") > section.integer("Settling cycles"))
    section.reject("Minimum settling cycles", "at most Settling cycles.");
  return {.minimum = section.integer("Minimum settling cycles"),
          .maximum = section.integer("Settling cycles"),
          .tolerance = section.quantity("Steadiness tolerance"),
          .longest_multiple = section.integer("Longest period")};
}

SettledMotion settle(Trajectory &trajectory, double period, const Vector &scale,
                     const SettlingRule &rule) {
  Steadiness steadiness(scale, rule.longest_multiple, rule.tolerance);
  const auto seen = static_cast<std::size_t>(2 * rule.longest_multiple + 1);
  std::deque<Vector> states = {trajectory.motion_state().physical};
  SettledMotion motion;
  while (motion.cycles < rule.maximum && !(motion.cycles >= rule.minimum && steadiness.steady())) {
    ++motion.cycles;
    trajectory.advance(static_cast<double>(motion.cycles) * period);
    states.push_front(trajectory.motion_state().physical);
    steadiness.add(states.front());
    if (states.size() > seen)
      states.pop_back();
  }
  motion.state = {.time = 0, .physical = states.front()};
  motion.multiple = steadiness.multiple();
  find_range(states, motion.steady() ? static_cast<std::size_t>(motion.multiple) : seen, motion);
  return motion;
}

double relative_distance(const SettledMotion &a, const SettledMotion &b, const Vector &scale) {
  const double size = std::max({largest(a.lowest, scale), largest(a.highest, scale),
                                largest(b.lowest, scale), largest(b.highest, scale)});
  const double difference =
      std::max(largest(a.lowest - b.lowest, scale), largest(a.highest - b.highest, scale));
  return size > 0 ? difference / size : 0;
}

} // namespace vibroimpact
