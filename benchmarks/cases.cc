#include "cases.h"

#include "cantilever.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/linear_penalty.h"
#include "contact/restitution_relation.h"
#include "equations_by_hand.h"
#include "odeint_side.h"
#include "vibroimpact_side.h"

#include <numbers>

namespace vibroimpact::benchmarks {

namespace {

constexpr double event_tolerance = 1e-12; // the program's default

template <class Stop>
Problem problem_of(const ForcedMass<Stop> &system, double end,
                   const std::shared_ptr<const ContactLaw> &law) {
  const auto one = [](double value) { return Vector::Constant(1, value); };
  Model model(
      {body_along_x("mass", one(system.mass), one(system.stiffness), one(system.damping), one(1))});
  model.add_force(
      "force", std::make_shared<Harmonic>(Given::displacement, system.amplitude, system.omega, 0),
      {.body = 0, .point = 0}, Vector3::UnitX());
  ContactSet contacts({contact_of_heads(model, "mass", "", system.clearance, law)});
  return {.model = std::move(model),
          .contacts = std::move(contacts),
          .displacement = one(0),
          .velocity = one(0),
          .end = end,
          .event_tolerance = event_tolerance};
}

template <class Stop>
Case forced_mass(const std::string &name, const ForcedMass<Stop> &system, double periods,
                 const std::shared_ptr<const ContactLaw> &law) {
  const double end = periods * 2 * std::numbers::pi / system.omega;
  return {.name = name,
          .length = system.clearance,
          .weight = (Vector(2) << system.stiffness, system.mass).finished(),
          .vibroimpact = vibroimpact_side(problem_of(system, end, law)),
          .odeint = odeint_side(system, {0, 0}, end, event_tolerance)};
}

// 1 kg at 10 Hz, 5 % damped, driven at 11 Hz so that it would swing to about five clearances.
template <class Stop> ForcedMass<Stop> mass_against(const Stop &stop) {
  const double natural = 2 * std::numbers::pi * 10;
  return {.mass = 1,
          .stiffness = natural * natural,
          .damping = 2 * 0.05 * natural,
          .amplitude = 4,
          .omega = 1.1 * natural,
          .clearance = 1e-3,
          .stop = stop};
}

} // namespace

Case forced_mass_on_linear_stop() {
  const LinearStop stop{.stiffness = 4e5};
  return forced_mass("mass, linear stop", mass_against(stop), 100,
                     std::make_shared<LinearPenalty>(stop.stiffness));
}

Case forced_mass_on_hertz_stop() {
  const HertzStop stop{.stiffness = 1e9, .dissipation = dimensionless_damping("exact", 0.7) / 0.2};
  return forced_mass("mass, Hertz stop", mass_against(stop), 100,
                     HuntCrossley::with_dissipation({.stiffness = stop.stiffness, .exponent = 1.5},
                                                    stop.dissipation));
}

namespace {

// The impacting beams of the validation: steel, 0.3 m x 30 mm x 0.75 mm, heads that tune the first
// mode to 2.95 Hz and touch as two steel spheres of radius 15 mm.
constexpr Cantilever beam{.length = 0.3,
                          .bending = 0.217265625,
                          .mass_per_length = 0.176625,
                          .tip_mass = 1.0891503 * 0.0529875};
constexpr int modes_per_beam = 10;
constexpr std::size_t coordinates = 2 * modes_per_beam;
constexpr double clearance = 0.005;
constexpr double tip_displacement = 0.0275;
constexpr double beams_end = 0.6;

HertzStop heads() {
  return {.stiffness = 1.30696874e10, .dissipation = dimensionless_damping("exact", 0.7)};
}

ModalPair<coordinates> beams_by_hand(const CantileverModes &modes) {
  ModalPair<coordinates> pair;
  pair.clearance = clearance;
  pair.stop = heads();
  for (std::size_t j = 0; j < coordinates; ++j) {
    const auto mode = static_cast<Index>(j % modes_per_beam);
    pair.squared_frequency[j] = std::pow(modes.angular_frequency[mode], 2);
    pair.row[j] = (j < modes_per_beam ? -1 : 1) * modes.tip_displacement[mode];
  }
  return pair;
}

// Static shape of a force at the tip, away from the other beam.
ModalPair<coordinates>::State released(const ModalPair<coordinates> &pair) {
  ModalPair<coordinates>::State x{};
  double compliance = 0;
  for (std::size_t j = 0; j < modes_per_beam; ++j)
    compliance += pair.row[j] * pair.row[j] / pair.squared_frequency[j];
  for (std::size_t j = 0; j < coordinates; ++j)
    x[j] = tip_displacement / compliance * pair.row[j] / pair.squared_frequency[j];
  return x;
}

Problem beams(const CantileverModes &modes, const Vector &displacement) {
  const Vector unit = Vector::Ones(modes_per_beam);
  const Vector zero = Vector::Zero(modes_per_beam);
  const Vector stiffness = modes.angular_frequency.cwiseAbs2();
  Model model({body_along_x("a", unit, stiffness, zero, modes.tip_displacement),
               body_along_x("b", unit, stiffness, zero, modes.tip_displacement)});
  const HertzStop stop = heads();
  ContactSet contacts(
      {contact_of_heads(model, "a", "b", clearance,
                        HuntCrossley::with_dissipation(
                            {.stiffness = stop.stiffness, .exponent = 1.5}, stop.dissipation))});
  return {.model = std::move(model),
          .contacts = std::move(contacts),
          .displacement = displacement,
          .velocity = Vector::Zero(coordinates),
          .end = beams_end,
          .event_tolerance = event_tolerance};
}

} // namespace

Case released_beams() {
  const CantileverModes modes = cantilever_modes(beam, modes_per_beam);
  const ModalPair<coordinates> pair = beams_by_hand(modes);
  const auto x = released(pair);
  const Vector displacement = Eigen::Map<const Vector>(x.data(), coordinates);
  Vector weight = Vector::Ones(2 * coordinates);
  weight.head(coordinates) = Eigen::Map<const Vector>(pair.squared_frequency.data(), coordinates);
  return {.name = "two beams, 20 modes",
          .length = clearance,
          .weight = weight,
          .vibroimpact = vibroimpact_side(beams(modes, displacement)),
          .odeint = odeint_side(pair, x, beams_end, event_tolerance)};
}

} // namespace vibroimpact::benchmarks
