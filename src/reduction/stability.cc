#include "reduction/stability.h"

#include "modes/mode_search.h"

namespace vibroimpact::reduction {

namespace {

structure::DefinitionError error_of(const structure::AssembledBody &body, int unstable) {
  if (body.model.given)
    return {"Matrices", "", "Stiffness",
            "must be positive semidefinite, but has negative eigenvalues with the Mass: " +
                std::to_string(unstable)};
  return {"Body", "", "",
          "must stand before it moves, but its Axial force is a compression beyond " +
              (unstable == 1 ? std::string("the first buckling load")
                             : std::to_string(unstable) + " buckling loads")};
}

} // namespace

// The shift of the search lies below the eigenvalues of rigid motions, whatever rounding makes of
// these.
void check_stability(const structure::AssembledBody &body, const modes::EigenProblem &problem) {
  if (!body.model.prestressed && !body.model.given)
    return;
  modes::ModeSearch search(problem);
  if (const int unstable = search.count_below(search.shift()); unstable > 0)
    throw error_of(body, unstable);
}

} // namespace vibroimpact::reduction
