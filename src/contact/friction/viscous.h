// Viscous friction while the sides are in contact: F = -c v, v the slip rate.
#pragma once

#include "contact/friction/tangential_law.h"
#include "parameters/values.h"

#include <memory>

namespace vibroimpact::contact {

class Viscous : public TangentialLaw {
public:
  /// damping_constant > 0 [N s/m]
  explicit Viscous(double damping_constant) : damping_constant_(damping_constant) {}

  static void declare(parameters::Section &friction);
  static std::shared_ptr<const TangentialLaw> create(const parameters::Values &friction);

  std::string name() const override { return "viscous"; }
  std::vector<TangentialMode> modes(const AffineForm &normal_force,
                                    std::size_t first_internal) const override;
  int mode_by_slip(int mode, double /*slip_rate*/) const override { return mode; }

private:
  double damping_constant_;
};

} // namespace vibroimpact::contact
