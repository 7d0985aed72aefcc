// Isolator design: which stops keep the resonance of an isolator below an allowed displacement
// without a jump, and without being reached at the working frequency.
//
// The conditions are closed forms of averaging (isolator_constraints.h). The stop that is
// preferred, the corners of the set of possible stops, an example of each region of the plane, and
// stops that the file lists are then judged: folds by the expansion, by the averaged equation, and,
// where another analysis follows branches of this isolator, exactly.
#pragma once

#include "analyses/analysis.h"
#include "analyses/isolators/isolator_branches.h"
#include "analyses/isolators/isolator_constraints.h"

#include <optional>

namespace vibroimpact::analyses {

class IsolatorDesign : public Analysis {
public:
  struct Settings {
    double working_frequency = 0;             ///< [rad/s]
    std::optional<double> transmissibility{}; ///< wanted there
    double allowed_displacement = 0;          ///< in resonance [m]
    double unfolding_ratio = 1;               ///< the lambda in alpha_1
    double margin = 0;                        ///< of all conditions
    Preference preference = Preference::least_stiffness;
    JumpLimit jump_limit = JumpLimit::hysteresis_set;
    std::vector<UnfoldingParameters> listed{}; ///< further stops to judge
    std::size_t points = 2;                    ///< of a curve
    std::string excitation{};                  ///< empty: the only one
    IsolatorBranches branches;
    std::optional<parameters::Values> section{}; ///< for messages
  };
  explicit IsolatorDesign(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  /// For branches, which another analysis follows.
  static bool evaluates(const parameters::Values &analysis);
  std::string type() const override { return "isolator design"; }
  std::vector<Axis> axes() const override { return {}; }
  void check(const System &system) const override;
  std::string evaluated() const override { return settings_.branches.evaluated(); }
  std::vector<std::string> changed_keys() const override { return settings_.branches.keys(); }
  void check_built(const SystemSource &build) const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  StopConditions conditions(const IsolatorSystem &isolator) const;
  PointResult compute(const System &system, LineContext &context) const;

  Settings settings_;
};

} // namespace vibroimpact::analyses
