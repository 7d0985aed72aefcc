// Cost of motions that nobody watches, one after the other and side by side in vector lanes.
//
//   benchmark_lanes [repetitions]
//
// A mass between two bumpers that creep back by themselves, for several gaps, stiffnesses and
// frequencies, flown period by period as settling does. Processor time, the least of all
// repetitions.
#include "contact/laws/relaxing_stop.h"
#include "integration/trajectory.h"
#include "sides.h"

#include <petscsys.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
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
    Model model({body_along_x("mass", one, one, damping * one, one)});
    model.add_base_motion("ground",
                          std::make_shared<Harmonic>(Given::acceleration, 0.199, frequency, 0), {0},
                          Vector3::UnitX());
    const auto law = std::make_shared<RelaxingStop>(stiffness, 5 * damping);
    ContactSet contacts({contact_of_heads(model, "mass", "", 1, gap, law),
                         contact_of_heads(model, "mass", "", -1, gap, law)});
    return {.model = std::move(model), .contacts = std::move(contacts), .recorded = {}};
  }

  void fly() {
    for (long k = 1; k <= periods; ++k)
      trajectory.advance(static_cast<double>(k) * period);
  }

  Problem problem;
  double period;
  Trajectory trajectory;
};

std::vector<std::unique_ptr<Bumped>> motions() {
  std::vector<std::unique_ptr<Bumped>> result;
  for (const double gap : {0.1, 0.3, 0.5, 0.7})
    for (const double stiffness : {0.5, 1.7, 8.0, 40.0})
      for (const double frequency : {0.6, 0.9, 1.2, 1.8})
        result.push_back(std::make_unique<Bumped>(gap, stiffness, frequency));
  return result;
}

void measure_motions(int repetitions) {
  double least = 1e9;
  long steps = 0, events = 0;
  std::size_t count = 0;
  double sum = 0;
  for (int i = 0; i < repetitions; ++i) {
    auto all = motions();
    count = all.size();
    const double start = processor_time();
    for (auto &motion : all)
      motion->fly();
    least = std::min(least, processor_time() - start);
    steps = events = 0;
    sum = 0;
    for (auto &motion : all) {
      steps += motion->trajectory.accuracy().steps;
      events += motion->trajectory.accuracy().events;
      sum += motion->trajectory.state()[0];
    }
  }
  const double all_periods = static_cast<double>(count) * periods;
  std::printf("scalar %.3f us per period, %.2f pieces, %.2f events, %.15g\n",
              1e6 * least / all_periods, steps / all_periods, events / all_periods, sum);
}

} // namespace

void run(int repetitions) { measure_motions(repetitions); }

} // namespace vibroimpact::benchmarks

int main(int argc, char **argv) {
  char program[] = "benchmark_lanes";
  char skip[] = "-skip_petscrc";
  char *arguments[] = {program, skip, nullptr};
  int count = 2;
  char **private_arguments = arguments;
  if (PetscInitialize(&count, &private_arguments, nullptr, nullptr) != 0)
    return 1;
  vibroimpact::benchmarks::run(argc > 1 ? std::atoi(argv[1]) : 5);
  PetscFinalize();
  return 0;
}
