// How far the two sides of a contact give way to a static force, and how much of it the kept
// coordinates know.
#pragma once

#include "contact/contact_set.h"

#include <optional>
#include <string>
#include <vector>

namespace vibroimpact {

/// Static displacement along the normal per unit force between the sides, of both sides together
/// [m/N]. Rigid motions of free lumped masses do not count.
struct LocalFlexibility {
  double whole = 0; ///< of the bodies before reduction
  double kept = 0;  ///< of the coordinates kept

  double share() const { return kept / whole; }
};

/// Of two points, or of one and a fixed place. None where no side gives way, or where a side is a
/// meshed body that no support holds.
std::optional<LocalFlexibility> local_flexibility(const PointReference &a,
                                                  const std::optional<PointReference> &b,
                                                  const Vector3 &normal, const Model &model);
std::optional<LocalFlexibility> local_flexibility(const ContactPair &pair, const Model &model);

/// What is told of a contact before any motion.
struct ContactFigures {
  std::string name;
  double clearance = 0;         ///< [m]
  double flexibility_share = 0; ///< of the kept coordinates; NaN where it is not known
  double least_share = 0;       ///< below it there is a warning
};

std::vector<ContactFigures> contact_figures(const ContactSet &contacts, const Model &model);

/// One sentence that names the contacts whose kept coordinates carry too little of the static
/// flexibility, with their shares; empty when there are none.
std::string truncation_warning(const std::vector<ContactFigures> &contacts);

} // namespace vibroimpact
