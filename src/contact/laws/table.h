// Force over penetration as a table: straight lines between its points, the last of which goes on.
//
//   F = f(u) + c u'            u  penetration [m], u' its rate [m/s]
//                              f  curve of the table [N], c damping constant [N s/m]
//
// Each segment is a mode, in which the law is affine, so that the motion is known in closed form.
// Where the dashpot would pull, the force is cut off until it pushes again, as of a Kelvin-Voigt
// stop, or it pulls, as of a bilinear stop. Stored energy: the area below the curve, lost where the
// force is cut off; dissipated power c u'^2. A free mass on a table without damping gives back all
// it had, and reaches the penetration at which that area is its kinetic energy.
#pragma once

#include "contact/contact_law.h"
#include "contact/laws/force_curve.h"
#include "parameters/values.h"

#include <memory>

namespace vibroimpact::contact {

class Table : public ContactLaw {
public:
  /// The curve begins at (0, 0) and does not fall below zero. damping_constant >= 0 [N s/m].
  Table(ForceCurve curve, double damping_constant, bool pulls);

  static void declare(parameters::Section &contact);
  /// This law, or a CrushableTable where an unloading stiffness is given.
  static std::shared_ptr<const ContactLaw> create(const parameters::Values &contact);

  std::string name() const override { return "table"; }
  int initial_mode(const LocalState &state) const override;
  void evaluate(int mode, const LocalState &state, LawResponse &response) const override;
  std::optional<ElasticForce> elastic_force() const override;
  bool may_pull() const override { return pulls_ && damping_constant_ > 0; }

private:
  ForceCurve curve_;
  double damping_constant_;
  bool pulls_;
};

} // namespace vibroimpact::contact
