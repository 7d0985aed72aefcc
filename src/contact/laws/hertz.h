// Hertz: elastic contact of two smooth bodies.
//
//   F = k penetration^n        k  [N/m^n],  n = 3/2 for two spheres or a sphere on a plane
//
// From geometry and material (Goldsmith 1960, Johnson 1985):
//   k = 4/3 E* sqrt(R*),  1/E* = (1 - nu_a^2)/E_a + (1 - nu_b^2)/E_b,  1/R* = 1/R_a + 1/R_b,
// a flat side has 1/R = 0. Stored energy k penetration^(n+1) / (n+1), nothing dissipated.
// Slightly negative penetrations met inside a step while an end of contact is located give no
// force.
#pragma once

#include "contact/contact_law.h"
#include "parameters/values.h"

#include <memory>

namespace vibroimpact::contact {

/// One side of a Hertz contact.
struct HertzSide {
  double curvature = 0;     ///< 1/R >= 0 [1/m]; 0 is flat
  double young_modulus = 0; ///< > 0 [Pa]
  double poisson_ratio = 0; ///< from -1 to 0.5
};

/// 4/3 E* sqrt(R*) [N/m^1.5]. std::invalid_argument when both sides are flat.
double hertz_stiffness(const HertzSide &a, const HertzSide &b);

/// Stiffness and exponent of F = k u^n.
struct HertzConstants {
  double stiffness = 0; ///< > 0 [N/m^n]
  double exponent = 1.5;

  /// k u^(n-1), the secant stiffness at a penetration u >= 0 [N/m]
  double secant(double penetration) const;
};

/// The keys of the elastic part, shared by the laws built on it. Laws that are made for n = 3/2
/// only have no key for the exponent.
void declare_hertz_constants(parameters::Section &law);
void declare_hertz_stiffness(parameters::Section &law);
HertzConstants read_hertz_constants(const parameters::Values &law);
/// Their value for a given exponent.
HertzConstants read_hertz_constants(const parameters::Values &law, double exponent);

class Hertz : public ContactLaw {
public:
  explicit Hertz(HertzConstants constants);

  static void declare(parameters::Section &contact);
  static std::shared_ptr<const ContactLaw> create(const parameters::Values &contact);

  std::string name() const override { return "hertz"; }
  int initial_mode(const LocalState &state) const override { return open_or_contact(state); }
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;
  std::optional<PowerLaw> power_law() const override {
    return PowerLaw{.stiffness = constants_.stiffness, .exponent = constants_.exponent};
  }

  std::optional<ForcePulse> force_pulse(int mode) const override;

private:
  HertzConstants constants_;
};

} // namespace vibroimpact::contact
