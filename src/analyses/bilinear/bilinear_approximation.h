// Bilinear amplitude approximation: at each frequency the motion that is once open and once tied in
// each period, stitched together from the linear responses of the two phases (bilinear_motion.h).
//
// Of several, the stable one with the longest contact counts. A frequency without such a motion
// fails with the number of those that were found and what speaks against them.
#pragma once

#include "analyses/analysis.h"

namespace vibroimpact::analyses {

class BilinearApproximation : public Analysis {
public:
  struct Settings {
    std::vector<double> frequencies; ///< increasing [Hz]
    std::string excitation{};        ///< empty: the only one with a period
    std::size_t cells = 360;         ///< of the search for the time in contact
    std::size_t samples = 720;       ///< per period
    std::size_t orders = 10;         ///< highest
  };
  explicit BilinearApproximation(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "bilinear approximation"; }
  /// frequency
  std::vector<Axis> axes() const override;
  std::size_t lines() const override { return settings_.frequencies.size(); }
  void check(const System &system) const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  PointResult compute(std::size_t point, const System &system) const;

  Settings settings_;
};

} // namespace vibroimpact::analyses
