// Coulomb friction along two directions, with stick. With the slip rate v,
//
//   stick  v = 0 by the force F, until |F| = mu_s N
//   slip   F = -mu N v / |v| - c v
//
// The direction of slip is not smooth where v goes to zero or comes from it: in the end it is that
// of what else accelerates the sides, which it approaches with a power of |v| that may be any.
// Below a small slip rate the force therefore keeps its direction w:
//
//   stopping  F = -mu N w / |w| - c v, w what v was where |v| fell below it, until w . v = 0
//   starting  the same, w against the force that held the sides, until |v| is twice as large
//
// With a constant acceleration a and deceleration f of friction alone, psi the angle between v and
// a where |v| = s, the stop comes s / (f - a cos psi) later instead of s (f + a cos psi) / (f^2 -
// a^2): they differ by s a^2 sin^2 psi / ((f - a cos psi)(f^2 - a^2)), and psi goes with s^(a / (f
// - a)).
#pragma once

#include "contact/friction/coulomb.h"

namespace vibroimpact::contact {

class PlanarCoulomb : public TangentialLaw {
public:
  explicit PlanarCoulomb(const CoulombConstants &constants) : constants_(constants) {}

  static std::shared_ptr<const TangentialLaw> create(const parameters::Values &friction);

  std::string name() const override { return "coulomb"; }
  int n_directions() const override { return 2; }
  std::vector<TangentialMode> modes(const AffineForm &normal_force,
                                    std::size_t first_internal) const override;
  int mode_by_slip(int mode, const LocalState &state, std::size_t first_internal) const override;
  void evaluate(int mode, const LocalState &state, std::size_t first_internal,
                TangentialValues &values) const override;
  std::vector<InternalState> internal_states() const override;

private:
  TangentialValue margin(int mode, const LocalState &state, const std::array<double, 2> &along,
                         std::size_t first_internal) const;

  CoulombConstants constants_;
};

} // namespace vibroimpact::contact
