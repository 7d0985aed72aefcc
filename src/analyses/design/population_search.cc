#include "analyses/design/population_search.h"

#include "common/error.h"

namespace vibroimpact::analyses {

std::size_t usual_population(std::size_t keys) { return 10 * keys; }

PopulationSearch::PopulationSearch(const std::vector<DesignKey> &keys, const Objective &objective,
                                   Population::Settings settings, double constraint_tolerance,
                                   std::size_t trials, Place place)
    : keys_(keys), objective_(objective), population_(std::move(settings)),
      constraint_tolerance_(constraint_tolerance), most_(trials), place_(std::move(place)) {}

void PopulationSearch::run_trial(std::size_t trial, LineContext &context) {
  advance(trial + 1, context);
  const Trial &present = trials_[trial];
  if (present.coordinates.size() == 0 || present.earlier)
    return context.skip();
  Evaluation evaluation{.number = trial + 1, .coordinates = present.coordinates, .value = {}};
  std::vector<std::size_t> index = place_.index;
  index.push_back(evaluation.number);
  if (const PointResult *known = context.find(index)) {
    evaluation.value = stored_design_value(*known, objective_);
    context.skip();
  } else {
    evaluation.value = evaluate(present.coordinates, context);
    context.store(evaluation_point(index, evaluation, keys_, objective_));
  }
  context.leave_message(place_.first_line + trial, objective_.note(evaluation.value));
}

// Other lines wait for this one: whatever cannot be used at these values is a failure of it alone.
DesignValue PopulationSearch::evaluate(const Vector &coordinates, LineContext &context) const {
  try {
    return objective_.evaluate(context.outcomes(), overrides_at(keys_, coordinates),
                               [&context](double share) { context.note_progress(share); });
  } catch (const InputError &error) {
    return {.failure = error.what()};
  }
}

void PopulationSearch::advance(std::size_t trials, const LineContext &context) {
  while (trials_.size() < trials) {
    if (trials_.size() >= population_.size())
      take_in(trials_.size() - population_.size(), context);
    trials_.push_back(next_trial());
  }
}

PopulationSearch::Trial PopulationSearch::next_trial() {
  const std::size_t number = trials_.size();
  converged_ = converged_ || population_.converged();
  if (converged_)
    return {};
  Trial trial{.coordinates = population_.propose(number), .earlier = {}, .evaluation = {}};
  const auto [place, is_new] = known_.try_emplace(values_at(keys_, trial.coordinates), number);
  if (!is_new)
    trial.earlier = place->second;
  return trial;
}

void PopulationSearch::take_in(std::size_t number, const LineContext &context) {
  Trial &trial = trials_[number];
  ++taken_in_;
  if (trial.coordinates.size() == 0)
    return;
  if (!trial.earlier) {
    trial.evaluation = evaluations_.size();
    Evaluation &evaluation = evaluations_.emplace_back();
    evaluation.number = number + 1;
    evaluation.coordinates = trial.coordinates;
    evaluation.value.failure = "an evaluation that was left out";
    if (const std::string note = context.message_of(place_.first_line + number); !note.empty())
      unpack(note, evaluation.value);
  } else {
    trial.evaluation = trials_[*trial.earlier].evaluation;
  }
  population_.take_in(number, trial.coordinates,
                      trial_value(evaluations_[*trial.evaluation].value));
}

TrialValue PopulationSearch::trial_value(const DesignValue &value) const {
  TrialValue trial{.failed = value.failed(), .excess = 0, .goals = {}};
  if (value.failed()) {
    trial.goals.resize(objective_.goals().size());
    return trial;
  }
  trial.goals = objective_.all_to_minimise(value);
  const double excess = value.largest_excess();
  trial.excess = excess > constraint_tolerance_ ? excess : 0;
  return trial;
}

const std::deque<Evaluation> &PopulationSearch::evaluations(const LineContext &context) {
  advance(most_, context);
  while (taken_in_ < most_)
    take_in(taken_in_, context);
  return evaluations_;
}

} // namespace vibroimpact::analyses
