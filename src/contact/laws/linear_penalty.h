// Linear penalty: a spring that acts only while the two points overlap.
//
//   F = k penetration          k  stiffness [N/m]
//
// Stored energy k penetration^2 / 2, nothing dissipated. As k grows the motion approaches the
// rigid, lossless impact: for a mass m at approach speed v the contact lasts pi sqrt(m/k), its peak
// is v sqrt(k m) and the mass leaves at v.
#pragma once

#include "contact/contact_law.h"
#include "parameters/values.h"

#include <memory>

namespace vibroimpact::contact {

class LinearPenalty : public ContactLaw {
public:
  /// stiffness > 0 [N/m]
  explicit LinearPenalty(double stiffness);

  static void declare(parameters::Section &contact);
  static std::shared_ptr<const ContactLaw> create(const parameters::Values &contact);
  /// With this stiffness [N/m] instead of that of the section.
  static std::shared_ptr<const ContactLaw> create_with(const parameters::Values &contact,
                                                       double stiffness);

  std::string name() const override { return "linear penalty"; }
  int initial_mode(const LocalState &state) const override { return open_or_contact(state); }
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;
  std::optional<ElasticForce> elastic_force() const override {
    return ElasticForce{.stiffness = stiffness_, .exponent = 1};
  }

private:
  double stiffness_;
};

} // namespace vibroimpact::contact
