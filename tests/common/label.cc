#include "common/label.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace label_tests {

TEST(LabelTest, KeepsWhatItWasGiven) {
  const Label label("contact/heads/impact/time", "s", "instant", {"impact_heads"});
  EXPECT_EQ(label.name(), "contact/heads/impact/time");
  EXPECT_EQ(label.unit(), "s");
  EXPECT_EQ(label.description(), "instant");
  EXPECT_EQ(label.dimensions(), std::vector<std::string>{"impact_heads"});
}

TEST(LabelTest, EqualTextsAreKeptOnce) {
  const Label one("force", "N", "largest force");
  for (int i = 0; i < 1000; ++i) // the table grows meanwhile
    Label("force " + std::to_string(i), "N", "");
  const Label other("force", "N", "largest force");
  EXPECT_EQ(one, other);
  EXPECT_EQ(&one.name(), &other.name());
}

TEST(LabelTest, EveryPartOfTheTextCounts) {
  const Label label("force", "N", "largest force", {"time"});
  EXPECT_NE(label, Label("speed", "N", "largest force", {"time"}));
  EXPECT_NE(label, Label("force", "kN", "largest force", {"time"}));
  EXPECT_NE(label, Label("force", "N", "smallest force", {"time"}));
  EXPECT_NE(label, Label("force", "N", "largest force"));
}

} // namespace label_tests
} // namespace vibroimpact
