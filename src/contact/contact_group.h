// A contact section with a pairing: which points of which interfaces touch, and what clearance the
// undeformed geometry leaves between them.
#pragma once

#include "contact/contact_set.h"

#include <optional>

namespace vibroimpact::contact {

/// Two points that a section brings together, or one and a fixed place.
struct Meeting {
  model::PointReference a{};
  std::optional<model::PointReference> b{};
  Vector3 normal = Vector3::Zero();
  double clearance = 0; ///< [m]
};

struct Meetings {
  std::string fixed; ///< "stop" or "base" where the second side is no body
  std::vector<Meeting> list;
  std::size_t unpaired = 0; ///< points of both sides that face none of the other
};

/// Declares the keys of the pairing in a contact section.
void declare_pairing(parameters::Section &contact);

/// Of a section with another Pairing than `points`. Throws InputError when nothing is found, when
/// the interfaces do not fit, and for sides that overlap without being declared as prestressed.
Meetings find_meetings(const parameters::Values &contact, const model::Model &model);

/// Throws InputError for a key of the pairing in a section with Pairing = points.
void refuse_pairing_keys(const parameters::Values &contact);

} // namespace vibroimpact::contact
