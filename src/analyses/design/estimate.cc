#include "analyses/design/estimate.h"

#include "analyses/design/fit_statistics.h"
#include "analyses/results/fields.h"
#include "common/error.h"
#include "common/scalar.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

using parameters::Values;

namespace {

constexpr const char *estimate_section = "Estimate";

void check_settings(const Values &section, const Estimate::Settings &settings) {
  if (settings.starts > 1 && !all_bounded(settings.keys))
    section.reject("Starts", "must be 1 when a key has no Lower or no Upper");
  std::size_t data = 0;
  for (const DataSet &set : settings.data)
    data += set.size();
  if (data < settings.keys.size())
    section.reject_section("there must be at least as many data as keys, but there are " +
                           std::to_string(data) + " data and " +
                           std::to_string(settings.keys.size()) + " keys");
}

const FitEvaluation *best_fit(const std::deque<FitEvaluation> &evaluations) {
  const FitEvaluation *best = nullptr;
  for (const FitEvaluation &evaluation : evaluations)
    if (!evaluation.value.failed() &&
        (best == nullptr ||
         evaluation.value.residuals().squaredNorm() < best->value.residuals().squaredNorm()))
      best = &evaluation;
  return best;
}

std::size_t failures(const std::deque<FitEvaluation> &evaluations) {
  return static_cast<std::size_t>(
      std::count_if(evaluations.begin(), evaluations.end(),
                    [](const FitEvaluation &evaluation) { return evaluation.value.failed(); }));
}

/// Rate of a key's value over its coordinate.
double rate(const DesignKey &key, double value) {
  return key.length * (key.logarithmic ? value : 1);
}

FieldWriter search_numbers(PointResult &result) { return {result, "search/", Listed::yes}; }

void add_matrices(const FieldWriter &result, const FitStatistics &statistics) {
  result.array(Label("correlation", "1", "of the estimates of two keys, in their order",
                     {"fitted_key", "other_key"}),
               statistics.correlation);
  result.array(Label("direction", "1", "relative change of each key in each combination, one a row",
                     {"combination", "fitted_key"}),
               statistics.direction);
  result.array(Label("singular_value", "1",
                     "of the derivatives of the residuals by relative changes of all keys",
                     {"combination"}),
               statistics.singular_value);
  result.array(Label("direction_error", "1",
                     "standard error of each combination of relative changes; infinite where the "
                     "data say nothing",
                     {"combination"}),
               statistics.direction_error);
}

} // namespace

void Estimate::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      estimate_section, "Fits keys to measured data by bounded nonlinear least squares.");
  declare_design_keys(section);
  DataSet::declare(section);
  section
      .quantity("Tolerance", "1e-6", dimension::none, range::positive, "",
                "A fit ends when the keys change by less than this part of their length, which is "
                "Upper - Lower or else Start.")
      .quantity("Difference", "1e-4", dimension::none, Range{.lower = 1e-9, .upper = 0.1}, "",
                "Step of the keys for derivatives, as a part of the same length; well above the "
                "relative error of the quantities.")
      .integer("Most evaluations", "200", Range{.lower = 1, .upper = 1e6}, "",
               "Of each start, those for derivatives included; the last derivatives take two more "
               "for each key.")
      .integer("Starts", "1", Range{.lower = 1, .upper = 1e5}, "",
               "The first begins at Start, the others at random between the bounds.")
      .integer("Seed", "1", Range{.lower = 0, .upper = 1e9}, "",
               "Of what is drawn at random: equal seeds give equal results.");
}

std::shared_ptr<const Analysis> Estimate::create(const Values &analysis) {
  const Values section = analysis.subsection(estimate_section);
  std::vector<DataSet> data = read_data_sets(section);
  refuse_selections(analysis, data.front().analysis());
  std::vector<std::string> taken;
  Settings settings{.keys = read_design_keys(section, data.front().analysis(), taken),
                    .data = std::move(data),
                    .tolerance = section.quantity("Tolerance"),
                    .difference = section.quantity("Difference"),
                    .most = static_cast<std::size_t>(section.integer("Most evaluations")),
                    .starts = static_cast<std::size_t>(section.integer("Starts")),
                    .seed = section.integer("Seed")};
  check_settings(section, settings);
  return std::make_shared<Estimate>(std::move(settings));
}

std::vector<Axis> Estimate::axes() const {
  return search_axes(settings_.starts, all_evaluations());
}

std::vector<std::string> Estimate::changed_keys() const {
  std::vector<std::string> paths;
  for (const DesignKey &key : settings_.keys)
    paths.push_back(key.parameter.path);
  return paths;
}

void Estimate::check_outcomes(const Outcomes &outcomes) const {
  for (const DataSet &set : settings_.data)
    check_at_bounds(settings_.keys, set.analysis(),
                    [&](const std::vector<parameters::Override> &overrides) {
                      outcomes.check(set.analysis(), overrides);
                    });
}

void Estimate::try_outcomes(const Outcomes &outcomes) const {
  try_data(outcomes,
           overrides_at(settings_.keys, start_of_search(settings_.keys, settings_.seed, 0)),
           settings_.data);
}

Vector Estimate::residuals(const Vector &coordinates, FitEvaluations &evaluations) const {
  const FitValue &value = evaluations.at(coordinates).value;
  if (value.failed())
    throw NumericalError("the evaluation failed: " + value.failure);
  return value.residuals();
}

void Estimate::leave_if_spent(const FitEvaluations &evaluations) const {
  if (evaluations.all().size() >= settings_.most)
    throw EvaluationsSpent{};
}

// The residuals beside a place, and by how much the coordinate is another there; nothing beyond a
// bound or where the evaluation fails, which `failure` then says.
std::optional<std::pair<double, Vector>> Estimate::beside(const Vector &coordinates, Index k,
                                                          double step, FitEvaluations &evaluations,
                                                          std::string &failure) const {
  const DesignKey &key = settings_.keys[static_cast<std::size_t>(k)];
  Vector there = coordinates;
  there[k] += step;
  const double moved =
      key.coordinate(key.value(there[k])) - key.coordinate(key.value(coordinates[k]));
  if (!(std::abs(moved - step) < 0.5 * std::abs(step)))
    return std::nullopt;
  const FitValue &value = evaluations.at(there).value;
  if (value.failed()) {
    failure = value.failure;
    return std::nullopt;
  }
  return std::pair{moved, value.residuals()};
}

// Differences of first order while the fit is under way, of second order for what it says at the
// end: a combination that the data leave free shows by the errors of the differences alone.
Matrix Estimate::jacobian(const Vector &coordinates, bool second_order,
                          FitEvaluations &evaluations) const {
  const Vector here = residuals(coordinates, evaluations);
  Matrix jacobian(here.size(), coordinates.size());
  const double h = settings_.difference;
  for (Index k = 0; k < coordinates.size(); ++k) {
    std::string failure = "bounds on both sides";
    const auto at = [&](double step) {
      if (!second_order) // those for the last derivatives come on top
        leave_if_spent(evaluations);
      return beside(coordinates, k, step, evaluations, failure);
    };
    auto one = at(h);
    auto other = one && !second_order ? std::nullopt : at(-h);
    if (second_order && one.has_value() != other.has_value())
      (one ? other : one) = at(one ? 2 * h : -2 * h);
    if (!one)
      std::swap(one, other);
    if (!one)
      throw NumericalError("no derivative by the key " +
                           settings_.keys[static_cast<std::size_t>(k)].name + ": " + failure);
    const Vector slope = (one->second - here) / one->first;
    if (!second_order || !other)
      jacobian.col(k) = slope;
    else // of the parabola through all three
      jacobian.col(k) = slope + ((other->second - here) / other->first - slope) * one->first /
                                    (one->first - other->first);
  }
  return jacobian;
}

Estimate::Ended Estimate::fit_from(std::size_t line, FitEvaluations &evaluations) const {
  const auto n = static_cast<Index>(settings_.keys.size());
  LeastSquaresProblem problem{.lower = Vector(n),
                              .upper = Vector(n),
                              .start = start_of_search(settings_.keys, settings_.seed, line),
                              .residuals = {},
                              .jacobian = {},
                              .tolerance = settings_.tolerance,
                              .most_steps = static_cast<int>(settings_.most)};
  for (Index k = 0; k < n; ++k) {
    const DesignKey &key = settings_.keys[static_cast<std::size_t>(k)];
    problem.lower[k] = std::isfinite(key.lower) ? key.coordinate(key.lower) : -infinity;
    problem.upper[k] = std::isfinite(key.upper) ? key.coordinate(key.upper) : infinity;
  }
  problem.residuals = [&](const Vector &coordinates) {
    leave_if_spent(evaluations);
    return residuals(coordinates, evaluations);
  };
  int places = 0; // the start and those that steps have led to
  problem.jacobian = [&](const Vector &coordinates) {
    ++places;
    return jacobian(coordinates, false, evaluations);
  };
  const auto not_converged = [&](const std::string &why) {
    return (places > 1 ? "the search has not converged: " : "no search was made: ") + why;
  };
  try {
    const SearchEnd end = least_squares(problem);
    if (end == SearchEnd::evaluations)
      throw EvaluationsSpent{};
    return {end, end == SearchEnd::other
                     ? not_converged("from the best values on, evaluations fail at every step")
                     : ""};
  } catch (const EvaluationsSpent &) {
    return {SearchEnd::evaluations,
            not_converged("it ended at Most evaluations = " + std::to_string(settings_.most))};
  } catch (const NumericalError &error) {
    return {SearchEnd::other, not_converged(error.what())};
  }
}

void Estimate::add_statistics(PointResult &result, const FitEvaluation &best,
                              FitEvaluations &evaluations) const {
  const std::vector<double> values = values_at(settings_.keys, best.coordinates);
  const auto n = static_cast<Index>(values.size());
  Matrix by_keys = jacobian(best.coordinates, true, evaluations);
  Vector sizes(n);
  std::vector<bool> fixed;
  std::vector<std::string> names;
  for (Index k = 0; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const DesignKey &key = settings_.keys[i];
    by_keys.col(k) /= rate(key, values[i]);
    sizes[k] = values[i] != 0 ? std::abs(values[i]) : key.length;
    fixed.push_back(bound_at(key, values[i], settings_.tolerance) != 0);
    names.push_back(key.name);
  }
  const bool known = std::all_of(settings_.data.begin(), settings_.data.end(),
                                 [](const DataSet &set) { return set.has_deviation(); });
  const FitStatistics statistics =
      fit_statistics(best.value.residuals(), by_keys, sizes, fixed, known);
  for (Index k = 0; k < n; ++k) {
    const DesignKey &key = settings_.keys[static_cast<std::size_t>(k)];
    const double value = values[static_cast<std::size_t>(k)];
    const FieldWriter write(result);
    write.listed().number(
        "standard_error/" + key.name, statistics.standard_error[k], key.parameter.unit,
        "of the key; infinite where the data leave it free, NaN where a bound fixes it");
    write.number("interval_lower/" + key.name, value - statistics.half_width[k], key.parameter.unit,
                 "lower end of the interval of 95 %");
    write.number("interval_upper/" + key.name, value + statistics.half_width[k], key.parameter.unit,
                 "upper end of the interval of 95 %");
  }
  search_numbers(result).number("residual_variance", statistics.residual_variance, "1",
                                "sum of squares over the degrees of freedom");
  add_matrices(result, statistics);
  result.reason = combinations_in_words(statistics, names);
}

PointResult Estimate::result(std::size_t line, FitEvaluations &evaluations,
                             const Ended &ended) const {
  const std::vector<std::size_t> index{line, 0};
  const FitEvaluation *best = best_fit(evaluations.all());
  if (best == nullptr)
    return {.index = index,
            .status = Status::failed,
            .reason =
                "all " + std::to_string(evaluations.all().size()) +
                " evaluations failed, the first one: " + evaluations.all().front().value.failure};
  PointResult result = fit_point(index, *best, settings_.keys, settings_.data);
  FieldWriter(result).line("sum_of_squares", best->value.residuals().squaredNorm(), "1");
  const std::vector<double> values = values_at(settings_.keys, best->coordinates);
  for (std::size_t k = 0; k < values.size(); ++k)
    FieldWriter(result).line("key/" + settings_.keys[k].name, values[k],
                             settings_.keys[k].parameter.unit);
  try {
    add_statistics(result, *best, evaluations);
  } catch (const NumericalError &error) {
    result.reason = std::string("no standard errors: ") + error.what();
  } catch (const EvaluationsSpent &) {
    result.reason = "no standard errors: too many of the evaluations for them failed";
  }
  if (!ended.not_converged.empty()) {
    result.status = Status::failed;
    result.reason = ended.not_converged;
  }
  const FieldWriter search = search_numbers(result);
  search.number("best", static_cast<double>(best->number), "1", "number of the best evaluation");
  search.number("evaluations", static_cast<double>(evaluations.all().size()), "1",
                "evaluations of the fit, those for derivatives included");
  search.number("failed", static_cast<double>(failures(evaluations.all())), "1",
                "of these, those that failed");
  search.number(
      "end", static_cast<double>(ended.end), "1",
      "why the fit ended: 1 the keys change by less than Tolerance, 2 the sum of squares by "
      "less than "
      "1e-9 of it, "
      "3 Most evaluations, 4 rounding, 0 an evaluation that failed");
  for (std::size_t k = 0; k < values.size(); ++k)
    search.number("bound/" + settings_.keys[k].name,
                  bound_at(settings_.keys[k], values[k], settings_.tolerance), "1",
                  "-1 where the best value is at the lower bound, 1 at the upper one, else 0");
  return result;
}

void Estimate::run_line(std::size_t line, System & /*system*/, LineContext &context) const {
  const bool done = context.find({line, 0}) != nullptr;
  FitEvaluations evaluations(settings_.keys, settings_.data, line, all_evaluations(), context);
  if (!done) {
    const Ended ended = fit_from(line, evaluations);
    context.store(result(line, evaluations, ended));
  }
  skip_the_rest(all_evaluations(), evaluations.all().size() + (done ? 0 : 1), context);
}

} // namespace vibroimpact::analyses
