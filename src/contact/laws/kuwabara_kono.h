// Kuwabara-Kono: Hertz contact of viscoelastic bodies (Kuwabara & Kono 1987; derived also by
// Brilliantov et al. 1996).
//
//   F = max(0, k u^(3/2) + A (3/2) k u^(1/2) u')    u  penetration [m], u' its rate [m/s]
//                                                   k  stiffness [N/m^1.5], as of Hertz
//                                                   A  dissipation time [s]
//
// The damping is A times the rate of the elastic force: that force is there a little early. The
// formula turns into tension where u + (3/2) A u' < 0, before the overlap ends; there the law gives
// no force (mode "separating"). Restitution falls with the speed,
//   1 - e = 1.15344 (3/2) A (k/m)^(2/5) v^(1/5) + ...
// for two free bodies of effective mass m that meet at v.
// Stored energy k u^(5/2) / (5/2), lost at the instant at which the force ends; dissipated power
// A (3/2) k u^(1/2) u'^2.
#pragma once

#include "contact/contact_law.h"
#include "parameters/values.h"

#include <memory>

namespace vibroimpact::contact {

class KuwabaraKono : public ContactLaw {
public:
  /// stiffness > 0 [N/m^1.5], dissipation_time >= 0 [s]
  KuwabaraKono(double stiffness, double dissipation_time);

  static void declare(parameters::Section &contact);
  static std::shared_ptr<const ContactLaw> create(const parameters::Values &contact);

  std::string name() const override { return "kuwabara-kono"; }
  int initial_mode(const LocalState &state) const override { return open_or_contact(state); }
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;
  std::optional<ElasticForce> elastic_force() const override {
    return ElasticForce{.stiffness = stiffness_, .exponent = 1.5};
  }
  std::optional<ForcePulse> force_pulse(int mode) const override;

private:
  double stiffness_;
  double dissipation_time_;
};

} // namespace vibroimpact::contact
