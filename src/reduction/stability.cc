#include "reduction/stability.h"

#include "modes/factorisation.h"
#include "modes/impulse_response.h"

#include <algorithm>

namespace vibroimpact::reduction {

namespace {

/// A shift below the eigenvalues of rigid motions, whatever rounding makes of these: a small
/// fraction of max K_ii / M_ii, which estimates the largest eigenvalue.
double below_rigid_motions(const structure::AssembledBody &body) {
  const Vector stiffness = modes::diagonal(body.stiffness.get());
  const Vector mass = modes::diagonal(body.mass.get());
  double largest = 0;
  for (Index i = 0; i < mass.size(); ++i)
    if (mass[i] > 0)
      largest = std::max(largest, stiffness[i] / mass[i]);
  return -1e-12 * largest;
}

} // namespace

void check_stability(const structure::AssembledBody &body) {
  if (!body.model.prestressed)
    return;
  const int unstable =
      modes::Factorisation(body.stiffness.get(), body.mass.get(), below_rigid_motions(body))
          .eigenvalues_below();
  if (unstable > 0)
    throw structure::DefinitionError(
        "Body", "", "",
        "must stand before it moves, but its Axial force is a compression beyond " +
            (unstable == 1 ? std::string("the first buckling load")
                           : std::to_string(unstable) + " buckling loads"));
}

} // namespace vibroimpact::reduction
