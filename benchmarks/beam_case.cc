#include "beam_case.h"

#include "cantilever.h"
#include "cases.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/linear_penalty.h"
#include "contact/restitution_relation.h"
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

using Beams = ModalBeams<coordinates, modes_per_beam, HertzHeads>;

// Modes of the beam from `first` on, whose tip moves the gap by `sense`.
template <class Beams>
void set_modes(const CantileverModes &modes, std::size_t first, double sense, Beams &into) {
  for (std::size_t j = 0; j < static_cast<std::size_t>(modes.angular_frequency.size()); ++j) {
    const double omega = modes.angular_frequency[static_cast<Index>(j)];
    into.squared_frequency[first + j] = omega * omega;
    into.damping[first + j] = 2 * damping_ratio * omega;
    into.row[first + j] = sense * modes.tip_displacement[static_cast<Index>(j)];
  }
}

Beams by_hand(const CantileverModes &modes) {
  Beams pair;
  pair.clearance = 0.005;
  pair.law = {.hertz = 1.30696874e10,
              .dissipation = contact::dimensionless_damping("exact", 0.7) / approach_speed};
  pair.amplitude = 0.02;
  pair.forcing = 2 * std::numbers::pi * 3;
  set_modes(modes, 0, -1, pair);
  set_modes(modes, modes_per_beam, 1, pair);
  return pair;
}

std::shared_ptr<const reduction::ReducedBody> cantilever_body(const std::string &name,
                                                              const CantileverModes &modes) {
  return body_along_x(name, Vector::Ones(modes.angular_frequency.size()),
                      modes.angular_frequency.cwiseAbs2(),
                      2 * damping_ratio * modes.angular_frequency, modes.tip_displacement);
}

template <class Beams> void add_shaker(const Beams &beams, Model &model) {
  model.add_force(
      "shaker", std::make_shared<Harmonic>(Given::displacement, beams.amplitude, beams.forcing, 0),
      {.body = 0, .point = 0}, Vector3::UnitX());
}

Problem problem_of(Model model, contact::ContactPair heads) {
  contact::ContactSet contacts({std::move(heads)});
  const Projection recorded = model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), false);
  return {.model = std::move(model), .contacts = std::move(contacts), .recorded = recorded};
}

Problem problem_of(const Beams &pair, const CantileverModes &modes) {
  Model model({cantilever_body("left", modes), cantilever_body("right", modes)});
  add_shaker(pair, model);
  contact::ContactPair heads = contact_of_heads(
      model, "left", "right", 1, pair.clearance,
      contact::HuntCrossley::with_dissipation({.stiffness = pair.law.hertz}, pair.law.dissipation));
  return problem_of(std::move(model), std::move(heads));
}

Problem problem_of(const BeamOnStop &beam, const CantileverModes &modes) {
  Model model({cantilever_body("beam", modes)});
  add_shaker(beam, model);
  contact::ContactPair stop =
      contact_of_heads(model, "beam", "", 1, beam.clearance,
                       std::make_shared<contact::LinearPenalty>(beam.law.stiffness));
  return problem_of(std::move(model), std::move(stop));
}

} // namespace

Case beam_pair() {
  const CantileverModes modes = cantilever_modes(beam, modes_per_beam);
  const Beams pair = by_hand(modes);
  return case_of("two beams, 20 modes", problem_of(pair, modes), pair, pair.clearance, 200, 4);
}

BeamOnStopEquations beam_on_stop_equations() {
  const CantileverModes modes = cantilever_modes(beam, modes_on_stop);
  BeamOnStop system;
  system.clearance = 0.005;
  system.law.stiffness = 1e5;
  system.amplitude = 0.02;
  system.forcing = 2 * std::numbers::pi * 3;
  set_modes(modes, 0, -1, system);
  return {.problem = problem_of(system, modes), .system = system};
}

Case beam_on_stop() {
  BeamOnStopEquations beam = beam_on_stop_equations();
  return case_of("beam on a stop, 20 modes", std::move(beam.problem), beam.system,
                 beam.system.clearance, 200, 4);
}

} // namespace vibroimpact::benchmarks
