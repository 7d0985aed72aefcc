// The Campbell diagram: frequencies, damping and directions of whirl of the modes of the whole
// linear system over the speed of a spin, no contact closed, and the speeds at which a frequency is
// a given multiple of the speed, or at which a mode begins to grow or to decay.
#pragma once

#include "analyses/analysis.h"
#include "analyses/sweeps/tied_contacts.h"

namespace vibroimpact::analyses {

class WhirlBranches;

class Campbell : public Analysis {
public:
  struct Settings {
    std::string spin;           ///< empty: the only one
    std::vector<double> speeds; ///< rising [rad/s]
    std::size_t modes = 0;
    std::vector<double> multiples;
    TiedContacts tied;
  };
  explicit Campbell(Settings settings) : settings_(std::move(settings)) {}

  static void declare(parameters::Section &analysis);
  static std::shared_ptr<const Analysis> create(const parameters::Values &analysis);

  std::string type() const override { return "campbell"; }
  std::vector<Axis> axes() const override { return {}; }
  void check(const System &system) const override;
  void run_line(std::size_t line, System &system, LineContext &context) const override;

private:
  std::size_t spin(const System &system) const;
  PointResult compute(const System &system) const;

  Settings settings_;
};

} // namespace vibroimpact::analyses
