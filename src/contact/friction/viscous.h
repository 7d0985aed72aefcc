// Viscous friction while the sides are in contact: F = -c v, v the slip rate, along one direction
// or two.
#pragma once

#include "contact/friction/tangential_law.h"
#include "parameters/values.h"

#include <memory>

namespace vibroimpact::contact {

class Viscous : public TangentialLaw {
public:
  /// damping_constant > 0 [N s/m]; directions 1 or 2
  explicit Viscous(double damping_constant, int directions = 1)
      : damping_constant_(damping_constant), directions_(directions) {}

  static void declare(parameters::Section &friction);
  static std::shared_ptr<const TangentialLaw> create(const parameters::Values &friction);
  static std::shared_ptr<const TangentialLaw> create_planar(const parameters::Values &friction);

  std::string name() const override { return "viscous"; }
  int n_directions() const override { return directions_; }
  std::vector<TangentialMode> modes(const AffineForm &normal_force,
                                    std::size_t first_internal) const override;
  int mode_by_slip(int mode, const LocalState & /*state*/,
                   std::size_t /*first_internal*/) const override {
    return mode;
  }

private:
  double damping_constant_;
  int directions_;
};

} // namespace vibroimpact::contact
