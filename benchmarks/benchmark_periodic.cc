// Cost of periodic motions and basins beside the same done with Boost.odeint, in one run.
//
//   benchmark_periodic [repetitions]
//
// Exit code 1 when motions, multipliers or cells disagree; how fast anything is decides nothing.
#include "analyses/basins/basin_search.h"
#include "beam_case.h"
#include "common/error.h"
#include "isolator_case.h"
#include "odeint_map.h"
#include "periodic/shooting.h"
#include "petsc_session.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <utility>

namespace vibroimpact::benchmarks {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double state_error = 1e-8, multiplier_error = 1e-4; ///< that odeint is to reach

double least(const std::vector<double> &values) {
  return *std::min_element(values.begin(), values.end());
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void print(const char *what, const std::vector<double> &ours, const std::vector<double> &theirs) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < ours.size(); ++i)
    ratios.push_back(theirs[i] / ours[i]);
  std::printf("%-42s %10.3g %10.3g %10.3g %8.3g %8.3g\n", what, 1e3 * least(ours),
              1e3 * median(ours), 1e3 * median(theirs), median(ratios), least(ratios));
  std::fflush(stdout);
}

void require(bool agree, const std::string &what) {
  if (!agree)
    throw NumericalError(what + ": the two sides disagree");
}

/// A periodic motion as both sides find it.
struct Found {
  Vector state;          ///< at phase 0
  double multiplier = 0; ///< the largest, in absolute value
};

double largest(const Matrix &by_state) { return by_state.eigenvalues().cwiseAbs().maxCoeff(); }

// Largest errors of states, relative, and of multipliers.
std::pair<double, double> errors(const std::vector<Found> &values,
                                 const std::vector<Found> &truth) {
  double states = 0, multipliers = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double size = truth[i].state.cwiseAbs().maxCoeff();
    states = std::max(states, (values[i].state - truth[i].state).cwiseAbs().maxCoeff() / size);
    multipliers = std::max(multipliers, std::abs(values[i].multiplier - truth[i].multiplier));
  }
  return {states, multipliers};
}

/// How odeint integrates, and the step of its differences in sizes of the state.
struct OdeintSetting {
  double tolerance = 1, difference = 1e-4;
  std::pair<double, double> error{};

  /// Of Newton's method: steps below are the error of the motion.
  double last_step() const { return 10 * tolerance; }
};

void print(const OdeintSetting &setting) {
  std::printf("%-42s odeint: tolerance %.1e, differences of %.0e, errors %.1e and %.1e\n", "",
              setting.tolerance, setting.difference, setting.error.first, setting.error.second);
}

// The loosest tolerance, with the difference that suits it, that has states right to 1e-8 and
// multipliers to 1e-4. NumericalError where none has.
OdeintSetting loosest(const std::vector<Found> &truth,
                      const std::function<std::vector<Found>(const OdeintSetting &)> &run) {
  for (int third = -18; third >= -36; --third)
    for (const double difference : {1e-3, 1e-4, 1e-5, 1e-6}) {
      OdeintSetting setting{.tolerance = std::pow(10.0, third / 3.0), .difference = difference};
      try {
        setting.error = errors(run(setting), truth);
      } catch (const NumericalError &) { // too loose for Newton's method to end
        continue;
      }
      if (setting.error.first <= state_error && setting.error.second <= multiplier_error)
        return setting;
    }
  throw NumericalError("odeint does not come to the same motions");
}

// --- 200 periodic motions of the isolator in contact, each from the one before ------------------

constexpr int orbits = 200;
double frequency(int i) { return 0.75 + 0.6 * i / (orbits - 1); }

motion::VariationAccuracy unit_accuracy(const periodic::ForcedSystem &system) {
  return {.scale = Vector::Ones(system.layout().physical_size()), .tolerance = 1e-10};
}

// By half the period and the symmetry of the isolator.
class IsolatorOrbits {
public:
  IsolatorOrbits()
      : system_(isolator_system(frequency(0))),
        forced_(system_.model, system_.contacts, system_.integration, 0),
        map_(forced_, unit_accuracy(forced_),
             periodic::Symmetry::find(forced_, Vector::Ones(2), 2.0)),
        start_(map_.carry(0, 300, Vector::Zero(2))) {}

  const Vector &start() const { return start_; }

  std::vector<Found> run() {
    std::vector<Found> found;
    Vector state = start_;
    for (int i = 0; i < orbits; ++i) {
      system_.model.set_frequency(0, frequency(i));
      const periodic::FixedPoint point = find_fixed_point(map_, {.phase = 0, .halves = 1}, state);
      state = point.state;
      const double multiplier = largest(point.image.by_state);
      found.push_back({.state = state, .multiplier = multiplier * multiplier});
    }
    return found;
  }

private:
  analyses::System system_;
  periodic::ForcedSystem forced_;
  periodic::StroboscopicMap map_;
  Vector start_;
};

std::vector<Found> odeint_isolator_orbits(const Vector &start, const OdeintSetting &setting) {
  std::vector<Found> found;
  Vector state = start;
  for (int i = 0; i < orbits; ++i) {
    const OdeintMap<Isolator> map(isolator_by_hand(frequency(i)), pi / frequency(i), -1,
                                  {.relative = setting.tolerance, .absolute = setting.tolerance},
                                  Vector::Constant(2, setting.difference));
    const OdeintOrbit orbit = odeint_orbit(map, state, setting.last_step());
    state = orbit.state;
    const double multiplier = largest(orbit.by_state);
    found.push_back({.state = state, .multiplier = multiplier * multiplier});
  }
  return found;
}

void measure_isolator_orbits(int repetitions) {
  IsolatorOrbits ours;
  const std::vector<Found> truth = ours.run();
  const OdeintSetting setting = loosest(truth, [&](const OdeintSetting &tried) {
    return odeint_isolator_orbits(ours.start(), tried);
  });
  std::vector<double> own, odeint;
  for (int i = 0; i < repetitions; ++i) {
    own.push_back(cpu_time_of([&] { ours.run(); }));
    odeint.push_back(cpu_time_of([&] { odeint_isolator_orbits(ours.start(), setting); }));
  }
  print("isolator, 200 motions with multipliers", own, odeint);
  print(setting);
}

// --- a basin of 640 000 cells -------------------------------------------------------------------

constexpr double basin_frequency = 1.3;
constexpr int cells = 800, sampled_every = 20, coarse_every = 40;

model::InitialState cell(int i, int j) {
  const auto centre = [](int k) { return -3 + 6 * (k + 0.5) / cells; };
  return {.displacement = Vector::Constant(1, centre(i)),
          .velocity = Vector::Constant(1, centre(j))};
}

struct Marks {
  std::vector<int> values;
  long small = 0; ///< cells that lead to the smaller motion
};

template <class Decide> Marks over_cells(int first, int step, const Decide &decide) {
  Marks marks;
  for (int j = first; j < cells; j += step)
    for (int i = first; i < cells; i += step) {
      const periodic::Decision decision = decide(i, j);
      const int mark = decision.outcome == periodic::Outcome::decided
                           ? static_cast<int>(decision.attractor)
                           : -1;
      marks.values.push_back(mark);
      marks.small += mark == 0 ? 1 : 0;
    }
  return marks;
}

// The motions from a coarse part, which both sides then know.
analyses::BasinSearch &prepare(analyses::BasinSearch &search) {
  std::vector<model::InitialState> coarse;
  for (int j = coarse_every / 2; j < cells; j += coarse_every)
    for (int i = coarse_every / 2; i < cells; i += coarse_every)
      coarse.push_back(cell(i, j));
  search.begin(coarse);
  for (const model::InitialState &start : coarse)
    search.follow(start);
  search.sort();
  return search;
}

void measure_basin() {
  const periodic::AttractorSettings settings{.most_periods = 2000, .longest_multiple = 16};
  analyses::BasinSearch search(isolator_system(basin_frequency),
                               {.attractors = settings, .excitation = ""});
  Marks all;
  const double own = cpu_time_of([&] {
    prepare(search);
    all = over_cells(0, 1, [&](int i, int j) { return search.follow(cell(i, j)); });
  });
  // The same rule with the same balls, the motions by odeint.
  periodic::Attractors known = search.attractors();
  const OdeintMap<Isolator> map(isolator_by_hand(basin_frequency), 2 * pi / basin_frequency, 1,
                                {.relative = 1e-8, .absolute = 1e-8}, Vector());
  const int first = sampled_every / 2;
  const auto by_odeint = [&](int i, int j) { // states have a scale of 1 here
    const model::InitialState start = cell(i, j);
    return known.follow(Eigen::Vector2d(start.displacement[0], start.velocity[0]), map, 1);
  };
  Marks sample;
  const double sampled = cpu_time_of([&] { sample = over_cells(first, sampled_every, by_odeint); });
  long differing = 0;
  for (std::size_t k = 0; k < sample.values.size(); ++k) {
    const std::size_t row = k / (cells / sampled_every), column = k % (cells / sampled_every);
    const std::size_t place = (static_cast<std::size_t>(first) + row * sampled_every) * cells +
                              static_cast<std::size_t>(first) + column * sampled_every;
    differing += all.values[place] != sample.values[k] ? 1 : 0;
  }
  print("isolator, basins, 640 000 cells", {own},
        {sampled * static_cast<double>(sampled_every * sampled_every)});
  std::printf("%-42s %ld cells lead to the smaller motion, %ld of %zu sampled differ\n", "",
              all.small, differing, sample.values.size());
  require(differing <= 2, "basins");
}

// --- a periodic motion of a beam with 20 modes on a linear stop ---------------------------------

void measure_beam(int repetitions) {
  BeamOnStopEquations beam = beam_on_stop_equations();
  periodic::ForcedSystem forced(beam.problem.model, beam.problem.contacts, {}, 0);
  const double omega = beam.system.omega();
  motion::VariationAccuracy accuracy = unit_accuracy(forced);
  const Index n = beam.problem.model.size();
  for (Index j = 0; j < n; ++j) // velocities over the frequencies of the modes
    accuracy.scale[n + j] =
        1 / std::sqrt(beam.system.squared_frequency[static_cast<std::size_t>(j)]);
  const periodic::StroboscopicMap map(forced, accuracy);
  const Vector start = map.carry(0, 10, Vector::Zero(2 * n));
  const Vector sizes = map.norm(start) * accuracy.scale.cwiseInverse();
  const auto own_orbit = [&]() -> std::vector<Found> {
    const periodic::FixedPoint point = find_fixed_point(map, {.phase = 0, .halves = 2}, start);
    return {{.state = point.state, .multiplier = largest(point.image.by_state)}};
  };
  const auto odeint = [&](const OdeintSetting &setting) -> std::vector<Found> {
    const OdeintMap<BeamOnStop> by_odeint(
        beam.system, 2 * pi / omega, 1,
        {.relative = setting.tolerance, .absolute = setting.tolerance * beam.system.clearance},
        setting.difference * sizes);
    const OdeintOrbit orbit = odeint_orbit(by_odeint, start, setting.last_step());
    return {{.state = orbit.state, .multiplier = largest(orbit.by_state)}};
  };
  const OdeintSetting setting = loosest(own_orbit(), odeint);
  std::vector<double> own, others;
  for (int i = 0; i < std::min(repetitions, 3); ++i) {
    own.push_back(cpu_time_of([&] { own_orbit(); }));
    others.push_back(cpu_time_of([&] { odeint(setting); }));
  }
  print("beam on a stop, 20 modes, one motion", own, others);
  print(setting);
}

void run(int repetitions) {
  std::printf("ms of processor time; speed: times that of odeint, of the same turn\n\n");
  std::printf("%-42s %10s %10s %10s %8s %8s\n", "", "least", "median", "odeint", "speed", "least");
  measure_isolator_orbits(repetitions);
  measure_beam(repetitions);
  measure_basin();
}

} // namespace

} // namespace vibroimpact::benchmarks

int main(int argc, char **argv) {
  using namespace vibroimpact::benchmarks;
  const int repetitions = argc > 1 ? std::atoi(argv[1]) : 15;
  if (argc > 2 || repetitions < 1) {
    std::fprintf(stderr, "usage: benchmark_periodic [repetitions]\n");
    return 2;
  }
  try {
    const PetscSession petsc("benchmark_periodic");
    run(repetitions);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
