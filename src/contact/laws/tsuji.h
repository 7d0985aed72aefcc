// Tsuji: Hertz contact with the damping that makes restitution independent of the speed (Tsuji,
// Tanaka & Ishida 1992).
//
//   F = k u^(3/2) + alpha sqrt(m k) u^(1/4) u'    u  penetration [m], u' its rate [m/s]
//                                                 k  stiffness [N/m^1.5], as of Hertz
//                                                 m  effective mass of the two sides [kg]
//                                                 alpha  damping coefficient [1]
//
// With x = u^(5/4) as coordinate and ds = (5/4) u^(1/4) dt as time two free bodies of the effective
// mass m obey x'' + 2 z w x' + w^2 x = 0 with z = alpha / sqrt(5) (Antypov & Elliott 2011): when
// the overlap ends they part at
//   e = exp(-pi z / sqrt(1 - z^2)),   so that   alpha = sqrt(5) ln(1/e) / sqrt(pi^2 + ln^2 e),
// at every speed; for alpha >= sqrt(5) they never part. As published, tension is not cut off: the
// force pulls at the end of the contact. m only scales the damping; a mass other than that of the
// bodies, or the mass of flexible ones, gives another restitution.
// Stored energy k u^(5/2) / (5/2), dissipated power alpha sqrt(m k) u^(1/4) u'^2.
#pragma once

#include "contact/contact_law.h"
#include "parameters/values.h"

#include <memory>

namespace vibroimpact::contact {

/// alpha for e in (0, 1]. Throws std::invalid_argument for another e.
double tsuji_damping(double restitution_coefficient);

class Tsuji : public ContactLaw {
public:
  /// stiffness k > 0 [N/m^1.5]; damping alpha sqrt(m k) >= 0 [N s/m^1.25]
  Tsuji(double stiffness, double damping);

  static void declare(parameters::Section &contact);
  static std::shared_ptr<const ContactLaw> create(const parameters::Values &contact);
  /// Of two sides with this effective mass [kg]; the key has the last word.
  static std::shared_ptr<const ContactLaw> create_of_mass(const parameters::Values &contact,
                                                          double effective_mass);

  std::string name() const override { return "tsuji"; }
  int initial_mode(const LocalState &state) const override { return open_or_contact(state); }
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;
  std::optional<ElasticForce> elastic_force() const override {
    return ElasticForce{.stiffness = stiffness_, .exponent = 1.5};
  }
  std::optional<ForcePulse> force_pulse(int mode) const override;
  bool may_pull() const override { return true; }

private:
  double stiffness_;
  double damping_;
};

} // namespace vibroimpact::contact
