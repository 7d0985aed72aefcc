// Ten thousand random contacts against their references: never more than ten times the tolerance.
// VIBROIMPACT_CONTACTS sets another number.
#include "support/random_contact.h"
#include "support/reference_comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>

namespace vibroimpact::testing {
namespace random_contacts_tests {

std::uint64_t wanted_contacts() {
  const char *number = std::getenv("VIBROIMPACT_CONTACTS");
  return number ? std::stoull(number) : 10000;
}

TEST(RandomContactsTest, NeverMoreThanTenTimesTheTolerance) {
  double worst = 0;
  for (std::uint64_t seed = 1; seed <= wanted_contacts(); ++seed) {
    const RandomContact tried = random_contact(seed);
    MotionError error;
    try {
      error = compare(program_motion(tried.system, tried.start, tried.end, tried.tolerance),
                      tried.system, reference_motion(tried.system, tried.start, tried.end));
    } catch (const std::exception &failure) {
      ADD_FAILURE() << "seed " << seed << ": " << failure.what();
      continue;
    }
    EXPECT_TRUE(error.same_contacts) << "seed " << seed;
    EXPECT_LE(error.largest(), 10 * tried.tolerance) << "seed " << seed;
    worst = std::max(worst, error.largest() / tried.tolerance);
  }
  std::cout << wanted_contacts() << " contacts, largest error over tolerance " << worst << '\n';
}

} // namespace random_contacts_tests
} // namespace vibroimpact::testing
