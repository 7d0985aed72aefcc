#include "common/progress.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>

namespace vibroimpact {
namespace progress_tests {

class ProgressTest : public ::testing::Test {
protected:
  Surroundings surroundings(bool terminal) {
    return {&stream, terminal, [this] { return now; }};
  }
  long count(char letter) const {
    const std::string text = stream.str();
    return std::count(text.begin(), text.end(), letter);
  }

  std::ostringstream stream;
  double now = 100;
};

TEST_F(ProgressTest, SaysRateAndTimeLeft) {
  Progress progress(40, "response", surroundings(false));
  now += 5;
  progress.update(10);
  EXPECT_EQ(stream.str(), "response: 10 of 40 (25 %), 2/s, 15 s left\n");
}

TEST_F(ProgressTest, SlowCasesGetTheirTimeInsteadOfARate) {
  Progress progress(100, "map", surroundings(false));
  now += 7300;
  progress.update(50);
  EXPECT_EQ(stream.str(), "map: 50 of 100 (50 %), 146 s each, 2 h 2 min left\n");
}

TEST_F(ProgressTest, PartOfACaseCounts) {
  Progress progress(2, "push", surroundings(true));
  now += 60;
  progress.update(1, 0.5);
  EXPECT_EQ(stream.str(), "\r\033[Kpush: 1 of 2 (75 %), 40 s each, 20 s left");
}

TEST_F(ProgressTest, PartsOfCasesMakePlainLinesOnlyAfterHalfAMinute) {
  Progress progress(1, "push", surroundings(false));
  for (int i = 1; i < 100; ++i) {
    now += 0.4;
    progress.update(0, i / 100.0);
  }
  EXPECT_EQ(count('\n'), 1);
  progress.update(1);
  EXPECT_EQ(count('\n'), 2);
}

TEST_F(ProgressTest, PlainLinesComeAtTenths) {
  Progress progress(1000, "response", surroundings(false));
  for (std::size_t done = 1; done <= 1000; ++done) {
    now += 0.001;
    progress.update(done);
  }
  EXPECT_EQ(count('\n'), 10);
  EXPECT_EQ(count('\r'), 0);
}

TEST_F(ProgressTest, PlainLinesComeAfterHalfAMinute) {
  Progress progress(1000, "response", surroundings(false));
  now += 29;
  progress.update(1);
  EXPECT_EQ(count('\n'), 0);
  now += 2;
  progress.update(2);
  EXPECT_EQ(count('\n'), 1);
}

TEST_F(ProgressTest, LiveLineMovesAtMostFiveTimesASecond) {
  {
    Progress progress(1000, "response", surroundings(true));
    for (std::size_t done = 1; done < 1000; ++done) {
      now += 0.001;
      progress.update(done);
    }
    EXPECT_EQ(count('\n'), 0);
    EXPECT_GE(count('\r'), 4);
    EXPECT_LE(count('\r'), 6);
  }
  EXPECT_EQ(count('\n'), 1) << "a line left open ends with the object";
}

TEST_F(ProgressTest, EndsTheLiveLineOnce) {
  {
    Progress progress(2, "response", surroundings(true));
    now += 1;
    progress.update(2);
    now += 1;
    progress.update(2);
  }
  EXPECT_EQ(stream.str(), "\r\033[Kresponse: 2 of 2 (100 %), 2/s, took 1 s\n");
}

} // namespace progress_tests
} // namespace vibroimpact
