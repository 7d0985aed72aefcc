// Messages go to the terminal and to the log file that is open, from rank 0 alone.
#include "common/log.h"

#include "temporary_folder.h"
#include "text_of.h"

#include <gtest/gtest.h>

namespace vibroimpact {
namespace log_tests {

TEST(LogTest, EachFileHoldsWhatWasSaidWhileItWasOpen) {
  const testing::TemporaryFolder folder;
  const std::string first = folder.path() / "first.log";
  const std::string second = folder.path() / "second.log";
  ::testing::internal::CaptureStdout();
  log::info("before");
  log::open_file(first);
  log::info("one");
  log::open_file(second);
  log::warning("two");
  log::open_file("");
  log::info("after");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "before\none\nwarning: two\nafter\n");
  EXPECT_EQ(testing::text_of(first), "one\n");
  EXPECT_EQ(testing::text_of(second), "warning: two\n");
}

TEST(LogTest, OtherRanksAreSilent) {
  const testing::TemporaryFolder folder;
  const std::string file = folder.path() / "rank.log";
  ::testing::internal::CaptureStdout();
  log::set_rank(1);
  log::open_file(file);
  log::info("one");
  log::set_rank(0);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_FALSE(std::filesystem::exists(file));
}

} // namespace log_tests
} // namespace vibroimpact
