#include "contact/laws/kuwabara_kono.h"

#include "contact/laws/hertz.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::contact {

namespace {
constexpr const char *section_name = "Kuwabara-Kono";
} // namespace

KuwabaraKono::KuwabaraKono(double stiffness, double dissipation_time)
    : ContactLaw(open_contact_separating({.gap = -1, .gap_rate = -1.5 * dissipation_time}), {}),
      stiffness_(stiffness), dissipation_time_(dissipation_time) {}

void KuwabaraKono::declare(parameters::Section &contact) {
  using namespace parameters;
  Section &law = contact.subsection(
      section_name, "Hertz contact of viscoelastic bodies that push but never pull: "
                    "F = max(0, k u^(3/2) + A (3/2) k u^(1/2) u').");
  declare_hertz_stiffness(law);
  law.quantity("Dissipation time", "", dimension::time, range::non_negative, "A",
               "Damping force over rate of the elastic force.")
      .required();
}

std::shared_ptr<const ContactLaw> KuwabaraKono::create(const parameters::Values &contact) {
  const parameters::Values law = contact.subsection(section_name);
  law.require("Dissipation time");
  return std::make_shared<KuwabaraKono>(read_hertz_constants(law, 1.5).stiffness,
                                        law.quantity("Dissipation time"));
}

void KuwabaraKono::evaluate(int mode, const LocalState &state, LawResponse &response) const {
  const double penetration = mode == 1 ? std::max(0.0, -state.gap) : 0;
  const double root = std::sqrt(penetration);
  const double elastic = stiffness_ * root * penetration;
  const double resistance = 1.5 * dissipation_time_ * stiffness_ * root;
  response.force = elastic - resistance * state.gap_rate;
  // The slope of u^(1/2) is infinite at the first touch; there the force has none.
  const double resistance_slope = penetration > 0 ? 0.5 * resistance / penetration : 0;
  response.force_by_gap = -1.5 * stiffness_ * root + resistance_slope * state.gap_rate;
  response.force_by_gap_rate = -resistance;
  response.stored_energy = elastic * penetration / 2.5;
  response.dissipated_power = resistance * state.gap_rate * state.gap_rate;
}

// u^(1/2) u' at the touch; the force is cut off while there is still penetration, but for A = 0.
std::optional<ForcePulse> KuwabaraKono::force_pulse(int mode) const {
  if (mode != 1)
    return std::nullopt;
  const ForceEdge elastic{.power = 1.5};
  if (dissipation_time_ == 0)
    return ForcePulse{.begin = elastic, .ends = {{.guard = 0, .edge = elastic}}};
  return ForcePulse{.begin = {.power = 0.5, .root = 2}, .ends = {{.guard = 1}}};
}

} // namespace vibroimpact::contact
