// Identification of impact damping: restitution, approach speed and damping factor of every impact
// of a free or forced motion, found again from the force history of one contact alone
// (identify_formulas.h), beside the values the motion itself shows; or of a measured force record.
#pragma once

#include "analyses/analysis.h"
#include "analyses/identification/identify_pulses.h"
#include "analyses/identification/identify_results.h"

#include <optional>

namespace vibroimpact::analyses {

class Identify : public Analysis {
public:
  struct Settings {
    double duration = 0;           ///< of the motion [s]
    double sampling_frequency = 0; ///< of the force record [Hz]; 0: impulse and peak are exact
    std::string contact{};         ///< empty: the only one
    Uncertainties uncertainties{};
    Scales scales{};
    std::size_t map_points = 2; ///< per axis, at least 2
    std::size_t recorded_pulses = 0;
    std::size_t listed_impacts = 0;          ///< impacts in the summary
    double slowest_fitted = 0;               ///< impacts below take no part in fitted laws [m/s]
    std::optional<MeasuredForce> measured{}; ///< instead of a motion
  };
  explicit Identify(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "identify"; }
  std::vector<Axis> axes() const override { return {}; }
  void check(const System &system) const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  std::size_t contact_index(const contact::ContactSet &contacts) const;
  ContactConstants constants(const System &system) const;
  IdentificationInput input(const System &system) const;
  PointResult of_motion(const System &system, LineContext &context) const;
  PointResult of_record(const System &system) const;

  Settings settings_;
};

} // namespace vibroimpact::analyses
