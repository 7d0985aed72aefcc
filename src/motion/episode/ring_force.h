// The force of a contact in a circular gap, as a vector in the frame of the touch
// (forced_motion.h).
//
// In that frame u = (-(s c + w_0), w_1), and with r = |u| the penetration
//
//   s (r - c) = s (2 s c w_0 + w_0^2 + w_1^2) / (r + c)
//
// has no terms that cancel. The normal turns within the law, not within the system.
#pragma once

#include "contact/contact_set.h"
#include "motion/episode/contact_force.h"

namespace vibroimpact::motion {

class RingForce : public LawForce {
public:
  /// Keeps a reference.
  RingForce(const contact::ContactPair &pair, int mode);

  int n_directions() const override { return 2; }
  void evaluate(int count, const Motions &at, ForceValues &values) const override;
  Overlap overlap(const Motions &at, int instant) const override;
  contact::LocalState local(const Motions &at, int instant) const override;

private:
  contact::CircularFrame frame(const Motions &at, int instant) const;
  contact::LocalState local(const contact::CircularFrame &frame, const Motions &at,
                            int instant) const;
  void set_derivatives(const contact::CircularFrame &frame, int instant, ForceValues &values) const;

  const contact::CircularGap &circle_;
};

} // namespace vibroimpact::motion
