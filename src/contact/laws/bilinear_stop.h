// Bilinear stop: a spring and a dashpot that are there while the two points overlap and not
// otherwise. Nothing cuts tension off.
//
//   F = k u + c u'             u  penetration [m], u' its rate [m/s]
//                              k  stiffness [N/m], c damping constant [N s/m]
//
// As if the stop stuck to the mass for the time of the overlap: the force begins with the jump +c
// u' and ends with the jump from -c |u'|, a pull, to zero. It is the bilinear stop with switched
// damping of vibration isolators. A free mass m with z = c / (2 sqrt(k m)) < 1 leaves at e =
// exp(-pi z / sqrt(1 - z^2)) times the speed it came with, after half a damped period; with z >= 1
// it never leaves. Stored energy k u^2 / 2, dissipated power c u'^2.
#pragma once

#include "contact/contact_law.h"
#include "parameters/values.h"

#include <memory>

namespace vibroimpact::contact {

class BilinearStop : public ContactLaw {
public:
  /// stiffness >= 0 [N/m], damping_constant >= 0 [N s/m]
  BilinearStop(double stiffness, double damping_constant);

  static void declare(parameters::Section &contact);
  static std::shared_ptr<const ContactLaw> create(const parameters::Values &contact);
  /// With this stiffness [N/m] instead of that of the section.
  static std::shared_ptr<const ContactLaw> create_with(const parameters::Values &contact,
                                                       double stiffness);

  std::string name() const override { return "bilinear stop"; }
  int initial_mode(const LocalState &state) const override { return open_or_contact(state); }
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;
  std::optional<ElasticForce> elastic_force() const override;
  bool may_pull() const override { return damping_constant_ > 0; }

private:
  double stiffness_;
  double damping_constant_;
};

} // namespace vibroimpact::contact
