// The stable periodic motion near a state of a settling motion, by Newton's method on the map P
// over one period of the forcing:
//
//   (I - J) d = P^k(x) - x,   x <- x + d,   J the derivative of P^k
//
// J is that of the first state as long as the steps with it shrink tenfold, since a period without
// derivative costs a fraction of one with it, and is made anew where they do not. A first step of
// more than a tenth of the motion, and steps that do not shrink to 0.3 of those before them
// (Deuflhard's natural test), may lead elsewhere: nothing is found then.
#pragma once

#include "motion/variation/linearised_motion.h"
#include "periodic/adapted_norm.h"

#include <optional>
#include <vector>

namespace vibroimpact::analyses {

/// Seen once in each period of the forcing.
struct SteadyOrbit {
  std::vector<Vector> states; ///< physical, of all periods until the motion repeats itself
  periodic::AdaptedNorm norm; ///< of scaled deviations from the first of them

  long multiple() const { return static_cast<long>(states.size()); }
};

class SteadyOrbitSearch {
public:
  /// Keeps references. `scale` makes states comparable and has no zeros. period [s]
  SteadyOrbitSearch(motion::Trajectory &trajectory, motion::Lineariser &lineariser,
                    const Vector &scale, double period)
      : trajectory_(trajectory), lineariser_(lineariser), scale_(scale), period_(period) {}

  static constexpr long most_periods = 14; ///< of a search, times the multiple

  struct Result {
    /// Of the motion that the search started from, after each further period that it has gone on
    /// for.
    std::vector<Vector> carried{};
    std::optional<SteadyOrbit> orbit{}; ///< stable, |mu| <= 1 - 1e-6
    long periods = 0;                   ///< that were computed, those of the motion included
  };
  /// From a physical state after so many periods, for a motion of at most `multiple` of them. The
  /// trajectory stands anywhere afterwards.
  Result run(const Vector &state, long cycle, long multiple);
  const Vector &scale() const { return scale_; }

private:
  std::vector<Vector> linearised(const Vector &state);
  std::vector<Vector> carried(const Vector &state);
  Vector newton_step(const Vector &residual) const;
  std::optional<Vector> converge(const Vector &state, const Vector &image);
  std::vector<Vector> states_from(const Vector &point);
  std::optional<SteadyOrbit> stable_orbit(const Vector &point);
  double size(const Vector &physical) const {
    return physical.cwiseProduct(scale_).cwiseAbs().maxCoeff();
  }

  motion::Trajectory &trajectory_;
  motion::Lineariser &lineariser_;
  const Vector &scale_;
  double period_;
  long multiple_ = 1;
  long cycle_ = 0;   ///< where motions begin [periods]
  long periods_ = 0; ///< computed
  Matrix by_state_;  ///< J, scaled
  double moved_ = 0; ///< since J was made, over the size of the motion
};

} // namespace vibroimpact::analyses
