// Kelvin-Voigt bumper: a massless spring and dashpot whose free end is pushed in by the mass, let
// go when it would have to be pulled, and then recovers by itself (Stefani, De Angelis &
// Andreaus 2022).
//
//   F = k z + c z'             z  compression of the stop [m], z' its rate [m/s]
//                              k  stiffness [N/m], c > 0 damping constant [N s/m]
//
// The clearance is measured to the end of the uncompressed stop, so that the end stands at a
// distance gap + z from the mass. z is an internal state of the law. Modes:
//   open     z' = -k z / c, no force; the next contact begins when gap + z falls to zero, which may
//            be before the stop has recovered
//   contact  z = -gap and z' = -gap_rate: the end moves with the mass; it is let go when F falls to
//            zero, while the stop is still compressed
//   leaving  as open, as long as the end falls behind: c gap_rate - k z > 0
// At F = 0 the end has the speed of the mass, so that gap + z starts from a double zero: its sign
// would be decided by round-off. The rate of the distance has a simple zero there, minus that of
// the force over c, and while it is positive the two cannot meet; hence the mode "leaving".
//
// A free mass m leaves at e = exp(-2 x acos(x) / sqrt(1 - x^2)) times the speed it came with,
// x = c / (2 sqrt(k m)) < 1, like from a Kelvin-Voigt stop that has recovered. Stored energy
// k z^2 / 2, in all modes; dissipated power c z'^2. The rate of the recovery is k / c.
#pragma once

#include "contact/contact_law.h"
#include "parameters/values.h"

#include <memory>

namespace vibroimpact::contact {

class KelvinVoigtBumper : public ContactLaw {
public:
  /// stiffness > 0 [N/m], damping_constant > 0 [N s/m]
  KelvinVoigtBumper(double stiffness, double damping_constant);

  static void declare(parameters::Section &contact);
  static std::shared_ptr<const ContactLaw> create(const parameters::Values &contact);

  std::string name() const override { return "kelvin-voigt bumper"; }
  std::vector<InternalState> internal_states() const override;
  int initial_mode(const LocalState &state) const override;
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;
  std::optional<ElasticForce> elastic_force() const override {
    return ElasticForce{.stiffness = stiffness_, .exponent = 1};
  }

private:
  double stiffness_;
  double damping_constant_;
};

} // namespace vibroimpact::contact
