// Error against tolerance of random contacts, law by law: lines "law,tolerance,median,largest" for
// the study of that name.
//
//   study_contact_errors [contacts of each law]
#include "support/random_contact.h"
#include "support/reference_comparison.h"

#include <petscsys.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>

namespace vibroimpact::testing {
namespace {

constexpr int decades = 9; ///< 1e-4 ... 1e-12
constexpr std::array names = {"Hertz", "Hunt-Crossley", "Kuwabara-Kono", "Tsuji"};

std::size_t law_of(const RandomContact &contact) {
  const ReferenceLaw &law = contact.system.contacts.front().law;
  if (law.kind == ReferenceLaw::Kind::kuwabara_kono)
    return 2;
  if (law.kind == ReferenceLaw::Kind::tsuji)
    return 3;
  return law.damping > 0 ? 1 : 0;
}

using Errors = std::array<std::vector<double>, decades>;

void measure(const RandomContact &tried, Errors &errors) {
  const ReferenceResult reference = reference_motion(tried.system, tried.start, tried.end);
  for (int i = 0; i < decades; ++i) {
    const MotionError error =
        compare(program_motion(tried.system, tried.start, tried.end, std::pow(10, -4 - i)),
                tried.system, reference);
    errors[static_cast<std::size_t>(i)].push_back(error.largest());
  }
}

void run(std::size_t count) {
  std::array<Errors, names.size()> errors;
  for (std::uint64_t seed = 1;; ++seed) {
    const RandomContact tried = random_contact(seed);
    Errors &of_law = errors[law_of(tried)];
    if (of_law[0].size() < count)
      measure(tried, of_law);
    if (std::all_of(errors.begin(), errors.end(),
                    [&](const Errors &law) { return law[0].size() == count; }))
      break;
  }
  std::printf("law,tolerance,median,largest\n");
  for (std::size_t law = 0; law < names.size(); ++law)
    for (int i = 0; i < decades; ++i) {
      std::vector<double> &list = errors[law][static_cast<std::size_t>(i)];
      std::sort(list.begin(), list.end());
      std::printf("%s,1e-%02d,%.2e,%.2e\n", names[law], 4 + i, list[list.size() / 2], list.back());
    }
}

} // namespace
} // namespace vibroimpact::testing

int main(int argc, char **argv) {
  const long count = argc > 1 ? std::atol(argv[1]) : 100;
  if (argc > 2 || count < 1) {
    std::fprintf(stderr, "usage: study_contact_errors [contacts of each law]\n");
    return 2;
  }
  PetscInitializeNoArguments();
  int code = 0;
  try {
    vibroimpact::testing::run(static_cast<std::size_t>(count));
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
    code = 1;
  }
  PetscFinalize();
  return code;
}
