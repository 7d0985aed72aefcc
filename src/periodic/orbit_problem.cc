#include "periodic/orbit_problem.h"

#include "periodic/grazing_orbits.h"

#include <cmath>

namespace vibroimpact::periodic {

using continuation::Evaluation;
using continuation::Point;
using continuation::ShorterReturn;
using continuation::Transfer;

namespace {

constexpr int instants = 16; // of a period at which the size of a motion is looked at

} // namespace

GrazingMaps MapAlongKeys::grazing(const Vector &keys, const GrazeWindow &window) {
  const StroboscopicMap &open = overlooking(keys, window.overlooked());
  const StroboscopicMap *const stick = window.stick ? &overlooking(keys, *window.stick) : nullptr;
  return {.map = at(keys), .open = open, .stick = stick};
}

// Charts go on over the periods of the motion and begin again after its multiple.
double OrbitProblem::wrapped(double phase) const {
  return phase - std::floor(phase / periods()) * periods();
}

Evaluation OrbitProblem::evaluate(const Point &point) {
  const StroboscopicMap &map = maps_.at(point.keys);
  const Flow image = map.image(section_at(point.chart), point.state);
  if (FreePeriod *const free = maps_.free_period(); free != nullptr)
    free->note(point.keys);
  return {.residual = image.state - point.state,
          .by_state = image.by_state - Matrix::Identity(map.size(), map.size()),
          .by_keys = image.by_keys,
          .pattern = image.pattern.numbers(),
          .chart_margin = image.pattern.events.empty()
                              ? std::numeric_limits<double>::infinity()
                              : image.pattern.nearest_event() / map.period()};
}

std::vector<ShorterReturn> OrbitProblem::shorter_returns(const Point &point) {
  const StroboscopicMap &map = maps_.at(point.keys);
  std::vector<ShorterReturn> returns;
  const double period = map.period();
  for (long halves = 1; halves < halves_; ++halves) {
    const Section section{.phase = point.chart, .halves = halves};
    if (halves_ % halves == 0 && (!section.with_symmetry() || map.symmetric()))
      returns.push_back({.multiple = static_cast<int>(halves),
                         .displacement = map.image(section, point.state).state - point.state});
    map.set_period(period);
  }
  return returns;
}

std::unique_ptr<continuation::Problem> OrbitProblem::doubled() {
  return std::make_unique<OrbitProblem>(doubled_orbits());
}

double OrbitProblem::best_chart(const Point &point) {
  const StroboscopicMap &map = maps_.at(point.keys);
  const EventPattern pattern = map.image(section_at(point.chart), point.state).pattern;
  return wrapped(point.chart + pattern.calmest_instant() / map.period());
}

Transfer OrbitProblem::transfer(const Point &point, double chart) {
  const StroboscopicMap &map = maps_.at(point.keys);
  const double shift = wrapped(chart - point.chart);
  const Flow flow = map.to_section(point.chart, point.chart + shift, chart, point.state);
  return {.point = {.state = flow.state, .keys = point.keys, .chart = chart},
          .by_state = flow.by_state,
          .by_keys = flow.by_keys};
}

std::vector<continuation::Graze> OrbitProblem::grazes_near(const Point &point) {
  const StroboscopicMap &map = maps_.at(point.keys);
  std::vector<continuation::Graze> grazes;
  for (const GrazeWindow &window : graze_windows(map, section_at(point.chart), point.state)) {
    grazes.push_back({.guard = static_cast<int>(windows_.size()),
                      .position = window.position,
                      .ignored = std::numeric_limits<double>::infinity(),
                      .name = map.system().contacts().pairs()[window.contact].name});
    windows_.push_back(window);
  }
  return grazes;
}

continuation::Extension OrbitProblem::extend(const Point &point, const continuation::Graze &graze) {
  const GrazeWindow &window = windows_.at(static_cast<std::size_t>(graze.guard));
  return periodic::extend(maps_.grazing(point.keys, window), section_at(point.chart), point.state,
                          window)
      .extension;
}

std::unique_ptr<continuation::Problem> OrbitProblem::extended(const continuation::Graze &graze) {
  if (maps_.free_period() != nullptr) // windows of one chart say nothing in another
    throw NumericalError("grazing motions are followed in two keys under forcing only");
  return std::make_unique<GrazingOrbits>(maps_, halves_, sizes_,
                                         windows_.at(static_cast<std::size_t>(graze.guard)));
}

std::vector<double> OrbitProblem::remembered() const {
  const FreePeriod *const free = maps_.free_period();
  return free != nullptr ? free->numbers() : std::vector<double>{};
}

void OrbitProblem::remember(const std::vector<double> &numbers) {
  if (FreePeriod *const free = maps_.free_period(); free != nullptr && !numbers.empty())
    free->restore(numbers);
}

Vector problem_sizes(const StroboscopicMap &map, const Orbit &orbit, const Vector &keys) {
  double size = map.norm(orbit.point.state);
  Vector state = orbit.point.state;
  const double from = orbit.section.phase;
  for (int i = 0; i < instants; ++i) {
    state = map.carry(from + static_cast<double>(i) / instants,
                      from + static_cast<double>(i + 1) / instants, state);
    size = std::max(size, map.norm(state));
  }
  Vector sizes(map.size() + keys.size());
  sizes << (size > 0 ? size : 1) * map.scale().cwiseInverse(), keys;
  return sizes;
}

} // namespace vibroimpact::periodic
