#include "contact/contact_set.h"

#include "contact/laws.h"
#include "model/direction.h"

namespace vibroimpact {

namespace {

constexpr const char *fixed_stop = "stop";

// Displacement of one side along n; nothing moves a fixed stop.
Projection side_displacement(const parameters::Values &contact, const std::string &side,
                             const Vector3 &normal, const Model &model) {
  if (side == fixed_stop)
    return {.row = RowVector::Zero(model.size()),
            .carrier = std::vector<double>(model.sources().size(), 0)};
  std::vector<std::string> known = model.point_names();
  known.emplace_back(fixed_stop);
  contact.require_known("Between", side, known);
  PointReference point;
  model.find_point(side, point);
  return model.displacement(point, normal, true);
}

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
  std::vector<std::string> sides = contact.names("Between");
  if (sides.size() == 1)
    sides.emplace_back(fixed_stop);
  if (sides.size() != 2 || sides[0] == sides[1])
    contact.reject("Between", "two different points as BODY.POINT, BODY.POINT; the second may be "
                              "stop, a fixed stop.");
  const Vector3 normal = read_direction(contact, "Direction");
  const Projection a = side_displacement(contact, sides[0], normal, model);
  const Projection b = side_displacement(contact, sides[1], normal, model);
  Projection gap{.row = b.row - a.row, .carrier = b.carrier};
  for (std::size_t k = 0; k < gap.carrier.size(); ++k)
    gap.carrier[k] -= a.carrier[k];
  check_moves(contact, gap);
  return {.name = name,
          .side_a = sides[0],
          .side_b = sides[1],
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
      .names("Between", "",
             "The two sides a, b as BODY.POINT; the second may be stop, which is the default.")
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
