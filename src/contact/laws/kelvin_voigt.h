// Kelvin-Voigt with tension cut-off: a spring and a dashpot side by side that push but never pull.
//
//   F = max(0, k u + c u')     u  penetration [m], u' its rate [m/s]
//                              k  stiffness [N/m], c damping constant [N s/m]
//
// The force begins with the jump c u' and has fallen to zero before the overlap ends; from there to
// the end the law is in mode "separating", unless the two sides are driven together again so that
// k u + c u' rises through zero: then the force comes on again, within the same impact. This is
// also the no-tension stop with the three states out, on, and inside but off.
//
// A free mass m with z = c / (2 sqrt(k m)) leaves at e times the speed it came with,
//   e = exp(-2 z acos(z) / sqrt(1 - z^2)), for z > 1 with acosh(z) and sqrt(z^2 - 1).
// Stored energy k u^2 / 2, lost at the instant at which the force ends; dissipated power c u'^2.
#pragma once

#include "contact/contact_law.h"
#include "parameters/values.h"

#include <memory>

namespace vibroimpact::contact {

class KelvinVoigt : public ContactLaw {
public:
  /// stiffness > 0 [N/m], damping_constant >= 0 [N s/m]
  KelvinVoigt(double stiffness, double damping_constant);

  static void declare(parameters::Section &contact);
  static std::shared_ptr<const ContactLaw> create(const parameters::Values &contact);
  /// With this stiffness [N/m] instead of that of the section.
  static std::shared_ptr<const ContactLaw> create_with(const parameters::Values &contact,
                                                       double stiffness);

  std::string name() const override { return "kelvin-voigt"; }
  int initial_mode(const LocalState &state) const override { return open_or_contact(state); }
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;
  std::optional<ElasticForce> elastic_force() const override {
    return ElasticForce{.stiffness = stiffness_, .exponent = 1};
  }

private:
  double stiffness_;
  double damping_constant_;
};

} // namespace vibroimpact::contact
