#include "contact/connection_laws.h"

#include "contact/laws/formula_spring.h"
#include "contact/laws/read_formula.h"
#include "contact/laws/table_spring.h"
#include "contact/laws/zener_spring.h"
#include "model/connection.h"
#include "model/direction.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace vibroimpact::contact {

namespace {

using parameters::Values;

std::shared_ptr<const ContactLaw> read_table_spring(const Values &law) {
  law.require("Elongation");
  law.require("Tension");
  const std::vector<double> elongations = law.quantities("Elongation");
  const std::vector<double> tensions = law.quantities("Tension");
  if (elongations.size() != tensions.size())
    law.reject("Tension", "must have as many values as Elongation, " +
                              std::to_string(elongations.size()) + ".");
  if (std::adjacent_find(elongations.begin(), elongations.end(), std::greater_equal<>()) !=
      elongations.end())
    law.reject("Elongation", "must increase from value to value.");
  return std::make_shared<TableSpring>(ForceCurve(elongations, tensions));
}

std::shared_ptr<const ContactLaw> read_formula_spring(const Values &law) {
  law.require("Tension");
  law.require("Largest elongation");
  auto spring = std::make_shared<FormulaSpring>(read_formula(law, "Tension"),
                                                law.quantity("Largest elongation"));
  if (const std::string fault = spring->fault_at_rest(); !fault.empty())
    law.reject("Tension", "must have a value everywhere, but " + fault + ".");
  return spring;
}

std::shared_ptr<const ContactLaw> read_law(const Values &section) {
  const std::string law = section.choice("Law");
  return law == "table"     ? read_table_spring(section.subsection("Table"))
         : law == "formula" ? read_formula_spring(section.subsection("Formula"))
                            : ZenerSpring::create(section);
}

ContactPair read_pair(const Values &root, const std::string &name, const model::Model &model) {
  const Values section = root.instance("Connection", name);
  const model::MotionAxis axis = model::read_motion_axis(section, "Direction");
  if (axis.rotation)
    section.reject("Law", "must be none for a Direction that is a rotation.");
  const model::Sides sides =
      model::read_sides(section, {model::side_base, model::side_ground}, model);
  return {.name = name,
          .side_a = sides.a,
          .side_b = sides.b,
          .gap = model::connection_elongation(root, name, sides, axis, model),
          .law = read_law(section),
          .origin = section.locate("Law"),
          .normal = axis.direction};
}

} // namespace

void declare_connection_laws(parameters::Section &root) {
  using namespace parameters;
  constexpr int most_points = 1000;
  Section &connection = root.named_subsection("Connection", "");
  connection
      .subsection("Table",
                  "Tension over elongation as a list of points with straight lines between "
                  "them; the first and the last line go on.")
      .quantities("Elongation", "", dimension::length, range::any, "e_i",
                  "Elongations of the points, increasing; negative where the ends approach each "
                  "other.",
                  2, most_points)
      .required()
      .quantities("Tension", "", dimension::force, range::any, "T_i",
                  "Tensions at these elongations; positive pulls the ends together.", 2,
                  most_points)
      .required();
  connection
      .subsection("Formula", "Tension as an expression of the elongation x and its rate v. The "
                             "energy stored is the integral of the tension at v = 0, the rest of "
                             "it dissipates.")
      .text("Tension", "",
            "Expression of x and v, such as k*x + k3*x^3 + c*v, with variables of the file. Either "
            "all of its numbers have units, or none has: then x is in m, v in m/s and the tension "
            "in N.")
      .required()
      .quantity("Largest elongation", "", dimension::length, range::positive, "x_max",
                "Up to there, in both directions, the formula is checked and holds; a motion that "
                "goes farther has failed.")
      .required();
  ZenerSpring::declare(connection);
}

ContactSet with_connections(const Values &root, const model::Model &model, ContactSet contacts) {
  std::vector<ContactPair> pairs = contacts.pairs();
  for (const std::string &name : root.instances("Connection")) {
    const Values section = root.instance("Connection", name);
    if (section.choice("Law") == "none")
      continue;
    const auto same = [&](const ContactPair &pair) { return pair.name == name; };
    if (std::any_of(pairs.begin(), pairs.end(), same))
      section.reject("Law", "must be none, or the connection have another name, for there is a "
                            "contact of this name.");
    pairs.push_back(read_pair(root, name, model));
  }
  return ContactSet(std::move(pairs), contacts.groups());
}

} // namespace vibroimpact::contact
