#include "cases.h"

#include "cantilever.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/restitution_relation.h"
#include "equations_by_hand.h"
#include "sides.h"

namespace vibroimpact::benchmarks {

namespace {

using namespace model;

// The impacting beams of the validation: steel, 0.3 m x 30 mm x 0.75 mm, heads that tune the first
// mode to 2.95 Hz and touch as two steel spheres of radius 15 mm.
constexpr Cantilever beam{.length = 0.3,
                          .bending = 0.217265625,
                          .mass_per_length = 0.176625,
                          .tip_mass = 1.0891503 * 0.0529875};
constexpr int modes_per_beam = 10;
constexpr std::size_t coordinates = 2 * modes_per_beam;
constexpr double damping_ratio = 0.02;
constexpr double approach_speed = 0.2; // at which the restitution coefficient is 0.7 [m/s]

using Beams = ModalPair<coordinates>;

Beams by_hand(const CantileverModes &modes) {
  Beams pair;
  pair.clearance = 0.005;
  pair.hertz = 1.30696874e10;
  pair.dissipation = contact::dimensionless_damping("exact", 0.7) / approach_speed;
  pair.amplitude = 0.02;
  pair.forcing = 2 * std::numbers::pi * 3;
  for (std::size_t j = 0; j < coordinates; ++j) {
    const auto mode = static_cast<Index>(j % modes_per_beam);
    const double omega = modes.angular_frequency[mode];
    pair.squared_frequency[j] = omega * omega;
    pair.damping[j] = 2 * damping_ratio * omega;
    pair.row[j] = (j < modes_per_beam ? -1 : 1) * modes.tip_displacement[mode];
  }
  return pair;
}

Problem problem_of(const Beams &pair, const CantileverModes &modes) {
  const Vector unit = Vector::Ones(modes_per_beam);
  const Vector stiffness = modes.angular_frequency.cwiseAbs2();
  const Vector damping = 2 * damping_ratio * modes.angular_frequency;
  Model model({body_along_x("left", unit, stiffness, damping, modes.tip_displacement),
               body_along_x("right", unit, stiffness, damping, modes.tip_displacement)});
  model.add_force("shaker",
                  std::make_shared<Harmonic>(Given::displacement, pair.amplitude, pair.forcing, 0),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  contact::ContactSet contacts({contact_of_heads(
      model, "left", "right", 1, pair.clearance,
      contact::HuntCrossley::with_dissipation({.stiffness = pair.hertz}, pair.dissipation))});
  const Projection recorded = model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), false);
  return {.model = std::move(model), .contacts = std::move(contacts), .recorded = recorded};
}

} // namespace

Case beam_pair() {
  const CantileverModes modes = cantilever_modes(beam, modes_per_beam);
  const Beams pair = by_hand(modes);
  return case_of("two beams, 20 modes", problem_of(pair, modes), pair, pair.clearance, 200, 4);
}

} // namespace vibroimpact::benchmarks
