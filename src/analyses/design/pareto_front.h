// Pareto front: the values of keys at which no objective of several can be made better without
// another one becoming worse, by a population whose evaluations the ranks share.
//
// Evaluation 0 is the front: the evaluations that meet the constraints and that no other one
// dominates, in the order of the first objective.
#pragma once

#include "analyses/analysis.h"
#include "analyses/design/population_search.h"
#include "analyses/results/field_writer.h"

#include <memory>

namespace vibroimpact::analyses {

class ParetoFront : public Analysis {
public:
  struct Settings {
    std::string evaluated; ///< name of the analysis
    std::vector<DesignKey> keys;
    Objective objective;
    double constraint_tolerance = 0;
    std::size_t evaluations = 0;
    std::size_t population = 0;
    long seed = 0;
  };
  explicit ParetoFront(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "pareto front"; }
  /// evaluation
  std::vector<Axis> axes() const override { return {evaluation_axis(settings_.evaluations)}; }
  std::size_t lines() const override { return settings_.evaluations + 1; }
  std::size_t message_size() const override { return settings_.objective.message_size(); }
  void check(const System & /*system*/) const override {}
  std::string evaluated() const override { return settings_.evaluated; }
  std::vector<std::string> changed_keys() const override;
  void check_outcomes(const Outcomes &outcomes) const override;
  void try_outcomes(const Outcomes &outcomes) const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  PopulationSearch &population() const;
  PointResult front(const std::deque<Evaluation> &evaluations) const;
  void add_front(const FieldWriter &result, const std::vector<const Evaluation *> &front) const;

  Settings settings_;
  mutable std::unique_ptr<PopulationSearch> population_; ///< lines share what they have taken in
};

} // namespace vibroimpact::analyses
