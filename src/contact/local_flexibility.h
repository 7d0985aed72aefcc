// How far the two sides of a contact give way to a static force, and how much of it the kept
// coordinates know.
#pragma once

#include "contact/contact_set.h"

#include <optional>

namespace vibroimpact::contact {

/// Static displacement along the normal per unit force between the sides, of both sides together
/// [m/N]. Rigid motions of free lumped masses do not count.
struct LocalFlexibility {
  double whole = 0; ///< of the bodies before reduction
  double kept = 0;  ///< of the coordinates kept

  double share() const { return kept / whole; }
};

/// Of two points, or of one and a fixed place. None where no side gives way, or where a side is a
/// meshed body that no support holds.
std::optional<LocalFlexibility> local_flexibility(const model::PointReference &a,
                                                  const std::optional<model::PointReference> &b,
                                                  const Vector3 &normal, const model::Model &model);
std::optional<LocalFlexibility> local_flexibility(const ContactPair &pair,
                                                  const model::Model &model);

} // namespace vibroimpact::contact
