#include "contact/contact_set.h"

#include "contact/laws.h"
#include "model/direction.h"
#include "model/side.h"

namespace vibroimpact {

namespace {

void check_moves(const parameters::Values &contact, const Projection &gap) {
  if (gap.row.isZero(0))
    contact.reject("Direction", "a direction along which at least one of the two sides can move.");
}

double read_clearance(const parameters::Values &contact) {
  contact.require("Clearance");
  const double clearance = contact.quantity("Clearance");
  if (clearance < 0 && !contact.boolean("Prestressed"))
    contact.reject("Clearance", "zero or more; a negative clearance is a prestress and needs "
                                "Prestressed = true.");
  return clearance;
}

ContactPair read_contact(const parameters::Values &contact, const std::string &name,
                         const Model &model) {
  const Sides sides = read_sides(contact, {side_stop, side_base}, model);
  const Vector3 normal = read_direction(contact, "Direction");
  Projection gap = relative_displacement(sides, normal, model);
  check_moves(contact, gap);
  return {.name = name,
          .side_a = sides.a,
          .side_b = sides.b,
          .clearance = read_clearance(contact),
          .gap = std::move(gap),
          .law = create_contact_law(contact),
          .accept_initial_penetration =
              contact.choice("Initial penetration") == "accept" || contact.boolean("Prestressed"),
          .origin = contact.locate("Clearance")};
}

} // namespace

ContactSet::ContactSet(std::vector<ContactPair> pairs) : pairs_(std::move(pairs)) {
  for (ContactPair &pair : pairs_) {
    pair.internal_offset = n_internal_;
    n_internal_ += pair.n_internal();
  }
}

Vector ContactSet::initial_internal() const {
  Vector internal(n_internal_);
  for (const ContactPair &pair : pairs_)
    for (int i = 0; i < pair.n_internal(); ++i)
      internal[pair.internal_offset + i] = pair.law->initial_internal()[i];
  return internal;
}

double ContactSet::effective_mass(std::size_t pair, const Model &model) const {
  const RowVector &row = pairs_.at(pair).gap.row;
  return 1 / (row.cwiseAbs2() * model.mass().cwiseInverse()).value();
}

void declare_contacts(parameters::Section &root) {
  using namespace parameters;
  Section &contact = root.named_subsection(
      "Contact", "Two points that can touch, or a point and a fixed stop. The gap is clearance + "
                 "(u_b - u_a) . n; the force pushes the two apart.");
  contact
      .names(
          "Between", "",
          "The two sides a, b as BODY.POINT; the second may be stop (fixed in space, the default) "
          "or base (a stop on the base that the first body stands on).")
      .text("Direction", "x",
            "Contact normal n, from the first side to the second: x, -y or three "
            "numbers.")
      .quantity("Clearance", "", dimension::length, range::any, "g_0",
                "Gap of the undeformed model.")
      .boolean(
          "Prestressed", "false",
          "Says that a negative clearance is meant: the two sides press on each other at rest.")
      .choice("Initial penetration", "refuse", {"refuse", "accept"},
              "What to do when a motion starts with the two sides overlapping.");
  declare_contact_laws(contact);
}

ContactSet read_contacts(const parameters::Values &root, const std::vector<std::string> &names,
                         const Model &model) {
  std::vector<ContactPair> pairs;
  for (const std::string &name : names)
    pairs.push_back(read_contact(root.instance("Contact", name), name, model));
  return ContactSet(std::move(pairs));
}

} // namespace vibroimpact
