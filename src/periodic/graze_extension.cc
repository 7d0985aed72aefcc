#include "periodic/graze_extension.h"

#include "common/error.h"
#include "periodic/touching.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::periodic {

using continuation::Extension;
using continuation::Touch;

namespace {

/// Parts of a motion one behind the other, with the derivatives of the whole.
struct Chain {
  Vector state;
  Matrix by_state = Matrix::Identity(state.size(), state.size());
  Matrix by_keys;
  Vector rates{};
  EventPattern pattern{};

  static Chain at(const StroboscopicMap &map, const Vector &state) {
    return {.state = state,
            .by_keys = Matrix::Zero(state.size(), static_cast<Index>(map.keys().size()))};
  }

  void go(const StroboscopicMap &map, double from, double to) {
    if (!(to > from))
      return;
    const Flow flow = map.flow(from, to, state);
    state = flow.state;
    rates = flow.rates;
    by_keys = flow.by_state * by_keys + flow.by_keys;
    by_state = flow.by_state * by_state;
    pattern.append(flow.pattern);
  }
  void touch(const GrazeWindow &window) {
    const bool closed =
        pattern.events.empty() ? pattern.touches : pattern.touches_after.back() != 0;
    pattern.events.push_back({.time = pattern.length,
                              .contact = window.contact,
                              .from = window.mode,
                              .to = window.mode});
    pattern.touches_after.push_back(closed ? 1 : 0);
  }
  // The state takes the value away along the jump by it.
  void jump(const Vector &by_value, const Extension &at) {
    state += by_value * at.value;
    by_state += by_value * at.by_state;
    by_keys += by_value * at.by_keys;
  }
};

bool is_of(const GrazeWindow &window, const GuardMinimum &minimum) {
  if (minimum.contact != window.contact || minimum.in_contact != window.in_contact)
    return false;
  return !window.in_contact || (minimum.mode == window.mode && minimum.guard == window.guard);
}

/// The part of a section in which the window lies [periods].
struct Part {
  double begin = 0, position = 0, end = 0;
};

Part part_of(const StroboscopicMap &map, const Section &section, const GrazeWindow &window) {
  const double first = map.first_phase(section), last = first + section.length();
  const auto multiple = static_cast<double>(section.multiple());
  const double shift = -std::floor((window.begin - first) / multiple + 1e-12) * multiple;
  const Part part{.begin = std::max(first, window.begin + shift),
                  .position = window.position + shift,
                  .end = window.end + shift};
  if (part.end > last + 1e-12)
    throw NumericalError("the motion is cut where a contact is to graze");
  return part;
}

double nearest_to(double position, const std::vector<double> &instants, const char *what) {
  if (instants.empty())
    throw NumericalError(what);
  return *std::min_element(instants.begin(), instants.end(), [&](double a, double b) {
    return std::abs(a - position) < std::abs(b - position);
  });
}

// The instant [periods] of the minimum nearest to the position of the window.
double minimum_near(const GrazingMaps &maps, const Part &part, const GrazeWindow &window,
                    const Vector &state) {
  MinimumObserver observer(maps.map.system().contacts());
  maps.open.observe(part.begin, part.end, state, observer);
  std::vector<double> instants;
  for (const GuardMinimum &minimum : observer.minima())
    if (is_of(window, minimum) && !minimum.passed)
      instants.push_back(minimum.time / maps.map.period());
  return nearest_to(part.position, instants,
                    "the guard of a contact has no minimum at the grazing contact");
}

// The instant [periods] at which the slip of the window ends.
double slip_end_near(const GrazingMaps &maps, const Part &part, const GrazeWindow &window,
                     const Vector &state) {
  MinimumObserver observer(maps.map.system().contacts());
  maps.map.observe(part.begin, part.end, state, observer);
  std::vector<double> instants;
  for (const SlipEnd &end : observer.slip_ends())
    if (end.contact == window.contact && end.mode == window.mode && end.guard == window.guard)
      instants.push_back(end.time / maps.map.period());
  return nearest_to(part.position, instants, "the slip of a contact does not end where it did");
}

// d(state)/d(keys) at a fixed time, of that at a fixed phase.
Matrix at_fixed_time(const StroboscopicMap &map, const Chain &chain, double phase,
                     const Vector &rates) {
  Matrix by_keys = chain.by_keys;
  for (Index k = 0; k < by_keys.cols(); ++k)
    by_keys.col(k) -= rates * (phase * map.keys()[static_cast<std::size_t>(k)]->period);
  return by_keys;
}

/// The flow over a section and what grazes in it, before the symmetry of the section.
struct Passed {
  Chain whole;
  Vector jump{}; ///< of the end, by the value
  GrazingFlow flow{};
};

Chain begun(const StroboscopicMap &map, const Section &section, const Vector &state) {
  Chain chain = Chain::at(map, state);
  const std::vector<Index> unseen = map.idle(map.first_phase(section), state);
  chain.state(unseen).setZero();
  chain.by_state(Eigen::all, unseen).setZero();
  return chain;
}

void note_value(const GuardAtInstant &guard, const GrazingMaps &maps, const Chain &chain,
                double phase, const Vector &rates, Extension &extension) {
  extension.value = guard.value();
  extension.by_state = guard.gradient() * chain.by_state;
  extension.by_keys = guard.by_keys(at_fixed_time(maps.map, chain, phase, rates));
}

// Where sides stick on behind it, the motions that do are extended, not those that do not.
Passed pass_dip(const GrazingMaps &maps, const Section &section, const Vector &state,
                const GrazeWindow &window) {
  const Part part = part_of(maps.map, section, window);
  const double first = maps.map.first_phase(section), last = first + section.length();
  Passed passed{.whole = begun(maps.map, section, state)};
  Chain &chain = passed.whole;
  chain.go(maps.map, first, part.begin);
  const double touch = passed.flow.touch = minimum_near(maps, part, window, chain.state);
  chain.go(maps.open, part.begin, touch);
  chain.touch(window);
  const Vector at_touch = chain.state, rates = maps.open.rates(touch, at_touch);
  const GuardAtInstant guard(maps.map, maps.open, {window.contact, window.mode, window.guard},
                             touch, at_touch);
  const Touching touching(guard);
  Extension &extension = passed.flow.extension;
  note_value(guard, maps, chain, touch, rates, extension);
  extension.touch = touching.touch();
  extension.kind = static_cast<int>(touching.kind());
  const Vector jump = touching.jump();
  if (extension.touch == Touch::one_sided && window.passed) {
    if (jump.size() == 0)
      throw NumericalError("the motions that slip have no extension to where they just do");
    chain.jump(jump, extension);
    chain.go(maps.map, touch, last);
    return passed;
  }
  Chain behind = Chain::at(maps.map, chain.state);
  behind.go(maps.open, touch, part.end);
  behind.go(maps.map, part.end, last);
  if (extension.touch == Touch::corner && jump.size() > 0)
    passed.jump = behind.by_state * jump;
  chain.by_keys = behind.by_state * chain.by_keys + behind.by_keys;
  chain.by_state = behind.by_state * chain.by_state;
  chain.state = behind.state;
  chain.rates = behind.rates;
  chain.pattern.append(behind.pattern);
  return passed;
}

// Sides that stick at the instant do so until they slip on, or for longer.
void classify(const GrazingMaps &maps, const GuardAtInstant &stick, double phase,
              const Vector &state, Extension &extension) {
  const double rate = stick.rate(maps.stick->rates(phase, state));
  const bool crosses = rate < 0;
  extension.kind =
      static_cast<int>(crosses ? GrazeKind::crossing_sliding : GrazeKind::switching_sliding);
  if (!Touching::slips_without_jump(*stick.pair().law, stick.guard(), stick.local()))
    extension.touch = crosses ? Touch::square_root : Touch::one_sided;
}

Passed pass_slip_end(const GrazingMaps &maps, const Section &section, const Vector &state,
                     const GrazeWindow &window) {
  const Part part = part_of(maps.map, section, window);
  const double first = maps.map.first_phase(section);
  Chain chain = begun(maps.map, section, state);
  Passed passed{.whole = chain};
  passed.whole.go(maps.map, first, first + section.length());
  chain.go(maps.map, first, part.begin);
  const double end = passed.flow.touch = slip_end_near(maps, part, window, chain.state);
  chain.go(maps.open, part.begin, end);
  const Vector rates = maps.open.rates(end, chain.state);
  const GuardAtInstant slip(maps.map, maps.open, window.overlooked(), end, chain.state);
  const GuardAtInstant stick(maps.map, *maps.stick, *window.stick, end, chain.state);
  Extension slipping;
  note_value(slip, maps, chain, end, rates, slipping);
  Extension &extension = passed.flow.extension;
  note_value(stick, maps, chain, end, rates, extension);
  const double by_delay = stick.rate(rates) / slip.rate(rates);
  extension.value *= -1;
  extension.by_state = by_delay * slipping.by_state - extension.by_state;
  extension.by_keys = by_delay * slipping.by_keys - extension.by_keys;
  classify(maps, stick, end, chain.state, extension);
  return passed;
}

Passed pass(const GrazingMaps &maps, const Section &section, const Vector &state,
            const GrazeWindow &window) {
  return window.stick ? pass_slip_end(maps, section, state, window)
                      : pass_dip(maps, section, state, window);
}

Flow flow_of(const StroboscopicMap &map, const Section &section, Passed &passed) {
  const auto mirrored = [&](const Matrix &columns) { return map.mirrored(section, columns); };
  return {.state = mirrored(passed.whole.state),
          .rates = mirrored(passed.whole.rates),
          .by_state = mirrored(passed.whole.by_state),
          .by_keys = mirrored(passed.whole.by_keys),
          .pattern = std::move(passed.whole.pattern),
          .determinant = {}};
}

// Where the period is free, it becomes that of the return of the extended motion.
Passed pass_to_return(const GrazingMaps &maps, const Section &section, const Vector &state,
                      const GrazeWindow &window) {
  if (!maps.map.system().free_period())
    return pass(maps, section, state, window);
  constexpr int most_steps = 12;
  const Plane &plane = maps.map.plane(section, state);
  for (int i = 0; i < most_steps; ++i) {
    Passed passed = pass(maps, section, state, window);
    const Chain &end = passed.whole;
    const auto step = maps.map.step_to_return(section, plane, maps.map.mirrored(section, end.state),
                                              maps.map.mirrored(section, end.rates));
    if (step == StroboscopicMap::Return::there)
      return passed;
    if (step == StroboscopicMap::Return::lost)
      break;
  }
  throw NumericalError("the motion that may graze does not come back to where it is cut");
}

} // namespace

GrazingFlow extend(const GrazingMaps &maps, const Section &section, const Vector &state,
                   const GrazeWindow &window) {
  const StroboscopicMap &map = maps.map;
  const double period = map.period();
  Passed passed = pass_to_return(maps, section, state, window);
  GrazingFlow &flow = passed.flow;
  Flow end = flow_of(map, section, passed);
  Extension &extension = flow.extension;
  if (passed.jump.size() > 0)
    extension.jump = map.mirrored(section, passed.jump);
  if (map.system().free_period()) {
    const Plane &plane = map.plane(section, state);
    if (extension.jump.size() > 0)
      extension.jump -= end.rates / plane.normal.dot(end.rates) * plane.normal.dot(extension.jump);
    StroboscopicMap::project(plane, end);
    map.set_period(period);
  }
  extension.smooth = {.residual = end.state - state,
                      .by_state = end.by_state - Matrix::Identity(state.size(), state.size()),
                      .by_keys = std::move(end.by_keys),
                      .pattern = end.pattern.numbers(),
                      .chart_margin = end.pattern.nearest_event() / period};
  flow.pattern = std::move(end.pattern);
  return std::move(flow);
}

Flow flow_past(const GrazingMaps &maps, double from, double to, const Vector &state,
               const GrazeWindow &window) {
  if (window.stick)
    return maps.map.flow(from, to, state);
  Chain chain = Chain::at(maps.map, state);
  chain.go(maps.map, from, std::min(to, window.begin));
  chain.go(maps.open, std::max(from, window.begin), std::min(to, window.end));
  chain.go(maps.map, window.end, to);
  return {.state = chain.state,
          .rates = {},
          .by_state = chain.by_state,
          .by_keys = chain.by_keys,
          .pattern = chain.pattern,
          .determinant = {}};
}

} // namespace vibroimpact::periodic
