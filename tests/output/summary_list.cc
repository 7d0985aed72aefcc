#include "output/summary_list.h"

#include <cmath>
#include <gtest/gtest.h>

namespace vibroimpact::output {
namespace summary_list_tests {

TEST(SummaryList, TextHasTwelveDigitsAndTheUnit) {
  SummaryList list;
  list.add("a.b[1]", 2.0 / 3, "m/s");
  list.add("n", 17, "1");
  list.add("n", std::copysign(NAN, -1.0), "1");
  EXPECT_EQ(list.text(), "a.b[1] = 0.666666666667 [m/s]\nn = 17 [1]\nn = nan [1]\n");
}

TEST(SummaryList, RemarksAndNotes) {
  SummaryList list;
  list.add("failed[1]", 2, "1", "stuck\nat 1 s");
  list.add_note("fit[2]", "\"k\" is free");
  EXPECT_EQ(list.text(), "failed[1] = 2 [1]  stuck at 1 s\n# fit[2]: \"k\" is free\n");
  EXPECT_EQ(list.json(), "{\n  \"values\": {\n"
                         "    \"failed[1]\": {\"value\": 2, \"unit\": \"1\", "
                         "\"remark\": \"stuck at 1 s\"}\n"
                         "  },\n  \"notes\": {\n"
                         "    \"fit[2]\": \"\\\"k\\\" is free\"\n  }\n}\n");
}

TEST(SummaryList, JsonOfNothing) {
  EXPECT_EQ(SummaryList().json(), "{\n  \"values\": {\n  },\n  \"notes\": {\n  }\n}\n");
}

TEST(SummaryList, AppendedEntriesFollow) {
  SummaryList first;
  SummaryList second;
  first.add("a", 1, "m");
  second.add("b", 2, "s");
  first.append(second);
  EXPECT_EQ(first.text(), "a = 1 [m]\nb = 2 [s]\n");
}

} // namespace summary_list_tests
} // namespace vibroimpact::output
