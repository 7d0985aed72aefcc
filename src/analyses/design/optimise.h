// Optimise: the values of some keys at which a quantity of another analysis is smallest or largest.
//
// Every start is a line of its own, every evaluation a point of it. The methods are deterministic,
// or draw from a stated seed; when a run is resumed, they run again through the stored evaluations
// and go on where these end. Evaluation 0 is what the search has found: the best one again. With a
// population every evaluation is a line, so that the ranks share those of one start.
#pragma once

#include "analyses/analysis.h"
#include "analyses/design/design_keys.h"
#include "analyses/design/evaluations.h"
#include "analyses/design/nlopt_search.h"
#include "analyses/design/objective.h"
#include "analyses/design/population_search.h"

#include <memory>

namespace vibroimpact::analyses {

class Optimise : public Analysis {
public:
  struct Settings {
    std::string evaluated; ///< name of the analysis
    std::vector<DesignKey> keys;
    Objective objective;
    std::string method;
    double tolerance = 0;           ///< of the keys' coordinates
    double objective_tolerance = 0; ///< relative
    double constraint_tolerance = 0;
    std::size_t most = 0; ///< evaluations of a start
    std::size_t starts = 1;
    unsigned population = 0;
    long seed = 0;
  };
  explicit Optimise(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "optimise"; }
  BestOf best_of() const override {
    return {"objective", settings_.objective.goals().front().maximise};
  }
  /// start, evaluation
  std::vector<Axis> axes() const override;
  std::size_t lines() const override;
  std::size_t message_size() const override;
  void check(const System & /*system*/) const override {}
  std::string evaluated() const override { return settings_.evaluated; }
  std::vector<std::string> changed_keys() const override;
  void check_outcomes(const Outcomes &outcomes) const override;
  void try_outcomes(const Outcomes &outcomes) const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  bool evolves() const; ///< a population
  SearchProblem problem(std::size_t start, Evaluations &evaluations) const;
  SearchEnd search_from(std::size_t start, Evaluations &evaluations) const;
  void run_start(std::size_t start, LineContext &context) const;
  void run_evaluation(std::size_t line, LineContext &context) const;
  PopulationSearch &population_of(std::size_t start) const;
  void store_result(std::size_t start, LineContext &context) const;

  Settings settings_;
  /// Of the start at hand: its lines share the outcomes that have been taken in.
  mutable std::unique_ptr<PopulationSearch> population_;
  mutable std::size_t start_ = 0;
};

} // namespace vibroimpact::analyses
