// A spring in series with a slider along two directions, with a dashpot beside the spring where its
// ringing is to die out. With the slip rate v, the deformation z of the spring and what it pulls
// with, p = k z + c v where it sticks:
//
//   stick  F = -p, z' = v, until |p| = mu N
//   slip   F = -mu N e; the slider moves along e = F / |F| at the speed s
//          c = 0:  e = z / |z|,  z' = v - s e,  s = e . v - mu N' / k,  so that k |z| stays mu N
//          c > 0:  e = p / |p|,  z' = (mu N e - k z) / c,  s = (|p| - mu N) / c,  p = k z + c v
//
// until s falls to zero. Along one direction this is SpringSlider.
#pragma once

#include "contact/friction/spring_slider.h"

namespace vibroimpact::contact {

class PlanarSpringSlider : public TangentialLaw {
public:
  explicit PlanarSpringSlider(const SpringSliderConstants &constants) : constants_(constants) {}

  static std::shared_ptr<const TangentialLaw> create(const parameters::Values &friction);

  std::string name() const override { return "spring-slider"; }
  int n_directions() const override { return 2; }
  std::vector<TangentialMode> modes(const AffineForm &normal_force,
                                    std::size_t first_internal) const override;
  int mode_by_slip(int mode, const LocalState &state, std::size_t first_internal) const override;
  void leave(int mode, double normal_force, std::span<double> internal) const override;
  void evaluate(int mode, const LocalState &state, std::size_t first_internal,
                TangentialValues &values) const override;
  std::vector<InternalState> internal_states() const override;
  double stiffness() const override { return constants_.stiffness; }
  double damping_constant() const override { return constants_.damping_constant; }

private:
  struct Pull;
  bool follows_normal_rate() const { return constants_.damping_constant == 0; }
  Pull pull(const LocalState &state, std::size_t first_internal) const;
  void follow_normal_rate(const LocalState &state, const Pull &pull,
                          TangentialValues &values) const;
  void relax(const LocalState &state, const Pull &pull, TangentialValues &values) const;

  SpringSliderConstants constants_;
};

} // namespace vibroimpact::contact
