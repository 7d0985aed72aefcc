// A search whose evaluations are lines of their own, which the ranks share: the trials of a
// population.
//
// Every rank takes in the outcomes of all trials in their order, by the notes of their lines, so
// that it knows what any trial is. Trial k waits for those up to k - N only (population.h), so that
// a rank waits only where another one's evaluation takes as long as N of its own.
#pragma once

#include "analyses/design/evaluations.h"
#include "analyses/design/population.h"

#include <deque>
#include <map>
#include <optional>

namespace vibroimpact::analyses {

class PopulationSearch {
public:
  struct Place {
    std::vector<std::size_t> index; ///< of the points, before the number of the evaluation
    std::size_t first_line = 0;     ///< of trial 0; those of the others follow
  };
  /// Keeps references. `trials` at most; `constraint_tolerance`: relative.
  PopulationSearch(const std::vector<DesignKey> &keys, const Objective &objective,
                   Population::Settings settings, double constraint_tolerance, std::size_t trials,
                   Place place);

  /// The line of a trial. The trial is left out when the search has converged before, or when its
  /// values of the keys are those of an earlier one. Throws what LineContext does.
  void run_trial(std::size_t trial, LineContext &context);
  /// All evaluations in their order, for which it waits.
  const std::deque<Evaluation> &evaluations(const LineContext &context);
  bool converged() const { return converged_; }

private:
  struct Trial {
    Vector coordinates;                    ///< empty: left out
    std::optional<std::size_t> earlier;    ///< trial at the same values
    std::optional<std::size_t> evaluation; ///< position in evaluations_
  };
  void advance(std::size_t trials, const LineContext &context);
  void take_in(std::size_t trial, const LineContext &context);
  Trial next_trial();
  TrialValue trial_value(const DesignValue &value) const;
  DesignValue evaluate(const Vector &coordinates, LineContext &context) const;

  const std::vector<DesignKey> &keys_;
  const Objective &objective_;
  Population population_;
  double constraint_tolerance_;
  std::size_t most_;
  Place place_;
  std::vector<Trial> trials_;
  std::size_t taken_in_ = 0;
  bool converged_ = false;
  std::map<std::vector<double>, std::size_t> known_; ///< trials by the values of the keys
  std::deque<Evaluation> evaluations_;
};

/// The size that stands for a population of 0.
std::size_t usual_population(std::size_t keys);

} // namespace vibroimpact::analyses
