// Estimate: the values of some keys at which the model meets measured data best.
//
// Bounded nonlinear least squares from several starts, each a line of its own; every evaluation is
// a point of it. Derivatives are differences, whose evaluations are points too. Evaluation
// 0 is what the fit has found, with standard errors and what the data say of each combination of
// keys.
#pragma once

#include "analyses/analysis.h"
#include "analyses/design/fit_evaluations.h"
#include "analyses/design/least_squares.h"
#include "analyses/results/field_writer.h"

#include <optional>
#include <utility>

namespace vibroimpact::analyses {

class Estimate : public Analysis {
public:
  struct Settings {
    std::vector<DesignKey> keys;
    std::vector<DataSet> data;
    double tolerance = 0;  ///< of the keys' coordinates
    double difference = 0; ///< step of derivatives, in the coordinates
    std::size_t most = 0;  ///< evaluations of a start, without those of the last derivatives
    std::size_t starts = 1;
    long seed = 0;
  };
  explicit Estimate(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "estimate"; }
  BestOf best_of() const override { return {"sum_of_squares"}; }
  /// start, evaluation
  std::vector<Axis> axes() const override;
  std::size_t lines() const override { return settings_.starts; }
  void check(const System & /*system*/) const override {}
  std::string evaluated() const override { return settings_.data.front().analysis(); }
  std::vector<std::string> changed_keys() const override;
  void check_outcomes(const Outcomes &outcomes) const override;
  void try_outcomes(const Outcomes &outcomes) const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  std::size_t all_evaluations() const { return settings_.most + 2 * settings_.keys.size(); }
  Vector residuals(const Vector &coordinates, FitEvaluations &evaluations) const;
  void leave_if_spent(const FitEvaluations &evaluations) const;
  std::optional<std::pair<double, Vector>> beside(const Vector &coordinates, Index k, double step,
                                                  FitEvaluations &evaluations,
                                                  std::string &failure) const;
  Matrix jacobian(const Vector &coordinates, bool second_order, FitEvaluations &evaluations) const;
  struct Ended {
    SearchEnd end;
    std::string not_converged{}; ///< why the result is not what the data say; empty if it is
  };
  Ended fit_from(std::size_t line, FitEvaluations &evaluations) const;
  PointResult result(std::size_t line, FitEvaluations &evaluations, const Ended &ended) const;
  void add_statistics(PointResult &result, const FitEvaluation &best,
                      FitEvaluations &evaluations) const;

  Settings settings_;
};

} // namespace vibroimpact::analyses
