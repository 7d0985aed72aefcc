// The steps towards one point of an analysis, kept while they are taken.
//
// They are handed to the sink a tenth of a second after the last ones at the earliest, and where
// the computation is left: a kill at any moment loses no more than that, and short computations
// store nothing.
#pragma once

#include "analyses/run/runner.h"
#include "common/step_record.h"

#include <chrono>
#include <functional>

namespace vibroimpact::analyses {

class StoredSteps : public StepRecord {
public:
  using Clock = std::chrono::steady_clock;

  /// Keeps references; counts steps in the summary.
  StoredSteps(ResultSink &sink, std::vector<std::size_t> index, RunSummary &summary,
              std::function<Clock::time_point()> now = &Clock::now);
  /// Hands over what is left where an exception leaves the computation.
  ~StoredSteps() override;
  StoredSteps(const StoredSteps &) = delete;
  StoredSteps &operator=(const StoredSteps &) = delete;

  std::optional<std::string_view> next() override;
  void keep(std::string_view bytes) override;

private:
  static constexpr std::chrono::milliseconds interval{100};

  void hand_over();

  ResultSink &sink_;
  std::vector<std::size_t> index_;
  RunSummary &summary_;
  std::vector<std::string> known_;
  std::size_t taken_ = 0; ///< of those known
  std::vector<std::string> fresh_;
  std::size_t first_fresh_;
  std::function<Clock::time_point()> now_;
  Clock::time_point next_time_;
  int exceptions_ = std::uncaught_exceptions();
};

} // namespace vibroimpact::analyses
