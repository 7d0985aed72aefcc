#include "analyses/run/stored_steps.h"

#include "common/log.h"

#include <exception>

namespace vibroimpact::analyses {

StoredSteps::StoredSteps(ResultSink &sink, std::vector<std::size_t> index, RunSummary &summary,
                         std::function<Clock::time_point()> now)
    : sink_(sink), index_(std::move(index)), summary_(summary), known_(sink.find_steps(index_)),
      first_fresh_(known_.size()), now_(std::move(now)), next_time_(now_() + interval) {}

StoredSteps::~StoredSteps() {
  if (std::uncaught_exceptions() == exceptions_)
    return;
  try {
    hand_over();
  } catch (const std::exception &error) {
    log::warning(error.what());
  }
}

std::optional<std::string_view> StoredSteps::next() {
  if (taken_ == known_.size())
    return std::nullopt;
  ++summary_.steps_taken_over;
  return known_[taken_++];
}

void StoredSteps::keep(std::string_view bytes) {
  ++summary_.steps_computed;
  fresh_.emplace_back(bytes);
  if (now_() >= next_time_)
    hand_over();
}

void StoredSteps::hand_over() {
  if (fresh_.empty())
    return;
  sink_.store_steps(index_, first_fresh_, fresh_);
  first_fresh_ += fresh_.size();
  fresh_.clear();
  next_time_ = now_() + interval;
}

} // namespace vibroimpact::analyses
