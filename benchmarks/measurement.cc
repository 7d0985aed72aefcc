#include "measurement.h"

#include "common/error.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <optional>

namespace vibroimpact::benchmarks {

namespace {

constexpr double sample_seconds = 0.03; // far above the clock's resolution

std::string scientific(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1e", value);
  return text;
}

// CPU time of this process: other programs on the machine do not count directly.
double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double time_of(const Motion &motion, long calls) {
  const double start = cpu_seconds();
  for (long i = 0; i < calls; ++i)
    motion();
  return (cpu_seconds() - start) / static_cast<double>(calls);
}

long calls_per_sample(const Motion &motion) {
  return std::max(1L, std::lround(sample_seconds / std::max(1e-7, time_of(motion, 1))));
}

double quantile(std::vector<double> values, double fraction) {
  const auto at = values.begin() + std::lround(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Half decades, loosest first.
std::vector<double> relative_tolerances() {
  std::vector<double> list;
  for (int i = -8; i >= -26; --i)
    list.push_back(std::pow(10.0, 0.5 * i));
  return list;
}

// The loosest relative tolerance from which on all tighter ones reach the target too: a loose one
// may hit by chance.
std::optional<Setting> loosest(const Side &side, const Case &system, const Vector &reference,
                               double target, double absolute_factor) {
  std::optional<Setting> best;
  std::vector<double> list = relative_tolerances();
  std::reverse(list.begin(), list.end());
  for (const double relative : list) {
    const Tolerance tolerance{.relative = relative,
                              .absolute = absolute_factor * relative * system.length};
    const Outcome outcome = side.prepare(tolerance, true)();
    const double error = relative_error(system.weight, outcome.state, reference);
    if (!(error <= target))
      break;
    best = Setting{.tolerance = tolerance, .error = error, .outcome = outcome};
  }
  return best;
}

// The absolute tolerance is free too; each side gets the one that suits it.
Setting cheapest(const Side &side, const Case &system, const Vector &reference, double target) {
  std::optional<Setting> best;
  for (const double absolute_factor : {1.0, 1e-2, 1e-4}) {
    const auto setting = loosest(side, system, reference, target, absolute_factor);
    if (setting && (!best || setting->outcome.evaluations < best->outcome.evaluations))
      best = setting;
  }
  if (!best)
    throw NumericalError(system.name + ": " + side.name + " does not reach the relative error " +
                         scientific(target));
  return *best;
}

Outcome tight(const Side &side, const Case &system) {
  return side.prepare({.relative = 1e-13, .absolute = 1e-15 * system.length}, true)();
}

void require_same_impacts(const Case &system, const Outcome &a, const Outcome &b) {
  if (a.impacts != b.impacts)
    throw NumericalError(system.name + ": " + std::to_string(a.impacts) + " impacts against " +
                         std::to_string(b.impacts));
}

void time_interleaved(const Case &system, int repetitions, CaseResult &result) {
  const Motion a = system.vibroimpact.prepare(result.vibroimpact.setting.tolerance, false);
  const Motion b = system.odeint.prepare(result.odeint.setting.tolerance, false);
  const long calls_a = calls_per_sample(a);
  const long calls_b = calls_per_sample(b);
  std::vector<double> times_a, times_b, ratios;
  for (int i = 0; i < repetitions; ++i) {
    times_a.push_back(time_of(a, calls_a));
    times_b.push_back(time_of(b, calls_b));
    ratios.push_back(times_a.back() / times_b.back());
  }
  result.vibroimpact.seconds = quantile(times_a, 0.5);
  result.odeint.seconds = quantile(times_b, 0.5);
  result.ratio = quantile(ratios, 0.5);
  result.ratio_lower_quartile = quantile(ratios, 0.25);
  result.ratio_upper_quartile = quantile(ratios, 0.75);
}

} // namespace

double relative_error(const Vector &weight, const Vector &state, const Vector &reference) {
  return std::sqrt(weight.dot((state - reference).cwiseAbs2()) / weight.dot(reference.cwiseAbs2()));
}

CaseResult measure(const Case &system, double target, int repetitions) {
  CaseResult result;
  const Outcome a = tight(system.vibroimpact, system);
  const Outcome b = tight(system.odeint, system);
  require_same_impacts(system, a, b);
  result.disagreement = relative_error(system.weight, a.state, b.state);
  if (!(result.disagreement <= 0.1 * target))
    throw NumericalError(system.name + ": the tightest runs differ by " +
                         scientific(result.disagreement));
  const Vector reference = 0.5 * (a.state + b.state);
  result.vibroimpact.setting = cheapest(system.vibroimpact, system, reference, target);
  result.odeint.setting = cheapest(system.odeint, system, reference, target);
  require_same_impacts(system, result.vibroimpact.setting.outcome, a);
  require_same_impacts(system, result.odeint.setting.outcome, a);
  time_interleaved(system, repetitions, result);
  return result;
}

} // namespace vibroimpact::benchmarks
