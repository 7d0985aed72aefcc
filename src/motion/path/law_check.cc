#include "motion/path/law_check.h"

#include "common/error.h"

#include <string>

namespace vibroimpact::motion {

void check_laws(const Equations &equations, double time, const Vector &state) {
  const ConstVectorView x(state.data(), state.size());
  for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
    if (equations.mode(c).affine)
      continue;
    const contact::ContactPair &pair = equations.contacts().pairs()[c];
    const std::string objection =
        pair.law->objection(equations.modes()[c], equations.local_state(c, time, x));
    if (!objection.empty())
      throw NumericalError("the force of contact " + pair.name + " " + objection +
                           " at t = " + std::to_string(time) + " s");
  }
}

} // namespace vibroimpact::motion
