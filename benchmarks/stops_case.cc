#include "cases.h"

#include "contact/laws/hunt_crossley.h"
#include "nonlinear_equations.h"
#include "sides.h"

#include <numbers>

namespace vibroimpact::benchmarks {

namespace {

using namespace model;

// A beam whose ends are guided, so that cosines are its modes, on a soft spring, against a row of
// equal stops that it meets almost at once.
constexpr std::size_t beam_modes = 8;
constexpr double mass = 1, suspension = 2 * std::numbers::pi * 3; // [kg], [rad/s]
constexpr double first_bending = 2 * std::numbers::pi * 40;       // [rad/s]
constexpr double clearance = 2e-3, differences = 2e-6;            // [m]
constexpr double stiffness_of_all = 2e9, dissipation = 1;         // [N/m^1.5], [s/m]

// Of the mode k with unit modal mass at the share x of the length.
double shape(std::size_t k, double x) {
  return k == 0 ? 1 / std::sqrt(mass)
                : std::sqrt(2 / mass) * std::cos(static_cast<double>(k) * std::numbers::pi * x);
}

template <std::size_t count> BodyOnStops<beam_modes, count> by_hand() {
  BodyOnStops<beam_modes, count> system;
  for (std::size_t k = 0; k < beam_modes; ++k) {
    const double omega = k == 0 ? suspension : first_bending * static_cast<double>(k * k);
    system.squared_frequency[k] = omega * omega;
    system.damping[k] = 2 * 0.03 * omega;
    system.load[k] = shape(k, 0.4);
    for (std::size_t i = 0; i < count; ++i)
      system.row[i][k] = -shape(k, (static_cast<double>(i) + 0.5) / count);
  }
  for (std::size_t i = 0; i < count; ++i)
    system.clearance[i] = clearance + differences * static_cast<double>((7 * i) % count) / count;
  system.law = {.hertz = stiffness_of_all / count, .dissipation = dissipation};
  system.amplitude = 3;
  system.forcing = 2 * std::numbers::pi * 4;
  return system;
}

template <std::size_t count> Problem problem_of(const BodyOnStops<beam_modes, count> &system) {
  const auto vector = [](const std::array<double, beam_modes> &values) {
    return Vector(Eigen::Map<const Vector>(values.data(), beam_modes));
  };
  Model model({body_along_x("beam", Vector::Ones(beam_modes), vector(system.squared_frequency),
                            vector(system.damping), vector(system.load))});
  model.add_force(
      "shaker",
      std::make_shared<Harmonic>(Given::displacement, system.amplitude, system.forcing, 0),
      {.body = 0, .point = 0}, Vector3::UnitX());
  std::vector<contact::ContactPair> stops;
  for (std::size_t i = 0; i < count; ++i) {
    stops.push_back(contact_of_heads(model, "beam", "", 1, system.clearance[i],
                                     contact::HuntCrossley::with_dissipation(
                                         {.stiffness = system.law.hertz}, system.law.dissipation)));
    stops.back().name += " " + std::to_string(i);
    stops.back().gap.row = vector(system.row[i]).transpose();
  }
  contact::ContactSet contacts(std::move(stops));
  const Projection recorded = model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), false);
  return {.model = std::move(model), .contacts = std::move(contacts), .recorded = recorded};
}

template <std::size_t count> Case stops() {
  const auto system = by_hand<count>();
  return case_of("beam, " + std::to_string(count) + " at once", problem_of(system), system,
                 clearance, 20, 4);
}

} // namespace

Case one_stop() { return stops<1>(); }
Case two_stops() { return stops<2>(); }
Case four_stops() { return stops<4>(); }
Case eight_stops() { return stops<8>(); }
Case sixteen_stops() { return stops<16>(); }

} // namespace vibroimpact::benchmarks
