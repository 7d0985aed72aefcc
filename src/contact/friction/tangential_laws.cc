#include "contact/friction/tangential_laws.h"

#include "contact/friction/coulomb.h"
#include "contact/friction/lugre.h"
#include "contact/friction/piecewise_linear.h"
#include "contact/friction/planar_coulomb.h"
#include "contact/friction/planar_spring_slider.h"
#include "contact/friction/spring_slider.h"
#include "contact/friction/stribeck.h"
#include "contact/friction/viscous.h"

#include <stdexcept>

namespace vibroimpact::contact {

namespace {

constexpr const char *none = "none";

using Maker = std::shared_ptr<const TangentialLaw> (*)(const parameters::Values &friction);

struct TangentialEntry {
  const char *name;
  const char *section; ///< with its constants
  void (*declare)(parameters::Section &friction);
  Maker create;
  Maker create_planar = nullptr; ///< along two directions; none: there is no such law
};

constexpr TangentialEntry tangential_laws[] = {
    {"coulomb", "Coulomb", Coulomb::declare, Coulomb::create, PlanarCoulomb::create},
    {"spring-slider", "Spring-slider", SpringSlider::declare, SpringSlider::create,
     PlanarSpringSlider::create},
    {"viscous", "Viscous", Viscous::declare, Viscous::create, Viscous::create_planar},
    {"piecewise-linear", "Piecewise-linear", PiecewiseLinear::declare, PiecewiseLinear::create},
    {"stribeck", "Stribeck", Stribeck::declare, Stribeck::create},
    {"lugre", "LuGre", LuGre::declare, LuGre::create},
};

// "a, b or c"
std::string planar_names() {
  std::vector<std::string> names;
  for (const TangentialEntry &law : tangential_laws)
    if (law.create_planar)
      names.emplace_back(law.name);
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i)
    list += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + names[i];
  return list;
}

} // namespace

void declare_friction(parameters::Section &contact) {
  using namespace parameters;
  std::vector<std::string> names = {none};
  for (const TangentialEntry &law : tangential_laws)
    names.emplace_back(law.name);
  Section &friction = contact.subsection(
      "Friction", "Forces along directions across the contact normal, while the sides touch. The "
                  "slip is that of the second side on the first.");
  friction.choice("Law", none, names, "Law of friction; its constants stand in its own section.")
      .choice("Directions", "one", {"one", "two"},
              "one: along Direction; two: along Direction and along n x Direction, n the contact "
              "normal, with laws coulomb, spring-slider and viscous.")
      .text("Direction", "",
            "Tangential direction, at a right angle to the contact normal: x, -y or three numbers. "
            "Of "
            "a circular gap it is Axis x n.")
      .required("Law is not none and Gap = plane")
      .quantity("Surface speed", "0 m/s", dimension::velocity, range::any, "V",
                "Speed of the second side's surface along the direction, as of a belt or of a disc "
                "that turns; it adds to the slip rate.");
  for (const TangentialEntry &law : tangential_laws)
    law.declare(friction);
}

bool has_friction(const parameters::Values &contact) {
  return contact.subsection("Friction").choice("Law") != none;
}

bool has_two_directions(const parameters::Values &contact) {
  return has_friction(contact) && contact.subsection("Friction").choice("Directions") == "two";
}

std::shared_ptr<const TangentialLaw> create_tangential_law(const parameters::Values &contact) {
  const parameters::Values friction = contact.subsection("Friction");
  const std::string chosen = friction.choice("Law");
  const bool two = has_two_directions(contact);
  for (const TangentialEntry &law : tangential_laws) {
    if (chosen != law.name)
      continue;
    if (two && !law.create_planar)
      friction.reject("Law", "Law must be " + planar_names() + " when Directions = two.");
    return two ? law.create_planar(friction) : law.create(friction);
  }
  throw std::logic_error("tangential law without an entry: " + chosen);
}

std::vector<std::string> unused_friction_sections(const parameters::Values &contact) {
  const parameters::Values friction = contact.subsection("Friction");
  const std::string chosen = friction.choice("Law");
  std::vector<std::string> warnings;
  for (const TangentialEntry &law : tangential_laws)
    if (chosen != law.name && friction.subsection_given(law.section))
      warnings.push_back(friction.locate("Law") + ": the section " + law.section +
                         " is not used; it belongs to Law = " + law.name + ".");
  return warnings;
}

} // namespace vibroimpact::contact
