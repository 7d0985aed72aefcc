#include "analyses/design/optimise.h"

#include "analyses/design/best_evaluation.h"
#include "common/error.h"
#include "common/scalar.h"

#include <cmath>
#include <limits>

namespace vibroimpact::analyses {

using parameters::Values;

namespace {

constexpr const char *optimise_section = "Optimise";
constexpr const char *evolution = "differential evolution";

/// Calls of the objective that a method may make for each evaluation: most repeat a known one.
constexpr int calls_for_an_evaluation = 20;

/// Differential evolution counts as a method with every ability.
SearchMethod abilities(const std::string &name) {
  const SearchMethod *method = search_method(name);
  return method != nullptr ? *method : SearchMethod{name, -1, true, true, true};
}

void check_method(const Values &section, const Optimise::Settings &settings) {
  const SearchMethod method = abilities(settings.method);
  if (!method.takes_constraints && !settings.objective.constraints().empty())
    section.reject(
        "Method",
        "must be differential evolution, COBYLA or ISRES when there are sections Constraint");
  if (!method.needs_bounds && section.given("Population"))
    section.reject("Population", "must not be set when Method = " + section.choice("Method") +
                                     ", which has no population");
  if (all_bounded(settings.keys))
    return;
  if (method.needs_bounds)
    section.reject("Method", "must be another method when a key has no Lower or no Upper");
  if (settings.starts > 1)
    section.reject("Starts", "must be 1 when a key has no Lower or no Upper");
}

/// What a failed evaluation counts as: worse than all before it. Models of the objective, as BOBYQA
/// and COBYLA make them, need a finite value of the size of the others.
double penalty(const std::deque<Evaluation> &evaluations, const Objective &objective) {
  double best = std::numeric_limits<double>::infinity(), worst = -best;
  for (const Evaluation &evaluation : evaluations)
    if (!evaluation.value.failed()) {
      const double value = objective.to_minimise(evaluation.value.objective);
      best = std::min(best, value);
      worst = std::max(worst, value);
    }
  if (!std::isfinite(worst))
    return 1e30;
  return worst + (worst > best ? worst - best : std::max(std::abs(worst), 1e-300));
}

} // namespace

void Optimise::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      optimise_section,
      "Makes a quantity of another analysis smallest or largest by changing keys.");
  section.text("Repeat", "", "Name of the analysis that is evaluated.").required();
  Objective::declare_goal(section);
  Objective::declare_limits(section);
  declare_design_keys(section);
  std::vector<std::string> methods{evolution};
  for (const SearchMethod &method : search_methods())
    methods.push_back(method.name);
  section
      .choice("Method", "Nelder-Mead", methods,
              "Local: Nelder-Mead and subplex (by comparisons alone), BOBYQA (a quadratic model), "
              "COBYLA (linear models, with constraints). Global: DIRECT (divides the box between "
              "the bounds), ISRES (evolution, with constraints), differential evolution (a "
              "population, with constraints, whose evaluations the ranks share).")
      .quantity("Tolerance", "1e-4", dimension::none, range::positive, "",
                "A search ends when the keys change by less than this part of their length, which "
                "is Upper - Lower or else Start.")
      .quantity("Objective tolerance", "0", dimension::none, range::non_negative, "",
                "Or when the objective changes by less than this part of it; 0 for no such end.")
      .quantity("Constraint tolerance", "1e-6", dimension::none, range::non_negative, "",
                "A constraint counts as met when it misses its limit by no more than this part "
                "of it.")
      .integer("Most evaluations", "200", Range{.lower = 1, .upper = 1e6}, "", "Of each start.")
      .integer("Starts", "1", Range{.lower = 1, .upper = 1e5}, "",
               "The first begins at Start, the others at random between the bounds.")
      .integer("Seed", "1", Range{.lower = 0, .upper = 1e9}, "",
               "Of what is drawn at random: equal seeds give equal results.")
      .integer("Population", "0", Range{.lower = 0, .upper = 1e6}, "",
               "0 means 10 for each key for differential evolution, 20 for each key and 20 more "
               "for ISRES.");
}

std::shared_ptr<const Analysis> Optimise::create(const Values &analysis) {
  const Values section = analysis.subsection(optimise_section);
  const std::string evaluated = read_evaluated(section);
  refuse_selections(analysis, evaluated);
  std::vector<std::string> taken;
  std::vector<DesignKey> keys = read_design_keys(section, evaluated, taken);
  Settings settings{.evaluated = evaluated,
                    .keys = std::move(keys),
                    .objective = Objective({Objective::read_goal(section, "Objective")}, section,
                                           evaluated, taken),
                    .method = section.choice("Method"),
                    .tolerance = section.quantity("Tolerance"),
                    .objective_tolerance = section.quantity("Objective tolerance"),
                    .constraint_tolerance = section.quantity("Constraint tolerance"),
                    .most = static_cast<std::size_t>(section.integer("Most evaluations")),
                    .starts = static_cast<std::size_t>(section.integer("Starts")),
                    .population = static_cast<unsigned>(section.integer("Population")),
                    .seed = section.integer("Seed")};
  check_method(section, settings);
  return std::make_shared<Optimise>(std::move(settings));
}

std::vector<Axis> Optimise::axes() const { return search_axes(settings_.starts, settings_.most); }

bool Optimise::evolves() const { return settings_.method == evolution; }

std::size_t Optimise::lines() const {
  return evolves() ? settings_.starts * (settings_.most + 1) : settings_.starts;
}

std::size_t Optimise::message_size() const {
  return evolves() ? settings_.objective.message_size() : 0;
}

std::vector<std::string> Optimise::changed_keys() const {
  return paths_of(settings_.keys, settings_.objective.worst_keys());
}

void Optimise::check_outcomes(const Outcomes &outcomes) const {
  check_at_bounds(settings_.keys, settings_.evaluated,
                  [&](const std::vector<parameters::Override> &overrides) {
                    settings_.objective.check(outcomes, overrides);
                  });
}

void Optimise::try_outcomes(const Outcomes &outcomes) const {
  settings_.objective.try_out(
      outcomes, overrides_at(settings_.keys, start_of_search(settings_.keys, settings_.seed, 0)));
}

SearchProblem Optimise::problem(std::size_t start, Evaluations &evaluations) const {
  const auto n = static_cast<Index>(settings_.keys.size());
  SearchProblem problem{.lower = Vector(n),
                        .upper = Vector(n),
                        .start = start_of_search(settings_.keys, settings_.seed, start),
                        .step = Vector(n),
                        .objective = {},
                        .constraints = {},
                        .constraint_tolerance = settings_.constraint_tolerance,
                        .tolerance = settings_.tolerance,
                        .objective_tolerance = settings_.objective_tolerance,
                        .most_calls = static_cast<int>(settings_.most) * calls_for_an_evaluation,
                        .population = settings_.population,
                        .seed = static_cast<unsigned long>(settings_.seed) + start};
  for (std::size_t k = 0; k < settings_.keys.size(); ++k) {
    const DesignKey &key = settings_.keys[k];
    const auto i = static_cast<Index>(k);
    problem.lower[i] = std::isfinite(key.lower) ? key.coordinate(key.lower) : -infinity;
    problem.upper[i] = std::isfinite(key.upper) ? key.coordinate(key.upper) : infinity;
    problem.step[i] = key.step;
  }
  const bool compares = abilities(settings_.method).only_compares;
  problem.objective = [this, compares, &evaluations](const Vector &coordinates) {
    const DesignValue &value = evaluations.at(coordinates).value;
    if (!value.failed())
      return settings_.objective.to_minimise(value.objective);
    return compares ? HUGE_VAL : penalty(evaluations.all(), settings_.objective);
  };
  for (std::size_t c = 0; c < settings_.objective.constraints().size(); ++c)
    problem.constraints.emplace_back([c, &evaluations](const Vector &coordinates) {
      const DesignValue &value = evaluations.at(coordinates).value;
      return value.failed() ? 1 : value.excess[c];
    });
  return problem;
}

SearchEnd Optimise::search_from(std::size_t start, Evaluations &evaluations) const {
  try {
    return search(abilities(settings_.method), problem(start, evaluations));
  } catch (const EvaluationsSpent &) {
    return SearchEnd::evaluations;
  }
}

void Optimise::run_start(std::size_t start, LineContext &context) const {
  const bool done = context.find({start, 0}) != nullptr;
  Evaluations evaluations(settings_.keys, settings_.objective, start, settings_.most, context);
  if (!done) {
    const SearchEnd end = search_from(start, evaluations);
    context.store(result_of_search(start, evaluations.all(), settings_.keys, settings_.objective,
                                   settings_.tolerance, settings_.constraint_tolerance, end));
  }
  skip_the_rest(settings_.most, evaluations.all().size() + (done ? 0 : 1), context);
}

PopulationSearch &Optimise::population_of(std::size_t start) const {
  if (population_ && start_ == start)
    return *population_;
  const std::size_t size =
      settings_.population > 0 ? settings_.population : usual_population(settings_.keys.size());
  start_ = start;
  population_ = std::make_unique<PopulationSearch>(
      settings_.keys, settings_.objective,
      Population::Settings{.size = size,
                           .start = start_of_search(settings_.keys, settings_.seed, start),
                           .seed = static_cast<std::uint64_t>(settings_.seed),
                           .number = start,
                           .tolerance = settings_.tolerance,
                           .goal_tolerance = settings_.objective_tolerance},
      settings_.constraint_tolerance, settings_.most,
      PopulationSearch::Place{.index = {start}, .first_line = start * (settings_.most + 1)});
  return *population_;
}

void Optimise::store_result(std::size_t start, LineContext &context) const {
  if (context.find({start, 0}) != nullptr)
    return context.skip();
  PopulationSearch &population = population_of(start);
  const std::deque<Evaluation> &evaluations = population.evaluations(context);
  context.store(
      result_of_search(start, evaluations, settings_.keys, settings_.objective, settings_.tolerance,
                       settings_.constraint_tolerance,
                       population.converged() ? SearchEnd::tolerance : SearchEnd::evaluations));
}

void Optimise::run_evaluation(std::size_t line, LineContext &context) const {
  const std::size_t start = line / (settings_.most + 1);
  const std::size_t trial = line % (settings_.most + 1);
  if (trial == settings_.most)
    store_result(start, context);
  else
    population_of(start).run_trial(trial, context);
}

void Optimise::run_line(std::size_t line, System & /*system*/, LineContext &context) const {
  evolves() ? run_evaluation(line, context) : run_start(line, context);
}

} // namespace vibroimpact::analyses
