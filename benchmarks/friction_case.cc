#include "cases.h"

#include "contact/friction/coulomb.h"
#include "contact/friction/frictional_law.h"
#include "contact/laws/constant_force.h"
#include "sides.h"

#include <limits>

namespace vibroimpact::benchmarks {

namespace {

using namespace model;

/// Unit mass on a unit spring with dry friction and a harmonic force (Den Hartog 1930), as one
/// would write it for a general solver. State: x, v.
struct RubbingMass {
  static constexpr std::size_t size = 2, contacts = 1;
  using State = std::array<double, size>;
  double limit = 0, forcing = 0, phase = 0;
  int slip = 0; ///< direction; 0: sticks
  std::array<long, contacts> begun{};
  long evaluations = 0;

  double omega() const { return forcing; }
  double highest_frequency() const { return std::max(forcing, 1.0); }
  bool is_touching(std::size_t /*i*/) const { return slip == 0; }
  double longest_step() const {
    return slip == 0 ? 0.25 / forcing : std::numeric_limits<double>::infinity();
  }
  double recorded(const State &x, double /*time*/) const { return x[0]; }
  double recorded_rate(const State &x, double /*time*/) const { return x[1]; }
  double pull(const State &x, double time) const { return std::sin(forcing * time + phase) - x[0]; }
  double guard(std::size_t /*i*/, const State &x, double time) const {
    return slip == 0 ? limit - std::abs(pull(x, time)) : slip * x[1];
  }
  void pass(std::size_t i, State &x, double time) {
    x[1] = 0;
    const double held = pull(x, time);
    const bool sticks = slip != 0 && std::abs(held) < limit;
    slip = sticks ? 0 : held > 0 ? 1 : -1;
    begun[i] += sticks;
  }
  void operator()(const State &x, State &dxdt, double time) {
    ++evaluations;
    dxdt[0] = x[1];
    dxdt[1] = slip == 0 ? 0 : pull(x, time) - slip * limit;
  }
};

Problem problem_of(const RubbingMass &system) {
  const Vector one = Vector::Ones(1);
  Model model({body_along_x("mass", one, one, Vector::Zero(1), one)});
  model.add_force("force",
                  std::make_shared<Harmonic>(Given::displacement, 1, system.forcing, system.phase),
                  {.body = 0, .point = 0}, Vector3::UnitX());
  contact::ContactPair ground =
      contact_of_heads(model, "mass", "", 1, 0,
                       std::make_shared<contact::FrictionalLaw>(
                           std::make_shared<contact::ConstantForce>(system.limit),
                           std::make_shared<contact::Coulomb>(1.0, 1.0)));
  ground.tangential.push_back({.slip = ground.gap});
  ground.gap.row.setZero();
  const Projection recorded = model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), false);
  return {
      .model = std::move(model), .contacts = contact::ContactSet({ground}), .recorded = recorded};
}

// From the steady motion on, at an instant at which the mass slips.
Case rubbing_mass(const std::string &name, RubbingMass system) {
  constexpr long settling = 300, periods = 100;
  const double period = 2 * std::numbers::pi / system.forcing;
  Problem problem = problem_of(system);
  const Vector state = settled(problem, period, settling);
  if (state[1] == 0)
    throw NumericalError(name + ": the motion would begin in stick");
  system.slip = state[1] > 0 ? 1 : -1;
  problem.end = static_cast<double>(periods) * period;
  return {.name = name,
          .length = 1,
          .periods = periods,
          .sides = {vibroimpact_side("exact", "exact", problem, state),
                    vibroimpact_side("rk (PETSc TS)", "rk", problem, state),
                    odeint_side(system, {state[0], state[1]}, problem.end, event_tolerance)},
          .baseline = 2,
          .references = {0, 2}};
}

} // namespace

Case friction_without_stops() {
  return rubbing_mass("friction, turns", {.limit = 0.4, .forcing = 1.2, .phase = 2.8});
}

Case friction_with_stops() {
  return rubbing_mass("friction, stops", {.limit = 0.6, .forcing = 0.6, .phase = 2.8});
}

} // namespace vibroimpact::benchmarks
