#include "analyses/design/pareto_front.h"

#include "analyses/design/best_evaluation.h"
#include "analyses/results/fields.h"

#include <algorithm>

namespace vibroimpact::analyses {

using parameters::Values;

namespace {

constexpr const char *pareto_front_section = "Pareto front";
/// A front needs more members than a single optimum.
constexpr std::size_t usual_members = 40;

std::vector<Goal> read_goals(const Values &section) {
  std::vector<Goal> goals;
  for (const std::string &name : section.instances("Objective")) {
    goals.push_back(Objective::read_goal(section.instance("Objective", name), "Quantity"));
    goals.back().name = name;
  }
  if (goals.size() < 2)
    section.reject_section("at least two subsections Objective NAME must be given");
  return goals;
}

} // namespace

void ParetoFront::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      pareto_front_section,
      "The best compromises between several quantities of another analysis: where "
      "none of them can become better without another one becoming worse.");
  section.text("Repeat", "", "Name of the analysis that is evaluated.").required();
  section.named_subsection("Objective", "A quantity that is to be small or large.")
      .text("Quantity", "",
            "The path of a field of the repeated analysis or the name of a Derived of it; one "
            "number.")
      .required()
      .choice("Sense", "minimise", {"minimise", "maximise"}, "Which of the two.");
  Objective::declare_limits(section);
  declare_design_keys(section);
  section
      .quantity("Constraint tolerance", "1e-6", dimension::none, range::non_negative, "",
                "A constraint counts as met when it misses its limit by no more than this part "
                "of it.")
      .integer("Evaluations", "1000", Range{.lower = 1, .upper = 1e6}, "", "Of the whole search.")
      .integer("Population", "0", Range{.lower = 0, .upper = 1e4}, "",
               "Points of the front that are sought; 0 means 40.")
      .integer("Seed", "1", Range{.lower = 0, .upper = 1e9}, "",
               "Of what is drawn at random: equal seeds give equal results.");
}

std::shared_ptr<const Analysis> ParetoFront::create(const Values &analysis) {
  const Values section = analysis.subsection(pareto_front_section);
  const std::string evaluated = read_evaluated(section);
  refuse_selections(analysis, evaluated);
  std::vector<std::string> taken;
  std::vector<DesignKey> keys = read_design_keys(section, evaluated, taken);
  require_bounds(section, keys);
  const auto population = static_cast<std::size_t>(section.integer("Population"));
  return std::make_shared<ParetoFront>(
      Settings{.evaluated = evaluated,
               .keys = std::move(keys),
               .objective = Objective(read_goals(section), section, evaluated, taken),
               .constraint_tolerance = section.quantity("Constraint tolerance"),
               .evaluations = static_cast<std::size_t>(section.integer("Evaluations")),
               .population = population > 0 ? population : usual_members,
               .seed = section.integer("Seed")});
}

std::vector<std::string> ParetoFront::changed_keys() const {
  return paths_of(settings_.keys, settings_.objective.worst_keys());
}

void ParetoFront::check_outcomes(const Outcomes &outcomes) const {
  check_at_bounds(settings_.keys, settings_.evaluated,
                  [&](const std::vector<parameters::Override> &overrides) {
                    settings_.objective.check(outcomes, overrides);
                  });
}

void ParetoFront::try_outcomes(const Outcomes &outcomes) const {
  settings_.objective.try_out(
      outcomes, overrides_at(settings_.keys, start_of_search(settings_.keys, settings_.seed, 0)));
}

PopulationSearch &ParetoFront::population() const {
  if (!population_)
    population_ = std::make_unique<PopulationSearch>(
        settings_.keys, settings_.objective,
        Population::Settings{.size = settings_.population,
                             .start = start_of_search(settings_.keys, settings_.seed, 0),
                             .seed = static_cast<std::uint64_t>(settings_.seed)},
        settings_.constraint_tolerance, settings_.evaluations, PopulationSearch::Place{});
  return *population_;
}

void ParetoFront::add_front(const FieldWriter &result,
                            const std::vector<const Evaluation *> &front) const {
  const auto add = [&](const std::string &name, const std::string &unit,
                       const std::string &description, const auto &value) {
    std::vector<double> values;
    for (const Evaluation *evaluation : front)
      values.push_back(value(*evaluation));
    result.series("front/" + name, "member", std::move(values), unit, description);
  };
  add("evaluation", "1", "number of the evaluation",
      [](const Evaluation &evaluation) { return static_cast<double>(evaluation.number); });
  const DesignValue &first = front.front()->value;
  for (std::size_t g = 0; g < settings_.objective.goals().size(); ++g)
    add(goal_field(settings_.objective, g), g == 0 ? first.unit : first.other_units[g - 1],
        settings_.objective.goals()[g].quantity.path + " on the front",
        [g](const Evaluation &evaluation) {
          return g == 0 ? evaluation.value.objective : evaluation.value.others[g - 1];
        });
  for (std::size_t k = 0; k < settings_.keys.size(); ++k) {
    const DesignKey &key = settings_.keys[k];
    add("key/" + key.name, key.parameter.unit, "value of the key " + key.parameter.path,
        [&key, k](const Evaluation &evaluation) {
          return key.value(evaluation.coordinates[static_cast<Index>(k)]);
        });
  }
}

PointResult ParetoFront::front(const std::deque<Evaluation> &evaluations) const {
  PointResult result{.index = {0}};
  std::vector<const Evaluation *> good;
  std::vector<TrialValue> values;
  for (const Evaluation &evaluation : evaluations)
    if (!evaluation.value.failed() &&
        evaluation.value.largest_excess() <= settings_.constraint_tolerance) {
      good.push_back(&evaluation);
      values.push_back({.goals = settings_.objective.all_to_minimise(evaluation.value)});
    }
  if (good.empty()) {
    result.status = Status::failed;
    result.reason = why_nothing_is_good(evaluations, settings_.objective);
    return result;
  }
  std::vector<const Evaluation *> front;
  for (const std::size_t place : not_dominated(values))
    front.push_back(good[place]);
  std::stable_sort(front.begin(), front.end(), [&](const Evaluation *a, const Evaluation *b) {
    return settings_.objective.to_minimise(a->value.objective) <
           settings_.objective.to_minimise(b->value.objective);
  });
  add_front(result, front);
  add_counts(result, evaluations);
  FieldWriter(result, "search/", Listed::yes)
      .number("front", static_cast<double>(front.size()), "1", "evaluations on the front");
  return result;
}

void ParetoFront::run_line(std::size_t line, System & /*system*/, LineContext &context) const {
  if (line < settings_.evaluations)
    population().run_trial(line, context);
  else if (context.find({0}) != nullptr)
    context.skip();
  else
    context.store(front(population().evaluations(context)));
}

} // namespace vibroimpact::analyses
