#include "motion/system/decayed_states.h"

#include <cmath>

namespace vibroimpact::motion {

namespace {

// Does it change with nothing but internal states?
bool recovers(const contact::Mode &mode, std::size_t i) {
  if (mode.in_contact || !mode.affine || i >= mode.affine->internal_rate.size())
    return false;
  const contact::AffineForm &rate = mode.affine->internal_rate[i];
  return rate.constant == 0 && rate.gap == 0 && rate.gap_rate == 0 && rate.normal_force == 0;
}

} // namespace

bool clear_decayed(const Equations &equations, double time, Vector &state) {
  constexpr double lost = 0x1p-10; // part of the rounding of a gap, which counts every operation
  bool cleared = false;
  for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
    const contact::ContactPair &pair = equations.contacts().pairs()[c];
    for (int i = 0; i < pair.n_internal(); ++i) {
      const auto place = static_cast<std::size_t>(i);
      double &z = state[equations.layout().internal() + pair.internal_offset + i];
      if (z != 0 && recovers(equations.mode(c), place) &&
          std::abs(z) <= lost * equations.rounding(c, {.gap = 1}, time, state) &&
          pair.law->internal_states()[place].unit == "m") {
        z = 0;
        cleared = true;
      }
    }
  }
  return cleared;
}

} // namespace vibroimpact::motion
