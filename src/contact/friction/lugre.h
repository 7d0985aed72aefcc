// LuGre: the mean deflection z of bristles between the surfaces (Canudas de Wit, Olsson, Astrom &
// Lischinsky 1995):
//
//   F = -N (s0 z + s1 z' + s2 v)                      v  slip rate [m/s]
//   z' = v - s0 |v| z / g(v)                          z  deflection [m]
//   g(v) = mu_k + (mu_s - mu_k) exp(-(|v| / v_s)^n)   s0 [1/m], s1, s2 [s/m]
//
// The sides never stick but creep; in steady slip F = -sigma g N - s2 N v. |v| bends at v = 0, so
// that each direction is a mode. What friction takes is -F v: the little energy that bent bristles
// give back is counted when they do.
#pragma once

#include "contact/friction/stribeck.h"

namespace vibroimpact::contact {

struct LuGreConstants {
  StribeckConstants coefficient; ///< g
  double stiffness = 0;          ///< s0 > 0 [1/m]
  double damping = 0;            ///< s1 >= 0 [s/m]
  double viscous = 0;            ///< s2 >= 0 [s/m]
};

class LuGre : public TangentialLaw {
public:
  explicit LuGre(const LuGreConstants &constants) : constants_(constants) {}

  static void declare(parameters::Section &friction);
  static std::shared_ptr<const TangentialLaw> create(const parameters::Values &friction);

  std::string name() const override { return "lugre"; }
  std::vector<TangentialMode> modes(const AffineForm &normal_force,
                                    std::size_t first_internal) const override;
  int mode_by_slip(int mode, const LocalState &state, std::size_t first_internal) const override;
  std::vector<InternalState> internal_states() const override;
  void evaluate(int mode, const LocalState &state, std::size_t first_internal,
                TangentialValues &values) const override;

private:
  LuGreConstants constants_;
};

} // namespace vibroimpact::contact
