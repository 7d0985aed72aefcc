#include "common/signals.h"

#include <csignal>
#include <gtest/gtest.h>

namespace vibroimpact {
namespace {

TEST(Signals, FirstOneOnlyRequestsAStop) {
  for (const int number : {SIGINT, SIGTERM}) {
    install_signal_handlers();
    EXPECT_FALSE(stop_requested());
    std::raise(number);
    EXPECT_TRUE(stop_requested());
  }
}

TEST(Signals, SecondOneEndsTheProcess) {
  EXPECT_EXIT(
      {
        install_signal_handlers();
        std::raise(SIGINT);
        std::raise(SIGTERM);
      },
      ::testing::KilledBySignal(SIGTERM), "");
}

} // namespace
} // namespace vibroimpact
