#include "contact/laws/tsuji.h"

#include "contact/laws/hertz.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace vibroimpact::contact {

namespace {
constexpr const char *section_name = "Tsuji";
} // namespace

double tsuji_damping(double restitution_coefficient) {
  if (!(restitution_coefficient > 0) || restitution_coefficient > 1)
    throw std::invalid_argument("a restitution coefficient lies above 0 and up to 1");
  const double loss = -std::log(restitution_coefficient);
  return std::sqrt(5.0) * loss / std::hypot(std::numbers::pi, loss);
}

Tsuji::Tsuji(double stiffness, double damping)
    : ContactLaw(open_and_contact(), {}), stiffness_(stiffness), damping_(damping) {}

void Tsuji::declare(parameters::Section &contact) {
  using namespace parameters;
  Section &law = contact.subsection(section_name,
                                    "Hertz contact whose restitution is the same at every speed: "
                                    "F = k u^(3/2) + alpha sqrt(m k) u^(1/4) u', pulling at the "
                                    "end. Give alpha or a restitution coefficient.");
  declare_hertz_stiffness(law);
  law.quantity("Damping coefficient", "", dimension::none, range::non_negative, "alpha",
               "Dimensionless damping; two free bodies part only below sqrt(5).")
      .quantity("Restitution coefficient", "", dimension::none,
                Range{.lower = 0, .upper = 1, .lower_open = true}, "e",
                "Restitution that two free bodies of the effective mass show.")
      .required("Damping coefficient is not given")
      .quantity(
          "Effective mass", "", dimension::mass, range::positive, "m",
          "Mass that meets at the contact, m_a m_b / (m_a + m_b) of two free bodies. It follows "
          "from the model where both sides are lumped masses, stops or the base; of flexible "
          "bodies "
          "it must be given, and the modal analysis reports what it is with the modes kept.")
      .required("a side belongs to a body that is not lumped, or there are rotors");
}

namespace {

// With alpha, or with that of the restitution coefficient.
std::shared_ptr<const ContactLaw> with_mass(const parameters::Values &law, double mass) {
  const double stiffness = read_hertz_constants(law, 1.5).stiffness;
  if (law.has("Damping coefficient") && law.has("Restitution coefficient"))
    law.reject("Damping coefficient",
               "Damping coefficient must not be set when Restitution coefficient is set.");
  if (!law.has("Damping coefficient"))
    law.require("Restitution coefficient");
  const double alpha = law.has("Damping coefficient")
                           ? law.quantity("Damping coefficient")
                           : tsuji_damping(law.quantity("Restitution coefficient"));
  return std::make_shared<Tsuji>(stiffness, alpha * std::sqrt(mass * stiffness));
}

} // namespace

std::shared_ptr<const ContactLaw> Tsuji::create(const parameters::Values &contact) {
  const parameters::Values law = contact.subsection(section_name);
  law.require("Effective mass");
  return with_mass(law, law.quantity("Effective mass"));
}

std::shared_ptr<const ContactLaw> Tsuji::create_of_mass(const parameters::Values &contact,
                                                        double effective_mass) {
  const parameters::Values law = contact.subsection(section_name);
  return with_mass(law,
                   law.has("Effective mass") ? law.quantity("Effective mass") : effective_mass);
}

void Tsuji::evaluate(int mode, const LocalState &state, LawResponse &response) const {
  const double penetration = mode == 1 ? std::max(0.0, -state.gap) : 0;
  const double root = std::sqrt(penetration);
  const double elastic = stiffness_ * root * penetration;
  const double resistance = damping_ * std::sqrt(root); // force per penetration rate
  response.force = elastic - resistance * state.gap_rate;
  // The slope of u^(1/4) is infinite at the first touch; there the force has none.
  const double resistance_slope = penetration > 0 ? 0.25 * resistance / penetration : 0;
  response.force_by_gap = -1.5 * stiffness_ * root + resistance_slope * state.gap_rate;
  response.force_by_gap_rate = -resistance;
  response.stored_energy = elastic * penetration / 2.5;
  response.dissipated_power = resistance * state.gap_rate * state.gap_rate;
}

// u^(1/4) u' at both ends.
std::optional<ForcePulse> Tsuji::force_pulse(int mode) const {
  if (mode != 1)
    return std::nullopt;
  const ForceEdge edge =
      damping_ > 0 ? ForceEdge{.power = 0.25, .root = 4} : ForceEdge{.power = 1.5};
  return ForcePulse{.begin = edge, .ends = {{.guard = 0, .edge = edge}}};
}

} // namespace vibroimpact::contact
