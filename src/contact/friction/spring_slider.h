// A spring in series with a slider (Jenkins 1962; Iwan 1966), with a dashpot beside the spring
// where its ringing is to die out:
//
//   stick  F = -k z - c z', z' = v, until |F| = mu N                 z  deformation of the spring
//   [m] slip   F = -sigma mu N; the slider moves at sigma (v - z') >= 0  v  slip rate [m/s]
//          c = 0:  z = sigma mu N / k, so that z' = sigma mu N' / k
//          c > 0:  c z' = sigma mu N - k z
//
// The slider's own speed ends the slip, not v, which has the elastic part in it.
#pragma once

#include "contact/friction/tangential_law.h"
#include "parameters/values.h"

#include <memory>

namespace vibroimpact::contact {

struct SpringSliderConstants {
  double stiffness = 0;        ///< > 0 [N/m]
  double coefficient = 0;      ///< > 0
  double damping_constant = 0; ///< >= 0 [N s/m]
};
SpringSliderConstants read_spring_slider(const parameters::Values &friction);

class SpringSlider : public TangentialLaw {
public:
  /// stiffness > 0 [N/m], coefficient > 0, damping_constant >= 0 [N s/m]
  SpringSlider(double stiffness, double coefficient, double damping_constant)
      : stiffness_(stiffness), coefficient_(coefficient), damping_constant_(damping_constant) {}

  static void declare(parameters::Section &friction);
  static std::shared_ptr<const TangentialLaw> create(const parameters::Values &friction);

  std::string name() const override { return "spring-slider"; }
  std::vector<TangentialMode> modes(const AffineForm &normal_force,
                                    std::size_t first_internal) const override;
  int mode_by_slip(int mode, const LocalState &state, std::size_t first_internal) const override;
  std::vector<InternalState> internal_states() const override;
  double stiffness() const override { return stiffness_; }
  double damping_constant() const override { return damping_constant_; }

private:
  bool follows_normal_rate() const { return damping_constant_ == 0; }
  TangentialMode slip(const std::string &name, double sigma, const AffineForm &normal_force,
                      const AffineForm &deformation) const;

  double stiffness_;
  double coefficient_;
  double damping_constant_;
};

} // namespace vibroimpact::contact
