// Coulomb's friction with true stick, and a static coefficient that may be larger than the kinetic
// one (Den Hartog 1930; Shaw 1986):
//
//   slip   F = -sigma mu N - c v, sigma the sign of the slip rate v, until v = 0
//   stick  v = 0, held by a force F, until |F| = mu_s N
#pragma once

#include "contact/friction/tangential_law.h"
#include "parameters/values.h"

#include <memory>

namespace vibroimpact::contact {

struct CoulombConstants {
  double coefficient = 0;        ///< mu > 0
  double static_coefficient = 0; ///< mu_s >= mu
  double damping_constant = 0;   ///< c >= 0 [N s/m]
};
CoulombConstants read_coulomb(const parameters::Values &friction);

class Coulomb : public TangentialLaw {
public:
  /// 0 < coefficient <= static_coefficient, damping_constant >= 0 [N s/m]
  Coulomb(double coefficient, double static_coefficient, double damping_constant = 0)
      : coefficient_(coefficient), static_coefficient_(static_coefficient),
        damping_constant_(damping_constant) {}

  static void declare(parameters::Section &friction);
  static std::shared_ptr<const TangentialLaw> create(const parameters::Values &friction);

  std::string name() const override { return "coulomb"; }
  std::vector<TangentialMode> modes(const AffineForm &normal_force,
                                    std::size_t first_internal) const override;
  int mode_by_slip(int mode, const LocalState &state, std::size_t first_internal) const override;
  std::optional<Coefficients> coefficients() const override;

private:
  double coefficient_;
  double static_coefficient_;
  double damping_constant_;
};

} // namespace vibroimpact::contact
