#include "motion/system/tolerances.h"

#include <algorithm>
#include <limits>

namespace vibroimpact::motion {

// A tolerance in metres at the points becomes one for the coordinates of a body by the largest
// displacement that a unit coordinate gives at a point, the same for all of them: a mode the points
// hardly see still holds energy.
Vector absolute_tolerances(const Equations &equations, double tolerance) {
  const StateLayout &layout = equations.layout();
  const model::Model &model = equations.model();
  Vector absolute = Vector::Constant(layout.size(), std::numeric_limits<double>::max() / 16);
  // Where nothing oscillates, a second is as good as any scale.
  const double highest = model.highest_frequency() > 0 ? model.highest_frequency() : 1;
  for (std::size_t b = 0; b < model.bodies().size(); ++b) {
    const reduction::ReducedBody &body = *model.bodies()[b];
    const Vector omega = body.omega();
    double reach = 0;
    for (const reduction::BodyPoint &point : body.points)
      reach = std::max(reach, point.rows.topRows(3).cwiseAbs().maxCoeff());
    const double of_coordinates = tolerance / (reach > 0 ? reach : 1);
    for (Index j = 0; j < body.size(); ++j) {
      absolute[model.offset(b) + j] = of_coordinates;
      absolute[layout.velocity() + model.offset(b) + j] =
          of_coordinates * (omega[j] > 0 ? omega[j] : highest);
    }
  }
  absolute.segment(layout.internal(), layout.n_internal).setConstant(tolerance);
  // A motor's torque counts by the metre per starting torque, as an angle counts as a length.
  for (const model::Rotor &rotor : model.rotors().list())
    if (rotor.motor)
      absolute[layout.drive() + rotor.motor->drive] =
          tolerance * std::max(1.0, std::abs(rotor.motor->starting_torque));
  return absolute;
}

} // namespace vibroimpact::motion
