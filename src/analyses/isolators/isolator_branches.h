// The response curve of an isolator with another stop, exact: a branch of periodic motions that
// another analysis follows.
#pragma once

#include "analyses/isolators/isolator_system.h"
#include "analyses/keys/swept_parameter.h"
#include "analyses/run/outcomes.h"

#include <functional>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

struct ExactResponse {
  std::string failure;            ///< why there is none; else empty
  std::vector<double> folds;      ///< lambda, increasing
  std::vector<double> ratios;     ///< lambda along the branch
  std::vector<double> amplitudes; ///< max |y| there, over the clearance
  std::vector<double> stable;     ///< 1 or 0
  double peak = 0;                ///< largest amplitude of these
};

class IsolatorBranches {
public:
  static void declare(parameters::Section &section);
  /// None where the key Repeat is empty. InputError.
  explicit IsolatorBranches(const parameters::Values &section);

  /// Name of the analysis; empty where there are no exact branches.
  const std::string &evaluated() const { return evaluated_; }
  std::vector<std::string> keys() const;
  /// InputError unless the keys change stiffness and clearance of the stops, and nothing else.
  void check(const SystemSource &build, const std::string &excitation) const;

  /// `progress` may throw. InputError when the analysis has not the fields that are needed.
  ExactResponse follow(const StopChoice &stop, const IsolatorSystem &isolator,
                       const Outcomes &outcomes,
                       const std::function<void(double share)> &progress) const;

private:
  std::vector<parameters::Override> overrides(const StopChoice &stop,
                                              const IsolatorSystem &isolator) const;

  std::string evaluated_;
  SweptParameter stiffness_, clearance_; ///< without values
};

} // namespace vibroimpact::analyses
