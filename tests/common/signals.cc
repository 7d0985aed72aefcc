#include "common/signals.h"

#include <csignal>
#include <gtest/gtest.h>

namespace vibroimpact {
namespace signals_tests {

TEST(Signals, EndTheProcessAtOnceWhereNothingIsAtStake) {
  for (const int number : {SIGINT, SIGTERM})
    EXPECT_EXIT(
        {
          install_signal_handlers();
          std::raise(number);
        },
        ::testing::ExitedWithCode(stopped_exit_code), "stopped by a signal");
}

TEST(Signals, FirstOneOnlyRequestsAStopWhereResultsAreAtStake) {
  for (const int number : {SIGINT, SIGTERM}) {
    install_signal_handlers();
    const DeferSignals results;
    EXPECT_FALSE(stop_requested());
    EXPECT_NO_THROW(leave_if_stopped());
    std::raise(number);
    EXPECT_TRUE(stop_requested());
    EXPECT_THROW(leave_if_stopped(), Interrupted);
  }
  install_signal_handlers();
  EXPECT_FALSE(stop_requested());
}

TEST(Signals, SecondOneEndsTheProcess) {
  EXPECT_EXIT(
      {
        install_signal_handlers();
        const DeferSignals results;
        std::raise(SIGINT);
        std::raise(SIGTERM);
      },
      ::testing::KilledBySignal(SIGTERM), "");
}

TEST(Signals, OneThatWasDeferredIsNotForgotten) {
  install_signal_handlers();
  {
    const DeferSignals results;
    std::raise(SIGTERM);
  }
  EXPECT_TRUE(stop_requested());
  install_signal_handlers();
}

TEST(Signals, BehindResultsTheyEndTheProcessAgain) {
  EXPECT_EXIT(
      {
        install_signal_handlers();
        { const DeferSignals results; }
        std::raise(SIGTERM);
      },
      ::testing::ExitedWithCode(stopped_exit_code), "stopped by a signal");
}

} // namespace signals_tests
} // namespace vibroimpact
