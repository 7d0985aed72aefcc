// Sensitivity: which of several keys, drawn at random between bounds, decide about quantities of
// another analysis, by Sobol's indices (sobol_indices.h). Evaluation 0 is the result; all others
// are lines of their own.
#pragma once

#include "analyses/analysis.h"
#include "analyses/design/design_keys.h"
#include "analyses/design/single_outcomes.h"
#include "analyses/design/sobol_indices.h"
#include "analyses/results/field_writer.h"

namespace vibroimpact::analyses {

class Sensitivity : public Analysis {
public:
  struct Quantity {
    std::string name; ///< of its section
    WantedQuantity wanted;
  };
  struct Settings {
    std::string evaluated; ///< name of the analysis
    std::vector<DesignKey> keys;
    std::vector<Quantity> quantities;
    std::size_t samples = 0;
    long seed = 0;
  };
  explicit Sensitivity(Settings settings);

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "sensitivity"; }
  /// evaluation
  std::vector<Axis> axes() const override;
  std::size_t lines() const override { return design_.points() + 1; }
  std::size_t message_size() const override;
  void check(const System & /*system*/) const override {}
  std::string evaluated() const override { return settings_.evaluated; }
  std::vector<std::string> changed_keys() const override { return paths_of(settings_.keys, {}); }
  void check_outcomes(const Outcomes &outcomes) const override;
  void try_outcomes(const Outcomes &outcomes) const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  PointResult evaluate(std::size_t number, LineContext &context) const;
  void add_values(PointResult &point, LineContext &context) const;
  std::string note(const PointResult &point) const;
  PointResult result(const LineContext &context) const;

  Settings settings_;
  SobolDesign design_;
};

} // namespace vibroimpact::analyses
