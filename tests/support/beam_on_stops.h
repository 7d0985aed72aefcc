// A beam above a row of stops, by any method: the case of the tests of moment steps.
#pragma once

#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/linear_penalty.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "support/lumped_models.h"

#include <cmath>
#include <numbers>

namespace vibroimpact::testing {

/// A free-free beam on a soft spring whose modes are cosines, above a row of equal stops.
struct BeamOnStops {
  int modes = 8, stops = 1;
  std::shared_ptr<const contact::ContactLaw> law;
  double duration = 0.3;
  bool shaken = false; ///< the base moves instead of a force
  double push = 3;     ///< amplitude of the force [N]

  std::shared_ptr<const reduction::ReducedBody> body() const {
    auto beam = std::make_shared<reduction::ReducedBody>();
    beam->name = "beam";
    beam->type = "lumped";
    beam->mass = Vector::Ones(modes);
    beam->stiffness.resize(modes);
    beam->damping = Matrix::Zero(modes, modes);
    beam->base_participation = Matrix::Zero(modes, 3);
    beam->base_participation(0, 0) = 1;
    beam->total_mass = Vector3(1, 0, 0);
    Matrix rows = Matrix::Zero(6, modes);
    for (int k = 0; k < modes; ++k) {
      const double omega = k == 0 ? 6 * std::numbers::pi : 80 * std::numbers::pi * k * k;
      beam->stiffness[k] = omega * omega;
      beam->damping(k, k) = 0.06 * omega;
      rows(0, k) = shape(k, 0.4);
    }
    beam->points.push_back({.name = "head", .position = Vector3::Zero(), .rows = rows});
    return beam;
  }
  static double shape(int k, double x) {
    return k == 0 ? 1 : std::sqrt(2.0) * std::cos(k * std::numbers::pi * x);
  }
  model::Model model() const {
    model::Model result({body()});
    const auto source = std::make_shared<model::Harmonic>(
        model::Given::displacement, shaken ? 3e-3 : push, 8 * std::numbers::pi, 0);
    if (shaken)
      result.add_base_motion("table", source, {0}, Vector3::UnitX());
    else
      result.add_force("shaker", source, {.body = 0, .point = 0}, Vector3::UnitX());
    return result;
  }
  contact::ContactSet contacts(const model::Model &of) const {
    std::vector<contact::ContactPair> pairs;
    for (int i = 0; i < stops; ++i) {
      pairs.push_back(contact_along_x(of, "beam.head", "", 2e-3 + 2e-6 * ((7 * i) % stops), law));
      pairs.back().name = "stop " + std::to_string(i);
      for (int k = 0; k < modes; ++k)
        pairs.back().gap.row[k] = -shape(k, (i + 0.5) / stops);
    }
    return contact::ContactSet(std::move(pairs));
  }
};

struct Seen {
  Vector state;
  std::vector<motion::Impact> impacts;
  motion::Accuracy accuracy;
};

/// instants: those of the largest forces are wanted, which only steps tell.
inline Seen move(const BeamOnStops &system, const std::string &method, double tolerance,
                 bool observed = true, bool instants = false) {
  const model::Model model = system.model();
  const contact::ContactSet contacts = system.contacts(model);
  motion::Settings settings;
  settings.method = method;
  settings.relative_tolerance = tolerance;
  motion::Trajectory trajectory(model, contacts, settings);
  trajectory.start(0, Vector::Zero(model.size()), Vector::Zero(model.size()));
  motion::ImpactLog log(contacts, 0, instants);
  if (observed)
    trajectory.advance(system.duration, log);
  else
    trajectory.advance(system.duration);
  return {.state = trajectory.state().head(2 * model.size()),
          .impacts = log.impacts(0),
          .accuracy = trajectory.accuracy()};
}

inline double energy_difference(const BeamOnStops &system, const Vector &a, const Vector &b) {
  const auto body = system.body();
  const auto norm = [&](const Vector &x) {
    const auto q = x.head(system.modes), v = x.tail(system.modes);
    return std::sqrt(q.cwiseAbs2().dot(body->stiffness) + v.squaredNorm());
  };
  return norm(a - b) / norm(b);
}

/// Laws of equal stops, whose stiffness is shared out.
struct StopLaw {
  const char *name;
  double order; ///< of steps over its kinks
  bool linear;
  std::shared_ptr<const contact::ContactLaw> (*make)(int stops);
};

inline std::vector<StopLaw> stop_laws() {
  using Law = std::shared_ptr<const contact::ContactLaw>;
  return {{"Linear", 4, true,
           [](int stops) -> Law { return std::make_shared<contact::LinearPenalty>(2e6 / stops); }},
          {"KelvinVoigt", 3, true,
           [](int stops) -> Law {
             return std::make_shared<contact::KelvinVoigt>(2e6 / stops, 200.0 / stops);
           }},
          {"Hertz", 4.5, false,
           [](int stops) -> Law {
             return std::make_shared<contact::Hertz>(
                 contact::HertzConstants{.stiffness = 2e9 / stops});
           }},
          {"HuntCrossley", 4.5, false, [](int stops) -> Law {
             return contact::HuntCrossley::with_dissipation({.stiffness = 2e9 / stops}, 1);
           }}};
}

} // namespace vibroimpact::testing
