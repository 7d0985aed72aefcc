#include "contact/contact_group.h"

#include "contact/pairing.h"
#include "model/direction.h"
#include "model/side.h"
#include "parameters/text.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace vibroimpact::contact {

namespace {

using model::Model;
using parameters::Values;

constexpr const char *interface_form = "interfaces as BODY.INTERFACE, BODY.INTERFACE";

/// The points of an interface and where they are.
struct GroupSide {
  std::string name; ///< "body.interface"
  std::vector<model::PointReference> points;
  std::vector<Vector3> positions;
};

std::vector<std::string> interface_names(const Model &model) {
  std::vector<std::string> names;
  for (const auto &body : model.bodies())
    for (const reduction::BodyPoint &point : body->points)
      if (const std::string name = body->name + "." + point.interface;
          !point.interface.empty() && std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
  return names;
}

GroupSide side_of(const std::string &name, const Model &model) {
  GroupSide side{.name = name, .points = {}, .positions = {}};
  for (std::size_t b = 0; b < model.bodies().size(); ++b)
    for (std::size_t p = 0; p < model.bodies()[b]->points.size(); ++p)
      if (const reduction::BodyPoint &point = model.bodies()[b]->points[p];
          !point.interface.empty() && name == model.bodies()[b]->name + "." + point.interface) {
        side.points.push_back({.body = b, .point = p});
        side.positions.push_back(point.position);
      }
  return side;
}

std::string at(const Vector3 &position) {
  std::ostringstream text;
  text << "(" << position[0] << ", " << position[1] << ", " << position[2] << ") m";
  return text.str();
}

std::string length(double value) {
  std::ostringstream text;
  text << value << " m";
  return text.str();
}

void refuse(const Values &contact, const std::vector<const char *> &keys) {
  for (const char *key : keys)
    if (contact.given(key))
      contact.reject(key, std::string(key) +
                              " must not be set when Pairing = " + contact.choice("Pairing") + ".");
}

bool joining(const Values &contact) { return contact.choice("Normal") == "joining line"; }

PairSearch read_search(const Values &contact) {
  contact.require("Search radius");
  PairSearch search{.radius = contact.quantity("Search radius"), .joining = joining(contact)};
  if (!search.joining)
    search.direction = model::read_direction(contact, "Direction");
  if (contact.has("Reach") && search.joining)
    contact.reject(
        "Reach", "Reach must not be set when Normal = joining line, where Search radius bounds the "
                 "whole distance.");
  if (contact.has("Reach"))
    search.reach = contact.quantity("Reach");
  return search;
}

/// What to say when nothing is within the search.
[[noreturn]] void reject_search(const Values &contact, const GroupSide &a, const GroupSide &b,
                                const PairSearch &search) {
  double least = std::numeric_limits<double>::infinity();
  NodePair nearest{};
  for (std::size_t i = 0; i < a.positions.size(); ++i)
    for (std::size_t j = 0; j < b.positions.size(); ++j)
      if (const double distance = (b.positions[j] - a.positions[i]).norm(); distance < least) {
        least = distance;
        nearest = {i, j};
      }
  const Vector3 apart = b.positions[nearest[1]] - a.positions[nearest[0]];
  std::string text = "must be large enough to find a pair of " + a.name + " and " + b.name +
                     ", of which the nearest nodes, at " + at(a.positions[nearest[0]]) + " and " +
                     at(b.positions[nearest[1]]) + ", are " + length(least) + " apart";
  if (!search.joining) {
    const double along = apart.dot(search.direction);
    text += ": " + length((apart - along * search.direction).norm()) +
            " across the direction and " + length(along) + " along it";
  }
  contact.reject("Search radius", text + ".");
}

std::vector<NodePair> pairs_in_order(const Values &contact, const GroupSide &a,
                                     const GroupSide &b) {
  if (a.points.size() != b.points.size())
    contact.reject(
        "Between",
        "must be two interfaces with equal numbers of nodes when Pairing = list and Pairs "
        "is not given, but " +
            a.name + " has " + std::to_string(a.points.size()) + " and " + b.name + " has " +
            std::to_string(b.points.size()) + ".");
  std::vector<NodePair> pairs;
  for (std::size_t i = 0; i < a.points.size(); ++i)
    pairs.push_back({i, i});
  return pairs;
}

std::size_t node_of(const Values &contact, double number, const GroupSide &side) {
  if (number != std::floor(number) || number > static_cast<double>(side.points.size()))
    contact.reject("Pairs", "must be whole numbers of nodes; " + side.name +
                                " has the nodes 1 to " + std::to_string(side.points.size()) +
                                ", but one is " + parameters::number_text(number) + ".");
  return static_cast<std::size_t>(number) - 1;
}

std::vector<NodePair> given_pairs(const Values &contact, const GroupSide &a, const GroupSide &b) {
  const std::vector<double> numbers = contact.quantities("Pairs");
  if (numbers.size() % 2 != 0)
    contact.reject("Pairs", "must be two numbers for each pair, but are " +
                                std::to_string(numbers.size()) + " numbers.");
  std::vector<NodePair> pairs;
  std::set<NodePair> known;
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    pairs.push_back({node_of(contact, numbers[i], a), node_of(contact, numbers[i + 1], b)});
    if (!known.insert(pairs.back()).second)
      contact.reject("Pairs", "must hold each pair once, but " +
                                  parameters::number_text(numbers[i]) + ", " +
                                  parameters::number_text(numbers[i + 1]) + " stands there twice.");
  }
  return pairs;
}

/// Nodes of a side that stand in no pair.
std::size_t alone(const GroupSide &side, const std::vector<NodePair> &pairs, std::size_t which) {
  std::set<std::size_t> paired;
  for (const NodePair &pair : pairs)
    paired.insert(pair[which]);
  return side.points.size() - paired.size();
}

// Where the sides touch at rest, the coordinates of the meshes may say otherwise by their rounding.
double without_rounding(double clearance, const Vector3 &position) {
  constexpr double rounding = 1e-12;
  return std::abs(clearance) <= rounding * position.norm() ? 0 : clearance;
}

double clearance_between(const Values &contact, const Vector3 &a, const Vector3 &b,
                         const Vector3 &normal) {
  if (contact.has("Clearance"))
    return contact.quantity("Clearance");
  const double clearance =
      without_rounding((b - a).dot(normal) - contact.quantity("Offset"), a + b);
  if (clearance < 0 && !contact.boolean("Prestressed"))
    contact.reject("Between", "must be sides that do not overlap, but the nodes at " + at(a) +
                                  " and " + at(b) + " begin with a clearance of " +
                                  length(clearance) +
                                  " (Direction points from the first side to the second, Offset is "
                                  "subtracted); if a prestress is meant, it needs Prestressed = "
                                  "true.");
  return clearance;
}

Meeting meeting_of(const Values &contact, const GroupSide &a, const GroupSide &b,
                   const NodePair &pair) {
  const Vector3 &from = a.positions[pair[0]];
  const Vector3 &to = b.positions[pair[1]];
  Meeting meeting{.a = a.points[pair[0]], .b = b.points[pair[1]]};
  const bool same = meeting.a.body == meeting.b->body && from == to;
  if (same || (joining(contact) && from == to))
    contact.reject("Between", "must be two interfaces that share no place" +
                                  std::string(same ? "" : " with Normal = joining line") +
                                  "; both have a node at " + at(from) + ".");
  meeting.normal =
      joining(contact) ? (to - from).normalized() : model::read_direction(contact, "Direction");
  meeting.clearance = clearance_between(contact, from, to, meeting.normal);
  return meeting;
}

Meetings between_interfaces(const Values &contact, const Model &model) {
  if (contact.has("Clearance") && contact.given("Offset"))
    contact.reject(
        "Offset",
        "Offset must not be set when Clearance is given, which then counts for all pairs.");
  if (contact.given("Direction") && joining(contact))
    contact.reject("Direction", "Direction must not be set when Normal = joining line.");
  const model::Sides sides = model::read_sides(contact, {}, interface_names(model), interface_form);
  const GroupSide a = side_of(sides.a, model);
  const GroupSide b = side_of(sides.b, model);
  std::vector<NodePair> pairs;
  if (contact.choice("Pairing") == "list") {
    refuse(contact, {"Search radius", "Reach"});
    pairs = contact.has("Pairs") ? given_pairs(contact, a, b) : pairs_in_order(contact, a, b);
  } else {
    refuse(contact, {"Pairs"});
    const PairSearch search = read_search(contact);
    pairs = facing_pairs(a.positions, b.positions, search);
    if (pairs.empty())
      reject_search(contact, a, b, search);
  }
  Meetings meetings{.fixed = "", .list = {}, .unpaired = alone(a, pairs, 0) + alone(b, pairs, 1)};
  for (const NodePair &pair : pairs)
    meetings.list.push_back(meeting_of(contact, a, b, pair));
  return meetings;
}

Meetings with_stops(const Values &contact, const Model &model) {
  refuse(contact, {"Search radius", "Reach", "Normal", "Offset", "Pairs"});
  contact.require("Clearance");
  const model::Sides sides = model::read_sides(contact, {model::side_stop, model::side_base},
                                               interface_names(model), interface_form);
  if (sides.b != model::side_stop && sides.b != model::side_base)
    contact.reject("Between", "must be an interface and stop or base when Pairing = stops");
  Meetings meetings{.fixed = sides.b, .list = {}};
  for (const model::PointReference &point : side_of(sides.a, model).points)
    meetings.list.push_back({.a = point,
                             .b = std::nullopt,
                             .normal = model::read_direction(contact, "Direction"),
                             .clearance = contact.quantity("Clearance")});
  return meetings;
}

} // namespace

void declare_pairing(parameters::Section &contact) {
  using namespace parameters;
  contact
      .choice(
          "Pairing", "points", {"points", "proximity", "stops", "list"},
          "points: one contact of the two sides of Between. The others make one contact, called "
          "NAME.1, NAME.2..., of each pair of nodes of interfaces of bodies (BODY.INTERFACE in "
          "Between). proximity: two nodes that are each other's nearest, so that a node stands "
          "in one pair at most; stops: each node of an interface against stop or base; list: "
          "the nodes of two interfaces in their order, or as Pairs says.")
      .quantity("Search radius", "", dimension::length, range::positive, "",
                "Of a pairing by proximity: largest distance of two nodes across the direction, or "
                "with Normal = joining line their largest distance.")
      .required("Pairing = proximity")
      .quantity("Reach", "", dimension::length, range::positive, "",
                "Of a pairing by proximity: largest distance along the direction. Without it: any.")
      .quantities(
          "Pairs", "", dimension::none, Range{.lower = 1}, "",
          "Of a pairing by list: numbers of a node of the first and of one of the second "
          "interface, two for each pair; node 3 is INTERFACE.3. A node may stand in several "
          "pairs. A long list can stand in a file of its own, read by include.",
          2, std::numeric_limits<int>::max())
      .choice("Normal", "direction", {"direction", "joining line"},
              "Contact normal of a pair of two interfaces: Direction, or the line from its first "
              "node to its second.")
      .quantity("Offset", "0 m", dimension::length, range::any, "",
                "Subtracted from the distance of two nodes along the normal, which gives the "
                "clearance of "
                "a pair without the key Clearance: half the thickness of both shells.");
}

void refuse_pairing_keys(const parameters::Values &contact) {
  refuse(contact, {"Search radius", "Reach", "Normal", "Offset", "Pairs"});
}

Meetings find_meetings(const parameters::Values &contact, const Model &model) {
  return contact.choice("Pairing") == "stops" ? with_stops(contact, model)
                                              : between_interfaces(contact, model);
}

} // namespace vibroimpact::contact
