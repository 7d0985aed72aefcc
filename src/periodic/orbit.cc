#include "periodic/orbit.h"

#include "common/error.h"

#include <cmath>

namespace vibroimpact::periodic {

namespace {

// Periods from the section to the nearest event; nearer ones move the section.
constexpr double near_event = 0.08;
constexpr double worth_moving = 1.5; // times farther from an event
constexpr int most_moves = 3;
// Relative distance between states that are one. Newton's method leaves far less; motions of other
// multiples are farther apart but within some 1e-14 of the key from where they branch off.
constexpr double same_state = 1e-7;

double wrapped(double phase, const Section &section) {
  const auto multiple = static_cast<double>(section.multiple());
  return phase - std::floor(phase / multiple) * multiple;
}

bool comes_back(const StroboscopicMap &map, const Section &section, const Vector &state,
                double distance) {
  try {
    return map.norm(map.image(section, state).state - state) <= distance;
  } catch (const NumericalError &) { // it is nowhere near
    return false;
  }
}

// Smallest h of which the point is a fixed point.
long least_halves(const StroboscopicMap &map, const Orbit &orbit) {
  const double size = map.norm(orbit.point.state), period = map.period();
  for (long halves = 1; halves < orbit.section.halves; ++halves) {
    const Section section{.phase = orbit.section.phase, .halves = halves};
    if (orbit.section.halves % halves != 0 || (section.with_symmetry() && !map.symmetric()))
      continue;
    const bool returns = comes_back(map, section, orbit.point.state, same_state * size);
    map.set_period(returns ? map.period() : period);
    if (returns)
      return halves;
  }
  return orbit.section.halves;
}

} // namespace

Eigen::VectorXcd Orbit::multipliers(const StroboscopicMap &map) const {
  Eigen::VectorXcd values = multipliers_of(point.image.by_state, map.scale());
  if (section.with_symmetry())
    values = values.cwiseProduct(values).eval();
  return values;
}

bool is_stable(const Eigen::VectorXcd &multipliers) {
  return multipliers.size() == 0 || multipliers.cwiseAbs().maxCoeff() < 1;
}

double section_shift(const EventPattern &pattern, double period, double least) {
  if (pattern.nearest_event() >= least * period)
    return 0;
  const double instant = pattern.calmest_instant();
  double distance = pattern.length;
  for (const PatternEvent &event : pattern.events) {
    const double apart = std::abs(event.time - instant);
    distance = std::min({distance, apart, pattern.length - apart});
  }
  return distance > worth_moving * pattern.nearest_event() ? instant / period : 0;
}

Orbit find_orbit(const StroboscopicMap &map, long multiple, const Vector &state) {
  Orbit orbit{.section = {.phase = 0, .halves = 2 * multiple},
              .point = {.state = state, .image = map.image({.halves = 2 * multiple}, state)}};
  for (int move = 0; move <= most_moves; ++move) {
    const double shift = section_shift(orbit.point.image.pattern, map.period(), near_event);
    if (move > 0 && shift == 0)
      break;
    const double phase = orbit.section.phase;
    const Vector moved = map.carry(phase, phase + shift, orbit.point.state);
    orbit.section.phase = wrapped(phase + shift, orbit.section);
    orbit.point = find_fixed_point(map, orbit.section, moved);
    orbit.iterations += orbit.point.iterations;
  }
  if (const long halves = least_halves(map, orbit); halves < orbit.section.halves) {
    orbit.section.halves = halves;
    orbit.section.phase = wrapped(orbit.section.phase, orbit.section);
    orbit.point = find_fixed_point(map, orbit.section, orbit.point.state);
    orbit.iterations += orbit.point.iterations;
  }
  return orbit;
}

Vector state_at_zero_phase(const StroboscopicMap &map, const Orbit &orbit) {
  const auto multiple = static_cast<double>(orbit.section.multiple());
  return orbit.section.phase == 0 ? orbit.point.state
                                  : map.carry(orbit.section.phase, multiple, orbit.point.state);
}

} // namespace vibroimpact::periodic
