#include "measurement.h"

#include "common/error.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>

namespace vibroimpact::benchmarks {

namespace {

constexpr double sample_seconds = 0.03; // far above the clock's resolution
constexpr double slow = 0.5;            // [s]; such motions are timed a few times only
constexpr int few = 3;

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
  return cpu_time_of([&] {
           for (long i = 0; i < calls; ++i)
             motion();
         }) /
         static_cast<double>(calls);
}

double quantile(std::vector<double> values, double fraction) {
  const auto at = values.begin() + std::lround(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

Spread spread(const std::vector<double> &values) {
  return {quantile(values, 0.5), quantile(values, 0.25), quantile(values, 0.75)};
}

// Third decades, tightest first.
std::vector<double> relative_tolerances() {
  std::vector<double> list;
  for (int i = -39; i <= -12; ++i)
    list.push_back(std::pow(10.0, i / 3.0));
  return list;
}

struct Truth {
  double excursion = 0;
  std::vector<long> contacts;
};

double relative_error(const Outcome &outcome, const Truth &truth) {
  return std::abs(outcome.excursion - truth.excursion) / truth.excursion;
}

bool reaches(const Outcome &outcome, const Truth &truth, double target) {
  return relative_error(outcome, truth) <= target && outcome.contacts == truth.contacts;
}

// The loosest tolerance from which on all tighter ones reach the target too: a loose one may hit by
// chance. Rounding may spoil the very tightest, which therefore are passed over.
std::optional<Setting> loosest(const Side &side, const Case &system, const Truth &truth,
                               double target, double absolute_factor) {
  std::optional<Setting> best;
  for (const double relative : relative_tolerances()) {
    const Tolerance tolerance{.relative = relative,
                              .absolute = absolute_factor * relative * system.length};
    const Outcome outcome = side.prepare(tolerance, true)();
    const bool good = reaches(outcome, truth, target);
    if (good)
      best = Setting{
          .tolerance = tolerance, .error = relative_error(outcome, truth), .outcome = outcome};
    if (side.exact || (!good && best))
      break;
  }
  return best;
}

long cost(const Setting &setting) {
  return setting.outcome.evaluations > 0 ? setting.outcome.evaluations : setting.outcome.steps;
}

// The absolute tolerance is free too; each side gets the one that suits it.
std::optional<Setting> cheapest(const Side &side, const Case &system, const Truth &truth,
                                double target) {
  std::optional<Setting> best;
  for (const double absolute_factor : {1.0, 1e-2}) {
    const auto setting = loosest(side, system, truth, target, absolute_factor);
    if (setting && (!best || cost(*setting) < cost(*best)))
      best = setting;
  }
  return best;
}

Outcome tight(const Side &side, const Case &system) {
  return side.prepare({.relative = 1e-13, .absolute = 1e-15 * system.length}, true)();
}

// Each side in turn, so that all meet the same moods of the machine. A first motion of each kind,
// which may prepare what all later ones use, is not timed.
void time_interleaved(const Case &system, int repetitions, CaseResult &result) {
  struct Timed {
    std::size_t side;
    Motion recorded, unrecorded;
    long calls = 0;
    std::vector<double> recorded_times{}, unrecorded_times{};
  };
  std::vector<Timed> list;
  for (std::size_t s = 0; s < system.sides.size(); ++s)
    if (const auto &setting = result.sides[s].setting) {
      const Side &side = system.sides[s];
      Timed timed{.side = s,
                  .recorded = side.prepare(setting->tolerance, true),
                  .unrecorded = side.prepare(setting->tolerance, false)};
      timed.recorded();
      timed.unrecorded();
      const double once = std::max(1e-7, time_of(timed.recorded, 1));
      timed.calls = once > slow ? 0 : std::max(1L, std::lround(sample_seconds / once));
      list.push_back(std::move(timed));
    }
  for (int i = 0; i < repetitions; ++i)
    for (Timed &timed : list)
      if (timed.calls > 0 || i < few) {
        timed.recorded_times.push_back(time_of(timed.recorded, std::max(1L, timed.calls)));
        timed.unrecorded_times.push_back(time_of(timed.unrecorded, std::max(1L, timed.calls)));
      }
  const auto base = std::find_if(list.begin(), list.end(),
                                 [&](const Timed &timed) { return timed.side == system.baseline; });
  for (const Timed &timed : list) {
    SideResult &side = result.sides[timed.side];
    side.recorded = spread(timed.recorded_times);
    side.unrecorded = spread(timed.unrecorded_times);
    if (base == list.end())
      continue;
    std::vector<double> speeds;
    const std::size_t count = std::min(timed.recorded_times.size(), base->recorded_times.size());
    for (std::size_t i = 0; i < count; ++i)
      speeds.push_back(base->recorded_times[i] / timed.recorded_times[i]);
    side.speed = spread(speeds);
  }
}

std::string text(const std::vector<long> &contacts) {
  std::string list;
  for (const long count : contacts)
    list += (list.empty() ? "" : " and ") + std::to_string(count);
  return list;
}

Truth agreed_truth(const Case &system, double target, CaseResult &result) {
  const Outcome a = tight(system.sides[system.references[0]], system);
  const Outcome b = tight(system.sides[system.references[1]], system);
  if (a.contacts != b.contacts)
    throw NumericalError(system.name + ": the tightest runs count " + text(a.contacts) +
                         " contacts against " + text(b.contacts));
  const Truth truth{.excursion = 0.5 * (a.excursion + b.excursion), .contacts = a.contacts};
  result.disagreement = std::abs(a.excursion - b.excursion) / truth.excursion;
  if (!(result.disagreement <= 0.1 * target))
    throw NumericalError(system.name + ": the tightest runs differ by " +
                         scientific(result.disagreement));
  return truth;
}

} // namespace

double cpu_time_of(const std::function<void()> &work) {
  const double start = cpu_seconds();
  work();
  return cpu_seconds() - start;
}

CaseResult measure(const Case &system, double target, int repetitions) {
  CaseResult result;
  const Truth truth = agreed_truth(system, target, result);
  for (const Side &side : system.sides) {
    result.sides.emplace_back();
    if (!side.prepare)
      continue;
    result.sides.back().setting = cheapest(side, system, truth, target);
    if (!result.sides.back().setting)
      throw NumericalError(system.name + ": " + side.name + " does not reach the relative error " +
                           scientific(target) + " with " + text(truth.contacts) + " contacts");
  }
  time_interleaved(system, repetitions, result);
  return result;
}

} // namespace vibroimpact::benchmarks
