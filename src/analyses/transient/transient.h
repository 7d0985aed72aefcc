// Transient motion: from initial conditions and under excitation, with the log of its impacts.
#pragma once

#include "analyses/analysis.h"
#include "analyses/recorders/recorders.h"

namespace vibroimpact::analyses {

class Transient : public Analysis {
public:
  struct Settings {
    double duration = 0;          ///< [s]
    double sampling_interval = 0; ///< [s]
    std::size_t recorded_pulses = 0;
    std::size_t listed_impacts = 0;         ///< impacts in the summary
    std::size_t frames = 0;                 ///< pictures of the meshes
    double first_frame = 0, last_frame = 0; ///< [s]
    std::size_t stress_instants = 0;        ///< at which all stresses are looked at
    std::vector<RecorderFactory> recorders; ///< of the whole motion
    std::string place{};                    ///< file and line of the sampling, for messages
    std::string stress_place{};             ///< likewise, of the instants of the stress
    std::optional<parameters::Values> section{};
  };
  explicit Transient(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "transient"; }
  std::vector<Axis> axes() const override { return {}; }
  void check(const System &system) const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  std::vector<double> instants(std::size_t number) const;
  PointResult compute(const System &system, LineContext &context) const;

  Settings settings_;
};

} // namespace vibroimpact::analyses
