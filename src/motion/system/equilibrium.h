// Static equilibrium of the whole model under given loads, contacts and cubic springs included.
#pragma once

#include "contact/contact_set.h"
#include "model/model.h"

#include <vector>

namespace vibroimpact::motion {

struct Equilibrium {
  Vector displacement;      ///< n; angles of rotors stay at zero
  std::vector<bool> closed; ///< per contact: the two sides overlap, or press if they are rigid
};

/// Where load - K q - cubic forces + contact forces = 0 with everything at rest at time 0. Newton's
/// method with the contacts' modes chosen anew in each iteration and steps halved until the
/// residual falls, from the straight position. Coordinates that nothing holds and nothing loads
/// stay at zero. Rigid contacts are held closed by the forces that this takes where they are >= 0;
/// which ones is found by pressing and letting go one after the other. NumericalError when nothing
/// balances the load or no equilibrium is found. load: n [N]
Equilibrium static_equilibrium(const model::Model &model, const contact::ContactSet &contacts,
                               const Vector &load);

} // namespace vibroimpact::motion
