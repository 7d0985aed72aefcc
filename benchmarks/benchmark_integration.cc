// Cost of the time integration beside other programs on the same equations at the same error.
//
//   benchmark_integration [repetitions [system]]
//
// Exit code 1 when excursions or numbers of contacts disagree; how fast anything is decides
// nothing.
#include "cases.h"

#include "common/error.h"
#include "petsc_session.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <numeric>

namespace vibroimpact::benchmarks {

namespace {

constexpr double target = 1e-8;
constexpr int default_repetitions = 15;

void print_head() {
  std::printf(
      "us: microseconds of processor time per forcing period, excursion of one displacement "
      "recorded or\nnot; speed: times that of odeint, median (quartiles)\n\n");
  std::printf("%-24s %-15s %8s %8s %8s %8s %9s %9s %10s  %s\n", "system", "side", "rtol", "error",
              "steps", "contacts", "us", "us, bare", "us/contact", "speed");
}

void print_side(const Case &system, const Side &side, const SideResult &result) {
  std::printf("%-24s %-15s ", system.name.c_str(), side.name.c_str());
  if (!result.setting) {
    std::printf("not there when this program was built\n");
    return;
  }
  const Outcome &outcome = result.setting->outcome;
  const auto periods = static_cast<double>(system.periods);
  const double contacts =
      static_cast<double>(std::accumulate(outcome.contacts.begin(), outcome.contacts.end(), 0L)) /
      periods;
  const double recorded = 1e6 * result.recorded.median / periods;
  if (side.exact)
    std::printf("%8s", "-");
  else
    std::printf("%8.1e", result.setting->tolerance.relative);
  std::printf(" %8.1e %8.1f %8.2f %9.3g %9.3g ", result.setting->error,
              static_cast<double>(outcome.steps) / periods, contacts, recorded,
              1e6 * result.unrecorded.median / periods);
  if (contacts > 0)
    std::printf("%10.3g", recorded / contacts);
  else
    std::printf("%10s", "-");
  std::printf("  %.3g (%.3g-%.3g)\n", result.speed.median, result.speed.lower_quartile,
              result.speed.upper_quartile);
}

void print(const Case &system, const CaseResult &result) {
  for (std::size_t s = 0; s < system.sides.size(); ++s)
    print_side(system, system.sides[s], result.sides[s]);
  std::printf("%-24s the tightest runs of %s and %s differ by %.1e\n", "",
              system.sides[system.references[0]].name.c_str(),
              system.sides[system.references[1]].name.c_str(), result.disagreement);
  std::fflush(stdout);
}

struct NamedCase {
  const char *name;
  Case (*make)();
};
constexpr NamedCase cases[] = {{"bumpers", bumpers},
                               {"bilinear", bilinear_masses},
                               {"absorber", absorber},
                               {"rest", absorber_from_rest},
                               {"beams", beam_pair},
                               {"stop", beam_on_stop},
                               {"stops1", one_stop},
                               {"stops2", two_stops},
                               {"stops4", four_stops},
                               {"stops8", eight_stops},
                               {"stops16", sixteen_stops},
                               {"turns", friction_without_stops},
                               {"stick", friction_with_stops},
                               {"ring", ring},
                               {"rub", ring_with_friction},
                               {"hertzring", hertz_ring},
                               {"hertzrub", hertz_ring_with_friction},
                               {"duffing", duffing},
                               {"rotor", motor_on_frame}};

int run(int repetitions, const char *only) {
  int failures = 0;
  print_head();
  for (const NamedCase &named : cases) {
    if (only && std::strcmp(only, named.name) != 0)
      continue;
    try {
      const Case system = named.make();
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
  if (argc > 3 || repetitions < 1) {
    std::fprintf(stderr, "usage: benchmark_integration [repetitions [system]]\n");
    return 2;
  }
  try {
    const PetscSession petsc("benchmark_integration");
    return run(repetitions, argc > 2 ? argv[2] : nullptr);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
