// All contacts of a model: where they are (projections of the motion), and which law each follows.
//
// gap = clearance + (u_b - u_a) . n, n pointing from side a to side b; a positive normal force
// pushes the two apart, so that it acts on the coordinates as gap_row^T force. Where the gap is not
// that of a plane, a CircularGap makes gap and slip of two projections.
#pragma once

#include "contact/circular_gap.h"
#include "contact/contact_law.h"
#include "model/model.h"
#include "parameters/values.h"

#include <memory>
#include <string>
#include <vector>

namespace vibroimpact::contact {

/// A direction in which the sides can slide on each other.
struct TangentialDirection {
  model::Projection slip;              ///< of u_b - u_a
  double surface_speed = 0;            ///< of side b along it, as of a belt [m/s]
  Vector3 direction = Vector3::Zero(); ///< t
};

/// One direction of a contact, the normal or a tangential one, or one across the axis of a circular
/// gap: position = offset + projection, its rate that of the projection + speed.
struct Direction {
  const model::Projection *projection = nullptr;
  double offset = 0; ///< [m]
  double speed = 0;  ///< [m/s]
};

struct ContactPair {
  std::string name;
  std::string side_a, side_b; ///< "body.point"; side_b is "stop" or "base" for a stop
  double clearance = 0;       ///< gap of the undeformed model [m]; negative is a prestress
  /// gap - clearance as a projection of the motion; of a circular gap u_1 - that of the centres.
  model::Projection gap;
  std::shared_ptr<const ContactLaw> law;
  bool accept_initial_penetration = false;
  std::string origin;        ///< where the parameter file declares it, for messages
  Index internal_offset = 0; ///< first internal state among those of all contacts
  std::string group{};       ///< the section whose pairing found it; empty for a contact by itself
  Vector3 normal = Vector3::Zero();              ///< n
  double least_flexibility_share = 0;            ///< below it the check of the kept modes warns
  double largest_impact_error = 0;               ///< above it too
  std::vector<TangentialDirection> tangential{}; ///< as many as the law sees
  Index sliding_place = -1;                      ///< among the contacts with tangential directions
  std::shared_ptr<const CircularGap> circle{};   ///< none: the gap is that of a plane

  int n_internal() const { return law->n_internal(); }
  /// All that the contact sees of the motion: directions 0, the normal, and 1, 2, which affine
  /// forms of the local state see; of a circular gap 0 and 1, those across its axis.
  int n_directions() const { return circle ? 2 : 1 + static_cast<int>(tangential.size()); }
  Direction along(int direction) const;
};

/// The contacts that a section with a pairing stands for, one behind the other.
struct ContactGroup {
  std::string name;
  std::size_t first = 0;    ///< position of its first contact
  std::size_t count = 0;    ///< contacts NAME.1, NAME.2, ...
  std::size_t unpaired = 0; ///< points of both sides that face none of the other
  std::size_t held = 0;     ///< pairs of points that cannot move, which are left out
};

class ContactSet {
public:
  ContactSet() = default;
  explicit ContactSet(std::vector<ContactPair> pairs, std::vector<ContactGroup> groups = {});

  const std::vector<ContactPair> &pairs() const { return pairs_; }
  std::size_t size() const { return pairs_.size(); }
  const std::vector<ContactGroup> &groups() const { return groups_; }
  /// Internal states of all contacts together, and their values before the first contact.
  Index n_internal() const { return n_internal_; }
  Vector initial_internal() const;
  /// Contacts with tangential directions.
  Index n_sliding() const { return n_sliding_; }
  /// Is there a circular gap among them?
  bool has_circles() const;
  /// Is there one with two tangential directions among them?
  bool has_planes() const;

  /// 1 / (row M^-1 row^T): the mass that meets at the contact along a direction [kg]; infinite
  /// where nothing can move.
  double effective_mass(std::size_t pair, const model::Model &model, int direction = 0) const;

private:
  std::vector<ContactPair> pairs_;
  std::vector<ContactGroup> groups_;
  Index n_internal_ = 0;
  Index n_sliding_ = 0;
};

void declare_contacts(parameters::Section &root);

/// The contacts that the sections `names` (instances of "Contact") stand for. Throws InputError for
/// unknown points and interfaces, pairings that find nothing, a negative clearance that is not
/// declared as prestress, and wrong laws.
ContactSet read_contacts(const parameters::Values &root, const std::vector<std::string> &names,
                         const model::Model &model);

} // namespace vibroimpact::contact
