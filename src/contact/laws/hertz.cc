#include "contact/laws/hertz.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace vibroimpact::contact {

namespace {

constexpr const char *section_name = "Hertz";

double compliance(const HertzSide &side) {
  return (1 - side.poisson_ratio * side.poisson_ratio) / side.young_modulus;
}

HertzSide read_side(const parameters::Values &law, const std::string &side) {
  const std::string radius = "Radius " + side;
  const std::string modulus = "Young modulus " + side;
  law.require(modulus);
  return {.curvature = law.has(radius) ? 1 / law.quantity(radius) : 0,
          .young_modulus = law.quantity(modulus),
          .poisson_ratio = law.quantity("Poisson ratio " + side)};
}

void declare_side(parameters::Section &law, const std::string &side, const std::string &which) {
  using namespace parameters;
  law.quantity("Radius " + side, "", dimension::length, range::positive, "R_" + side,
               "Radius of curvature of the " + which + " side; leave empty for a flat side.")
      .quantity("Young modulus " + side, "", dimension::stress, range::positive, "E_" + side,
                "Young's modulus of the " + which + " side.")
      .required("Stiffness is not given")
      .quantity("Poisson ratio " + side, "0.3", dimension::none, Range{.lower = -1, .upper = 0.5},
                "nu_" + side, "Poisson's ratio of the " + which + " side.");
}

} // namespace

double hertz_stiffness(const HertzSide &a, const HertzSide &b) {
  const double curvature = a.curvature + b.curvature;
  if (!(curvature > 0))
    throw std::invalid_argument("at least one side of a Hertz contact must be curved");
  return 4.0 / 3.0 / (compliance(a) + compliance(b)) / std::sqrt(curvature);
}

void declare_hertz_stiffness(parameters::Section &law) {
  using namespace parameters;
  law.quantity("Stiffness", "", dimension::hertz_stiffness, range::positive, "k",
               "Constant of F = k u^(3/2). Leave empty to compute it from radii and materials.");
  declare_side(law, "a", "first");
  declare_side(law, "b", "second");
}

void declare_hertz_constants(parameters::Section &law) {
  using namespace parameters;
  law.quantity(
         "Stiffness", "", dimension::any, range::positive, "k",
         "Constant of F = k u^n in N/m^n. Leave empty to compute it from radii and materials.")
      .quantity("Exponent", "1.5", dimension::none, Range{.lower = 1, .upper = 5}, "n",
                "Exponent of the penetration.");
  declare_side(law, "a", "first");
  declare_side(law, "b", "second");
}

HertzConstants read_hertz_constants(const parameters::Values &law, double exponent) {
  if (law.has("Stiffness"))
    return {.stiffness =
                law.quantity_of("Stiffness", {.length = 1 - exponent, .mass = 1, .time = -2}),
            .exponent = exponent};
  if (!law.has("Radius a") && !law.has("Radius b"))
    law.reject("Radius a", "must be set, or Radius b, when Stiffness is not set");
  return {.stiffness = hertz_stiffness(read_side(law, "a"), read_side(law, "b")),
          .exponent = exponent};
}

HertzConstants read_hertz_constants(const parameters::Values &law) {
  const double exponent = law.quantity("Exponent");
  if (exponent != 1.5 && !law.has("Stiffness"))
    law.reject("Exponent", "must be 1.5 when Stiffness is not set");
  return read_hertz_constants(law, exponent);
}

// A root takes a fraction of the time of a power.
double HertzConstants::secant(double penetration) const {
  return stiffness *
         (exponent == 1.5 ? std::sqrt(penetration) : std::pow(penetration, exponent - 1));
}

Hertz::Hertz(HertzConstants constants)
    : ContactLaw(open_and_contact(), {}), constants_(constants) {}

void Hertz::declare(parameters::Section &contact) {
  declare_hertz_constants(
      contact.subsection(section_name, "Elastic contact of smooth bodies: F = k u^n."));
}

std::shared_ptr<const ContactLaw> Hertz::create(const parameters::Values &contact) {
  return std::make_shared<Hertz>(read_hertz_constants(contact.subsection(section_name)));
}

void Hertz::evaluate(int mode, const LocalState &state, LawResponse &response) const {
  const double penetration = mode == 1 ? std::max(0.0, -state.gap) : 0;
  // d F / d gap = -n k u^(n-1)
  const double slope = constants_.secant(penetration);
  response.force = slope * penetration;
  response.force_by_gap = mode == 1 ? -constants_.exponent * slope : 0;
  response.force_by_gap_rate = 0;
  response.stored_energy = response.force * penetration / (constants_.exponent + 1);
  response.dissipated_power = 0;
}

std::optional<ForcePulse> Hertz::force_pulse(int mode) const {
  if (mode != 1)
    return std::nullopt;
  const ForceEdge touch{.power = constants_.exponent};
  return ForcePulse{.begin = touch, .ends = {{.guard = 0, .edge = touch}}};
}

} // namespace vibroimpact::contact
