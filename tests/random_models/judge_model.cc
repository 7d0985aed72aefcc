#include "random_models/judge_model.h"

#include "random_models/random_text.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::testing {

namespace {

using Overrides = std::vector<parameters::Override>;

constexpr double agreement = 1e-6;
constexpr double nudge = 1e-9;
constexpr double sensitivity_factor = 30;
constexpr double most_apart_by_tolerance = 1e-3;
constexpr double closed_balance = 1e-6;
// A contact change that is missed goes with tight tolerances altogether, errors of steps do not.
constexpr double least_left = 1e-4;

bool is_history(const Field &field, const std::string &kind) {
  return field.values.size() > 100 && field.name().find("/pulse/") == std::string::npos &&
         field.name().find("/" + kind) != std::string::npos;
}

// Largest difference but for the 2 % of samples that differ most.
double typical_difference(const Field &one, const Field &other) {
  if (one.values.size() != other.values.size())
    return INFINITY;
  std::vector<double> distances;
  for (std::size_t i = 0; i < one.values.size(); ++i)
    distances.push_back(std::abs(one.values[i] - other.values[i]));
  std::sort(distances.begin(), distances.end());
  return distances[distances.size() * 98 / 100];
}

double difference_of_kind(const ModelRun &one, const ModelRun &other,
                          std::initializer_list<const char *> kinds) {
  // A motion of less is rest; in m or N.
  double largest = 1e-9;
  double apart = 0;
  for (const Field &field : one.fields)
    for (const char *kind : kinds) {
      if (!is_history(field, kind))
        continue;
      for (const double value : field.values)
        largest = std::max(largest, std::abs(value));
      const auto same = std::find_if(other.fields.begin(), other.fields.end(),
                                     [&](const Field &f) { return f.name() == field.name(); });
      apart =
          same == other.fields.end() ? INFINITY : std::max(apart, typical_difference(field, *same));
    }
  return apart / largest;
}

// Steps short enough for dense output to be as accurate as their ends.
Overrides by_runge_kutta(const std::string &text, double steps_per_sample) {
  const std::string key = "Sampling interval = ";
  const double interval = std::stod(text.substr(text.find(key) + key.size()));
  return {{.path = "Integration/Method", .value = "rk", .origin = "test"},
          {.path = "Integration/Maximum step",
           .value = digits(interval / steps_per_sample) + " s",
           .origin = "test"}};
}

double residual_of(const ModelRun &run) {
  for (const Field &field : run.fields)
    if (field.name() == "energy_residual")
      return field.values.front();
  return NAN;
}

// A hundredth of what the model sets.
Overrides with_tight_tolerances(Overrides overrides) {
  overrides.push_back(
      {.path = "Integration/Relative tolerance", .value = "1e-12", .origin = "test"});
  overrides.push_back(
      {.path = "Integration/Absolute tolerance", .value = "1e-17 m", .origin = "test"});
  return overrides;
}

double difference_if_both_end(const ModelRun &one, const ModelRun &other) {
  return one.status == other.status ? difference(one, other) : INFINITY;
}

Verdict judge_difference(const ModelRun &own, const ModelRun &rk, const std::string &text,
                         const std::string &nudged_text, const std::string &folder) {
  const double apart = difference(own, rk);
  if (apart <= agreement)
    return {.word = "agree", .detail = digits(apart)};
  const ModelRun nudged = run_model(nudged_text, folder, {});
  const double by_nudge = difference_if_both_end(own, nudged);
  std::string detail = digits(apart) + " apart; by the nudge " + digits(by_nudge);
  if (apart <= sensitivity_factor * by_nudge)
    return {.word = "sensitive", .detail = detail};
  const ModelRun close = run_model(text, folder, with_tight_tolerances(by_runge_kutta(text, 8)));
  const double by_tolerance = difference_if_both_end(rk, close);
  detail += "; rk from itself " + digits(by_tolerance);
  if (apart <= sensitivity_factor * by_tolerance)
    return {.word = "sensitive", .detail = detail};
  const double left =
      difference_if_both_end(run_model(text, folder, with_tight_tolerances({})), close);
  detail += "; both with tight tolerances " + digits(left);
  const bool converge = apart <= most_apart_by_tolerance && residual_of(own) <= closed_balance &&
                        left <= std::max(agreement, apart / 10) && left >= least_left * apart;
  return {.word = converge ? "converge" : "wrong", .detail = detail};
}

Verdict judge(const std::string &text, const std::string &nudged, const std::string &folder) {
  const ModelRun own = run_model(text, folder, {});
  if (own.status == ModelRun::Status::refused)
    return {.word = "refused", .detail = own.reason};
  const ModelRun rk = run_model(text, folder, by_runge_kutta(text, 4));
  Verdict verdict;
  if (own.status == ModelRun::Status::failed)
    verdict = {.word = rk.status == own.status ? "failed" : "failed-default", .detail = own.reason};
  else if (rk.status == ModelRun::Status::failed)
    verdict = {.word = "failed-rk", .detail = rk.reason};
  else
    verdict = judge_difference(own, rk, text, nudged, folder);
  verdict.seconds = own.seconds;
  verdict.energy_residual = residual_of(own);
  return verdict;
}

} // namespace

double difference(const ModelRun &one, const ModelRun &other) {
  return std::max(difference_of_kind(one, other, {"displacement", "gap"}),
                  difference_of_kind(one, other, {"normal_force"}));
}

Verdict judge_model(std::uint64_t seed, const std::string &folder) {
  return judge(random_model({.seed = seed}), random_model({.seed = seed, .nudge = nudge}), folder);
}

Verdict judge_text(const std::string &text, const std::string &folder) {
  const std::string key = "Mass = ";
  const std::size_t place = text.find(key) + key.size();
  std::size_t length = 0;
  const double mass = std::stod(text.substr(place), &length);
  std::string nudged = text;
  nudged.replace(place, length, digits(mass * (1 + nudge)));
  return judge(text, nudged, folder);
}

} // namespace vibroimpact::testing
