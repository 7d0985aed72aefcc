// The sections "Contact NAME" of a parameter file and what they stand for.
#include "contact/circular_gap_keys.h"
#include "contact/contact_group.h"
#include "contact/contact_sections.h"
#include "contact/contact_set.h"
#include "contact/curved_gap_law.h"
#include "contact/friction/frictional_law.h"
#include "contact/friction/tangential_laws.h"
#include "contact/laws.h"
#include "contact/local_flexibility.h"
#include "model/direction.h"
#include "model/side.h"

#include <cmath>

namespace vibroimpact::contact {

namespace {

using model::Model;
using model::side_base;
using parameters::Values;

double read_clearance(const Values &contact) {
  if (!has_clearance(contact) && !contact.has("Clearance"))
    return 0;
  contact.require("Clearance");
  const double clearance = contact.quantity("Clearance");
  if (clearance < 0 && !contact.boolean("Prestressed"))
    contact.reject("Clearance",
                   "Clearance must be zero or more; a negative clearance is a prestress and needs "
                   "Prestressed = true.");
  return clearance;
}

/// The law with a stated multiple of the static stiffness there.
std::shared_ptr<const ContactLaw> law_by_fraction(const Values &contact, const std::string &name,
                                                  const Meeting &meeting, const Model &model) {
  const auto flexibility = local_flexibility(meeting.a, meeting.b, meeting.normal, model);
  if (!flexibility)
    contact.reject("Stiffness fraction",
                   "must not be set when there is no static stiffness: contact " + name +
                       " is between points that are rigid, or on a body without supports. Set "
                       "Stiffness of the law.");
  return create_contact_law(contact, contact.quantity("Stiffness fraction") / flexibility->whole);
}

/// 1 / (w M^-1 w^T) [kg], which is m_a m_b / (m_a + m_b), or m_a at a stop, where both sides are
/// lumped masses. None where a side is flexible, for it grows with the modes left out there, or
/// where rotors couple the masses.
std::optional<double> lumped_mass(const Meeting &meeting, const model::Projection &gap,
                                  const Model &model) {
  const auto lumped = [&](const model::PointReference &point) {
    return model.bodies()[point.body]->type == "lumped";
  };
  const double inverse = (gap.row.cwiseAbs2() * model.mass().cwiseInverse()).value();
  if (!lumped(meeting.a) || (meeting.b && !lumped(*meeting.b)) || !model.rotors().empty() ||
      inverse == 0)
    return std::nullopt;
  return 1 / inverse;
}

/// The friction of one section.
class FrictionMaker {
public:
  FrictionMaker(const Values &contact, const Model &model)
      : friction_(contact.subsection("Friction")), model_(model) {
    if (!has_friction(contact))
      return;
    law_ = create_tangential_law(contact);
    if (has_circular_gap(contact))
      refuse_directions();
    else
      direction_ = read_direction();
    if (!model.rotors().empty())
      friction_.reject("Law", "Law must be none in models with rotors.");
  }

  bool given() const { return law_ != nullptr; }

  /// A pair with its normal law, and now with friction too.
  void add(ContactPair &pair, const Meeting &meeting, const std::string &fixed) const {
    if (!law_)
      return;
    if (const std::string reason = why_no_friction(*pair.law, *law_); !reason.empty())
      friction_.reject("Law", "Law must be none with " + reason +
                                  " which Law = " + pair.law->name() + " of the contact has.");
    if (pair.circle)
      return add_to_circle(pair);
    constexpr double right_angle = 1e-9;
    if (std::abs(direction_.dot(pair.normal)) > right_angle)
      friction_.reject("Direction",
                       "Direction must be at a right angle to the normal of the contact.");
    add_direction(pair, meeting, fixed, direction_, friction_.quantity("Surface speed"));
    if (pair.tangential.front().slip.row.isZero(0))
      friction_.reject("Direction", "Direction must be a direction along which at least one of the "
                                    "two sides can move.");
    if (law_->n_directions() == 2)
      add_second_direction(pair, meeting, fixed);
    pair.law = std::make_shared<FrictionalLaw>(pair.law, law_);
  }

private:
  Vector3 read_direction() const {
    friction_.require("Direction");
    return model::read_direction(friction_, "Direction");
  }
  void add_direction(ContactPair &pair, const Meeting &meeting, const std::string &fixed,
                     const Vector3 &direction, double surface_speed) const {
    pair.tangential.push_back({.slip = model::relative_displacement(
                                   meeting.a, meeting.b, fixed != side_base, direction, model_),
                               .surface_speed = surface_speed,
                               .direction = direction});
  }
  void add_second_direction(ContactPair &pair, const Meeting &meeting,
                            const std::string &fixed) const {
    add_direction(pair, meeting, fixed, pair.normal.cross(direction_), 0);
    const RowVector &first = pair.tangential.front().slip.row;
    const RowVector &second = pair.tangential.back().slip.row;
    constexpr double parallel = 1e-12; // part of the product of their squares
    const double products = first.dot(second);
    const double squares = first.squaredNorm() * second.squaredNorm();
    if (squares - products * products <= parallel * squares)
      friction_.reject("Directions", "Directions must be one where the two sides cannot move on "
                                     "each other along two directions across the normal.");
  }
  void refuse_directions() const {
    if (law_->n_directions() > 1)
      friction_.reject("Directions", "Directions must be one when the gap is circular.");
    if (friction_.has("Direction"))
      friction_.reject("Direction",
                       "Direction must not be set when the gap is circular: it is Axis x n.");
  }
  // Before the gap is known to be curved the normal law says whether it may pull.
  void add_to_circle(ContactPair &pair) const {
    pair.tangential.push_back({.slip = pair.circle->second(),
                               .surface_speed = pair.circle->surface_speed(),
                               .direction = pair.circle->axis().cross(pair.normal)});
    pair.law = std::make_shared<FrictionalLaw>(std::make_shared<CurvedGapLaw>(pair.law), law_);
  }

  Values friction_;
  const Model &model_;
  std::shared_ptr<const TangentialLaw> law_; ///< none: no friction
  Vector3 direction_ = Vector3::Zero();
};

/// Makes the contacts of one section; those without a stiffness fraction share one law.
class ContactMaker {
public:
  ContactMaker(const Values &contact, const Model &model,
               const std::optional<double> &effective_mass = {})
      : contact_(contact), model_(model), friction_(contact, model) {
    if (!contact.has("Stiffness fraction"))
      law_ = effective_mass ? create_contact_law_of_mass(contact, *effective_mass)
                            : create_contact_law(contact);
  }

  ContactPair pair(const std::string &name, const Meeting &meeting,
                   const std::string &fixed) const {
    ContactPair made{.name = name,
                     .side_a = model_.point_name(meeting.a),
                     .side_b = meeting.b ? model_.point_name(*meeting.b) : fixed,
                     .clearance = meeting.clearance,
                     .gap = model::relative_displacement(meeting.a, meeting.b, fixed != side_base,
                                                         meeting.normal, model_),
                     .law = law_ ? law_ : law_by_fraction(contact_, name, meeting, model_),
                     .accept_initial_penetration =
                         contact_.choice("Initial penetration") == "accept" ||
                         contact_.boolean("Prestressed"),
                     .origin = contact_.locate("Clearance"),
                     .normal = meeting.normal,
                     .least_flexibility_share = contact_.quantity("Least flexibility share"),
                     .largest_impact_error = contact_.quantity("Largest impact error")};
    if (has_circular_gap(contact_))
      bend_gap(contact_, meeting, fixed, model_, made);
    friction_.add(made, meeting, fixed);
    if (made.circle && !friction_.given())
      made.law = std::make_shared<CurvedGapLaw>(made.law);
    return made;
  }

private:
  const Values &contact_;
  const Model &model_;
  FrictionMaker friction_;
  std::shared_ptr<const ContactLaw> law_;
};

// Zero less a component, for a component of zero has no sign then.
Vector3 read_normal(const ContactSection &contact) {
  const Vector3 direction = model::read_direction(contact.values, "Direction");
  return contact.mirrored ? Vector3(Vector3::Zero() - direction) : direction;
}

Meeting single_meeting(const ContactSection &contact, const model::Sides &sides,
                       const Model &model) {
  Meeting meeting{.normal = read_normal(contact), .clearance = read_clearance(contact.values)};
  model.find_point(sides.a, meeting.a);
  if (model::PointReference b; model.find_point(sides.b, b))
    meeting.b = b;
  return meeting;
}

ContactPair read_contact(const ContactSection &section, const std::string &name,
                         const Model &model) {
  const Values &contact = section.values;
  refuse_pairing_keys(contact);
  const model::Sides sides = model::read_sides(contact, {model::side_stop, side_base}, model);
  const Meeting meeting = single_meeting(section, sides, model);
  const std::string fixed = meeting.b ? std::string() : sides.b;
  const model::Projection gap =
      model::relative_displacement(meeting.a, meeting.b, fixed != side_base, meeting.normal, model);
  ContactPair pair =
      ContactMaker(contact, model, lumped_mass(meeting, gap, model)).pair(name, meeting, fixed);
  if (pair.gap.row.isZero(0) && !pair.circle && !pair.law->always_in_contact())
    contact.reject(
        "Direction",
        "Direction must be a direction along which at least one of the two sides can move.");
  return pair;
}

ContactGroup read_group(const Values &contact, const std::string &name, const Model &model,
                        std::vector<ContactPair> &pairs) {
  if (has_circular_gap(contact))
    contact.reject("Gap", "Gap must be plane when Pairing = " + contact.choice("Pairing") + ".");
  if (contact.has("Clearance"))
    read_clearance(contact);
  const Meetings meetings = find_meetings(contact, model);
  ContactGroup group{.name = name, .first = pairs.size(), .unpaired = meetings.unpaired};
  const ContactMaker maker(contact, model);
  for (const Meeting &meeting : meetings.list) {
    const model::Projection gap = model::relative_displacement(
        meeting.a, meeting.b, meetings.fixed != side_base, meeting.normal, model);
    if (gap.row.isZero(0) && has_clearance(contact)) {
      ++group.held;
      continue;
    }
    ++group.count;
    pairs.push_back(maker.pair(name + "." + std::to_string(group.count), meeting, meetings.fixed));
    pairs.back().group = name;
  }
  if (group.count == 0)
    contact.reject("Between",
                   "Between must be interfaces with a node that can move along the normal.");
  return group;
}

} // namespace

void declare_contacts(parameters::Section &root) {
  using namespace parameters;
  Section &contact = root.named_subsection(
      "Contact", "Two points that can touch, or a point and a fixed stop, or many such pairs. The "
                 "gap is clearance + (u_b - u_a) . n; the force is repulsive.");
  contact
      .names(
          "Between", "",
          "The two sides a, b as BODY.POINT; the second may be stop (fixed in space, the default) "
          "or base (a stop on the base that the first body stands on). With a Pairing: "
          "BODY.INTERFACE.")
      .required()
      .text("Direction", "x",
            "Contact normal n, from the first side to the second: x, -y or three "
            "numbers. Of a circular gap the direction across Axis from which angles count.")
      .quantity("Clearance", "", dimension::length, range::any, "g_0",
                "Gap of the undeformed model. Pairs of two interfaces have that of the geometry "
                "when it is not given.")
      .required("Pairing = points or stops")
      .boolean(
          "Prestressed", "false",
          "Says that a negative clearance is meant: the two sides press on each other at rest.")
      .choice("Initial penetration", "refuse", {"refuse", "accept"},
              "What to do when a motion starts with the two sides overlapping.");
  declare_circular_gap(contact);
  declare_mirror(contact);
  declare_pairing(contact);
  contact
      .quantity("Stiffness fraction", "", dimension::none, range::positive, "",
                "Instead of the key Stiffness of a law: this multiple of the static stiffness with "
                "which both sides together resist a force between them.")
      .quantity("Least flexibility share", "0.9", dimension::none, range::fraction, "",
                "There is a warning when the kept modes hold less than this fraction of the static "
                "displacement that a force at the contact causes: a measure for quasi-static "
                "contacts, not for impacts.")
      .quantity("Largest impact error", "0.02", dimension::none, range::positive, "",
                "There is a warning when the modes that are left out make the peak force of a "
                "short impact, or the impulse between rigid sides, too large by more than this "
                "share.");
  declare_contact_laws(contact);
  declare_friction(contact);
}

ContactSet read_contacts(const parameters::Values &root, const std::vector<std::string> &names,
                         const Model &model) {
  std::vector<ContactPair> pairs;
  std::vector<ContactGroup> groups;
  for (const std::string &name : names) {
    const ContactSection contact = contact_section(root, name);
    if (contact.values.choice("Pairing") == "points")
      pairs.push_back(read_contact(contact, name, model));
    else
      groups.push_back(read_group(contact.values, name, model, pairs));
  }
  return ContactSet(std::move(pairs), std::move(groups));
}

} // namespace vibroimpact::contact
