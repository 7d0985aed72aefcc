// Hunt–Crossley: Hertz contact whose damping grows with the penetration, so that the force starts
// and ends at zero (Hunt & Crossley 1975).
//
//   F = k u^n (1 + d u') = k u^n + mu u^n u'    u  penetration [m], u' its rate [m/s]
//                                               k  stiffness [N/m^n], n exponent
//                                               mu damping factor [N s/m^(n+1)]
//                                               d = mu / k  dissipation [s/m]
//
// Two free bodies that meet at v_c part at e v_c, (1 + e) d_c = ln[(1 + d_c)/(1 - e d_c)],
// d_c = d v_c, for every n and every pair of masses. Given e instead of mu, d = d_c / v_c with v_c
// either fixed or the approach speed of each impact by itself (then e is the same at every speed).
// Impacts slower than a lowest speed v_min take that one, so that a body pressed on comes to rest.
//
// Pulled apart faster than 1/d the formula would turn into tension: the law then gives no force
// while the points still overlap (mode "separating") until they slow down or part.
// Stored energy k u^(n+1)/(n+1), lost at the instant at which the force is cut off; dissipated
// power k u^n d u'^2.
#pragma once

#include "contact/laws/hertz.h"

namespace vibroimpact::contact {

class HuntCrossley : public ContactLaw {
public:
  /// dissipation d >= 0 [s/m], the same at every speed
  static std::shared_ptr<HuntCrossley> with_dissipation(HertzConstants constants,
                                                        double dissipation);
  /// d = dimensionless_damping / (approach speed of each impact); below `lowest_speed` > 0 [m/s]
  /// that speed is used and remembered, so that d stays bounded at grazing.
  static std::shared_ptr<HuntCrossley> with_dimensionless_damping(HertzConstants constants,
                                                                  double dimensionless_damping,
                                                                  double lowest_speed);

  static void declare(parameters::Section &contact);
  static std::shared_ptr<const ContactLaw> create(const parameters::Values &contact);

  std::string name() const override { return "hunt-crossley"; }
  int initial_mode(const LocalState &state) const override;
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;
  std::vector<InternalState> internal_states() const override;
  std::optional<PowerLaw> power_law() const override;
  std::optional<ForcePulse> force_pulse(int mode) const override;

private:
  HuntCrossley(std::vector<Mode> modes, std::vector<double> initial_internal,
               HertzConstants constants, double coefficient, double lowest_speed);
  double dissipation(const LocalState &state) const;

  HertzConstants constants_;
  double coefficient_;  ///< d, or d_c when each impact has its own
  double lowest_speed_; ///< 0 when d is fixed [m/s]
};

} // namespace vibroimpact::contact
