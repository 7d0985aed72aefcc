#include "analyses/recorders/sampler.h"

#include "common/error.h"
#include "common/memory.h"
#include "parameters/text.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

namespace {

std::vector<double> uniform_instants(double start, double interval, std::size_t count,
                                     std::size_t signals) {
  // The samples themselves, windowed, and their complex transform.
  const double bytes = 32 * static_cast<double>(signals) * static_cast<double>(count);
  if (const std::string lack = lack_of_memory(bytes); !lack.empty())
    throw NumericalError("for " + parameters::number_text(static_cast<double>(count)) +
                         " samples of the recorded signals " + lack);
  std::vector<double> instants(count);
  for (std::size_t i = 0; i < count; ++i)
    instants[i] = start + static_cast<double>(i) * interval;
  return instants;
}

} // namespace

std::vector<double> equal_instants(double first, double last, double interval) {
  const auto count = static_cast<std::size_t>(std::floor((last - first) / interval * (1 + 1e-12)));
  std::vector<double> instants;
  for (std::size_t i = 0; i <= count; ++i)
    instants.push_back(std::min(first + static_cast<double>(i) * interval, last));
  return instants;
}

std::size_t end_of_step(const std::vector<double> &instants, std::size_t next, double end) {
  while (next < instants.size() && instants[next] <= end)
    ++next;
  return next;
}

Sampler::Sampler(std::vector<Observable> observables, std::vector<double> instants)
    : observables_(std::move(observables)), instants_(std::move(instants)),
      values_(observables_.size()) {}

Sampler::Sampler(std::vector<Observable> observables, double start, double interval,
                 std::size_t count)
    : Sampler(observables, uniform_instants(start, interval, count, observables.size())) {}

void Sampler::step(const motion::StepView &view) {
  const std::size_t last = end_of_step(instants_, next_, view.end());
  for (std::size_t k = 0; k < observables_.size() && last > next_; ++k) {
    const StepFunction function = along(observables_[k], view);
    for (std::size_t i = next_; i < last; ++i)
      values_[k].push_back(
          function(std::clamp((instants_[i] - view.start()) / view.length(), 0.0, 1.0)));
  }
  next_ = last;
}

std::vector<double> Sampler::times() const {
  return {instants_.begin(), instants_.begin() + static_cast<std::ptrdiff_t>(next_)};
}

void Sampler::add_fields(const FieldWriter &result, const std::string &dimension) const {
  result.series(dimension, dimension, times(), "s", "time");
  for (std::size_t k = 0; k < observables_.size(); ++k)
    result.series(observables_[k].path, dimension, values_[k], observables_[k].unit,
                  observables_[k].description());
}

} // namespace vibroimpact::analyses
