// Cost of motions that nobody watches, one after the other and side by side in vector lanes.
//
//   benchmark_lanes [repetitions [number at once ...]]
//
// A mass between two bumpers that creep back by themselves, for several gaps, stiffnesses and
// frequencies, flown period by period as settling does. Processor time, the least of all
// repetitions.
#include "contact/laws/relaxing_stop.h"
#include "integration/flight_batch.h"
#include "integration/trajectory.h"
#include "petsc_session.h"
#include "sides.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <limits>
#include <numbers>
#include <vector>

namespace vibroimpact::benchmarks {

namespace {

constexpr long periods = 400;

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Bumped {
  Bumped(double gap, double stiffness, double frequency)
      : problem(problem_of(gap, stiffness, frequency)), period(2 * std::numbers::pi / frequency),
        trajectory(problem.model, problem.contacts, {.relative_tolerance = 1e-9}) {
    const Vector rest = Vector::Zero(1);
    trajectory.start(0, rest, rest);
  }

  static Problem problem_of(double gap, double stiffness, double frequency) {
    constexpr double damping = 0.2;
    const Vector one = Vector::Ones(1);
    model::Model model({body_along_x("mass", one, one, damping * one, one)});
    model.add_base_motion(
        "ground",
        std::make_shared<model::Harmonic>(model::Given::acceleration, 0.199, frequency, 0), {0},
        Vector3::UnitX());
    const auto law = std::make_shared<contact::RelaxingStop>(stiffness, 5 * damping);
    contact::ContactSet contacts({contact_of_heads(model, "mass", "", 1, gap, law),
                                  contact_of_heads(model, "mass", "", -1, gap, law)});
    return {.model = std::move(model), .contacts = std::move(contacts), .recorded = {}};
  }

  void fly() {
    for (long k = 1; k <= periods; ++k)
      trajectory.advance(static_cast<double>(k) * period);
  }

  Problem problem;
  double period;
  integration::Trajectory trajectory;
};

std::vector<std::unique_ptr<Bumped>> motions() {
  std::vector<std::unique_ptr<Bumped>> result;
  for (const double gap : {0.1, 0.3, 0.5, 0.7})
    for (const double stiffness : {0.5, 1.7, 8.0, 40.0})
      for (const double frequency : {0.6, 0.9, 1.2, 1.8})
        result.push_back(std::make_unique<Bumped>(gap, stiffness, frequency));
  return result;
}

struct Result {
  double least = std::numeric_limits<double>::infinity(); ///< [s]
  double steps = 0, events = 0;                           ///< per period
  double end = 0;                                         ///< sum of all displacements at the end
};

Result measure(int repetitions, std::size_t at_once) {
  Result result;
  for (int i = 0; i < repetitions; ++i) {
    auto all = motions();
    std::size_t next = 0;
    const double start = processor_time();
    integration::run_batch(at_once, [&] {
      while (next < all.size())
        all[next++]->fly();
    });
    result.least = std::min(result.least, processor_time() - start);
    result.steps = result.events = result.end = 0;
    const double count = static_cast<double>(all.size()) * periods;
    for (const auto &motion : all) {
      const integration::Accuracy accuracy = motion->trajectory.accuracy();
      result.steps += static_cast<double>(accuracy.steps) / count;
      result.events += static_cast<double>(accuracy.events) / count;
      result.end += motion->trajectory.state()[0];
    }
  }
  return result;
}

void measure_all(int repetitions, const std::vector<std::size_t> &numbers) {
  const double count = static_cast<double>(motions().size()) * periods;
  for (const std::size_t at_once : numbers) {
    const Result result = measure(repetitions, at_once);
    std::printf("%2zu at once: %.3f us per forcing period, %.2f pieces, %.2f events, %.17g\n",
                at_once, 1e6 * result.least / count, result.steps, result.events, result.end);
  }
}

} // namespace

void run(int argc, char **argv) {
  std::vector<std::size_t> numbers;
  for (int i = 2; i < argc; ++i)
    numbers.push_back(std::strtoul(argv[i], nullptr, 10));
  if (numbers.empty())
    numbers = {1, 8, 16, 32};
  measure_all(argc > 1 ? std::atoi(argv[1]) : 5, numbers);
}

} // namespace vibroimpact::benchmarks

int main(int argc, char **argv) {
  try {
    const vibroimpact::benchmarks::PetscSession petsc("benchmark_lanes");
    vibroimpact::benchmarks::run(argc, argv);
    return 0;
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
