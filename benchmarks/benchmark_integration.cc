// Cost of the time integration against Boost.odeint on the same equations at the same error.
//
//   benchmark_integration [repetitions]
//
// Exit code 1 when the two disagree; how fast either is decides nothing.
#include "cases.h"

#include "common/error.h"

#include <petscsys.h>

#include <cstdio>
#include <cstdlib>
#include <exception>

namespace vibroimpact::benchmarks {

namespace {

constexpr double target = 1e-8;
constexpr int default_repetitions = 15;

void print_head() {
  std::printf("%-20s %-12s %8s %9s %8s %7s %8s %7s %8s %8s %9s %9s  %s\n", "system", "side", "rtol",
              "atol [m]", "error", "steps", "rejected", "impacts", "rhs", "us/step", "us/impact",
              "ms", "ratio");
}

void print_side(const Case &system, const Side &side, const SideResult &result) {
  const Setting &setting = result.setting;
  const Outcome &outcome = setting.outcome;
  const double microseconds = 1e6 * result.seconds;
  std::printf("%-20s %-12s %8.1e %9.1e %8.1e %7ld %8ld %7ld %8ld %8.3f %9.2f %9.3f",
              system.name.c_str(), side.name.c_str(), setting.tolerance.relative,
              setting.tolerance.absolute, setting.error, outcome.steps, outcome.rejected,
              outcome.impacts, outcome.evaluations,
              microseconds / static_cast<double>(outcome.steps),
              microseconds / static_cast<double>(outcome.impacts), 1e-3 * microseconds);
}

void print(const Case &system, const CaseResult &result) {
  print_side(system, system.vibroimpact, result.vibroimpact);
  std::printf("  %.2f (%.2f-%.2f)\n", result.ratio, result.ratio_lower_quartile,
              result.ratio_upper_quartile);
  print_side(system, system.odeint, result.odeint);
  std::printf("  1; tightest runs differ by %.1e\n", result.disagreement);
  std::fflush(stdout);
}

int run(int repetitions) {
  int failures = 0;
  print_head();
  for (const Case &system :
       {forced_mass_on_linear_stop(), forced_mass_on_hertz_stop(), released_beams()}) {
    try {
      print(system, measure(system, target, repetitions));
    } catch (const NumericalError &error) {
      std::fprintf(stderr, "%s\n", error.what());
      ++failures;
    }
  }
  return failures > 0 ? 1 : 0;
}

} // namespace

} // namespace vibroimpact::benchmarks

int main(int argc, char **argv) {
  using namespace vibroimpact::benchmarks;
  const int repetitions = argc > 1 ? std::atoi(argv[1]) : default_repetitions;
  if (argc > 2 || repetitions < 1) {
    std::fprintf(stderr, "usage: benchmark_integration [repetitions]\n");
    return 2;
  }
  char program[] = "benchmark_integration";
  char skip[] = "-skip_petscrc";
  char *arguments[] = {program, skip, nullptr};
  int count = 2;
  char **private_arguments = arguments;
  if (PetscInitialize(&count, &private_arguments, nullptr, nullptr) != 0)
    return 1;
  int code = 1;
  try {
    code = run(repetitions);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  PetscFinalize();
  return code;
}
