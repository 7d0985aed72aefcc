#include "analyses/character/uniform_samples.h"

#include "common/error.h"
#include "common/memory.h"
#include "parameters/text.h"

#include <algorithm>

namespace vibroimpact::analyses {

UniformSamples::UniformSamples(std::vector<ObservedSignal> signals, double start, double interval,
                               std::size_t count)
    : signals_(std::move(signals)), start_(start), interval_(interval), count_(count),
      values_(signals_.size()) {
  // The samples themselves, windowed, and their complex transform.
  const double bytes = 32 * static_cast<double>(signals_.size()) * static_cast<double>(count);
  if (const std::string lack = lack_of_memory(bytes); !lack.empty())
    throw NumericalError("for " + parameters::number_text(static_cast<double>(count)) +
                         " samples of the recorded signals " + lack);
}

void UniformSamples::step(const motion::StepView &view) {
  std::vector<double> positions;
  for (; next_ < count_; ++next_) {
    const double instant = start_ + static_cast<double>(next_) * interval_;
    if (instant > view.end())
      break;
    positions.push_back(std::clamp((instant - view.start()) / view.length(), 0.0, 1.0));
  }
  for (std::size_t s = 0; s < signals_.size() && !positions.empty(); ++s) {
    const StepFunction function = signals_[s].along(view);
    for (const double tau : positions)
      values_[s].push_back(function(tau));
  }
}

} // namespace vibroimpact::analyses
