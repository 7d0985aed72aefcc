#include "contact/circular_gap_keys.h"

#include "contact/contact_sections.h"
#include "model/direction.h"
#include "model/side.h"

#include <cmath>

namespace vibroimpact::contact {

using parameters::Values;

namespace {

constexpr const char *gap_key = "Gap";

bool beside(const Values &contact) { return contact.choice(gap_key) == "beside"; }

Vector3 read_axis(const Values &contact, const Vector3 &normal) {
  contact.require("Axis");
  const Vector3 axis = model::read_direction(contact, "Axis");
  constexpr double right_angle = 1e-9;
  if (std::abs(axis.dot(normal)) > right_angle)
    contact.reject("Axis", "Axis must be at a right angle to Direction.");
  return axis;
}

// What an approach from any side needs.
void check_law(const Values &contact, const ContactLaw &law) {
  if (law.always_in_contact())
    contact.reject(gap_key, "Gap must be plane with Law = " + law.name() +
                                ": in a circular gap there is no force where the gap is open.");
}

void check_surroundings(const Values &contact, const model::Model &model) {
  if (!model.rotors().empty())
    contact.reject(gap_key, "Gap must be plane in models with rotors.");
  if (contact.has("Mirrored as"))
    contact.reject("Mirrored as",
                   "Mirrored as must not be set when Gap = " + contact.choice(gap_key) + ".");
  if (contact.has("Radii") && !beside(contact))
    contact.reject("Radii", "Radii must not be set when Gap = circle.");
  if (contact.given("Eccentricity") && beside(contact))
    contact.reject("Eccentricity", "Eccentricity must not be set when Gap = beside.");
}

// c, and the distance of the centres along Direction.
std::pair<double, double> read_sizes(const Values &contact, double clearance) {
  if (!beside(contact)) {
    if (!(clearance > 0))
      contact.reject("Clearance", "Clearance must be greater than 0 m when Gap = circle.");
    return {clearance, contact.quantity("Eccentricity")};
  }
  contact.require("Radii");
  const double radii = contact.quantity("Radii");
  return {radii, radii + clearance};
}

} // namespace

void declare_circular_gap(parameters::Section &contact) {
  using namespace parameters;
  contact
      .choice(gap_key, "plane", {"plane", "circle", "beside"},
              "plane: the gap changes along Direction alone. circle: one side is a ring about the "
              "other, and Clearance is the radial one, c - |u| in every direction across Axis. "
              "beside: round sides next to each other along Direction, Clearance apart. Circular "
              "gaps need a law without a force where the gap is open.")
      .text("Axis", "",
            "Of a circular gap: the direction along which nothing changes, at a right angle to "
            "Direction.")
      .required("Gap is not plane")
      .quantity("Eccentricity", "0 m", dimension::length, range::any, "",
                "Of Gap = circle: how far the second side's centre lies from the first side's "
                "along Direction in the undeformed model.")
      .quantity("Radii", "", dimension::length, range::positive, "",
                "Of Gap = beside: the sum of both radii.")
      .required("Gap = beside");
}

bool has_circular_gap(const Values &contact) {
  if (contact.choice(gap_key) != "plane")
    return true;
  for (const char *key : {"Axis", "Eccentricity", "Radii"})
    if (contact.given(key))
      contact.reject(key, std::string(key) + " must not be set when Gap = plane.");
  return false;
}

void bend_gap(const Values &contact, const Meeting &meeting, const std::string &fixed,
              const model::Model &model, ContactPair &pair) {
  check_law(contact, *pair.law);
  check_surroundings(contact, model);
  const Vector3 axis = read_axis(contact, meeting.normal);
  const auto [clearance, distance] = read_sizes(contact, pair.clearance);
  model::Projection second = model::relative_displacement(
      meeting.a, meeting.b, fixed != model::side_base, axis.cross(meeting.normal), model);
  if (pair.gap.row.isZero(0) && second.row.isZero(0))
    contact.reject("Axis", "Axis must be an axis across which at least one of the two sides can "
                           "move.");
  pair.clearance = beside(contact) ? pair.clearance : clearance - std::abs(distance);
  pair.circle = std::make_shared<CircularGap>(
      beside(contact) ? CircularGap::Kind::beside : CircularGap::Kind::inside, clearance, axis,
      std::move(second), AcrossAxis{distance, 0},
      contact.subsection("Friction").quantity("Surface speed"));
}

} // namespace vibroimpact::contact
