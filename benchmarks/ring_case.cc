#include "cases.h"

#include "contact/curved_gap_law.h"
#include "contact/friction/coulomb.h"
#include "contact/friction/frictional_law.h"
#include "contact/laws/hertz.h"
#include "contact/laws/linear_penalty.h"
#include "sides.h"

namespace vibroimpact::benchmarks {

namespace {

using namespace model;

/// Unit mass on unit springs within a ring about its axis, driven around an ellipse, as one would
/// write it for a general solver. State: x, y and their rates.
struct RotorInRing {
  static constexpr std::size_t size = 4, contacts = 1;
  using State = std::array<double, size>;
  double stiffness = 0, exponent = 1, friction = 0; ///< of the ring, F = stiffness u^exponent
  double amplitude = 0.8, forcing = 0.8, damping = 0.2;
  double phase = 1.8; ///< with which the motion begins in flight
  bool touches = false;
  std::array<long, contacts> begun{};
  long evaluations = 0;

  double omega() const { return forcing; }
  double highest_frequency() const { return std::max(forcing, 1.0); }
  bool is_touching(std::size_t /*i*/) const { return touches; }
  double recorded(const State &x, double /*time*/) const { return x[0]; }
  double recorded_rate(const State &x, double /*time*/) const { return x[2]; }
  double guard(std::size_t /*i*/, const State &x) const {
    return (touches ? -1 : 1) * (1 - std::hypot(x[0], x[1]));
  }
  void pass(std::size_t i, State & /*x*/) {
    touches = !touches;
    begun[i] += touches;
  }
  void operator()(const State &x, State &dxdt, double time) {
    ++evaluations;
    dxdt[0] = x[2];
    dxdt[1] = x[3];
    dxdt[2] = amplitude * std::cos(forcing * time + phase) - x[0] - damping * x[2];
    dxdt[3] = 0.5 * amplitude * std::sin(forcing * time + phase) - x[1] - damping * x[3];
    if (!touches)
      return;
    const double r = std::hypot(x[0], x[1]);
    const double normal = r > 1 ? stiffness * std::pow(r - 1, exponent) : 0;
    const double along = std::copysign(friction * normal, x[0] * x[3] - x[1] * x[2]);
    dxdt[2] -= (normal * x[0] - along * x[1]) / r;
    dxdt[3] -= (normal * x[1] + along * x[0]) / r;
  }
};

std::shared_ptr<const reduction::ReducedBody> rotor(double damping) {
  auto body = std::make_shared<reduction::ReducedBody>();
  body->name = "rotor";
  body->type = "lumped";
  body->mass = body->stiffness = Vector::Ones(2);
  body->damping = damping * Matrix::Identity(2, 2);
  body->base_participation = Matrix::Zero(2, 3);
  reduction::BodyPoint head{
      .name = "head", .position = Vector3::Zero(), .rows = Matrix::Zero(6, 2)};
  head.rows.topRows(2) = Matrix::Identity(2, 2);
  body->points.push_back(std::move(head));
  return body;
}

std::shared_ptr<const contact::ContactLaw> law_of(const RotorInRing &system) {
  std::shared_ptr<const contact::ContactLaw> normal;
  if (system.exponent == 1)
    normal = std::make_shared<contact::LinearPenalty>(system.stiffness);
  else
    normal = std::make_shared<contact::Hertz>(
        contact::HertzConstants{.stiffness = system.stiffness, .exponent = system.exponent});
  std::shared_ptr<const contact::ContactLaw> curved =
      std::make_shared<contact::CurvedGapLaw>(std::move(normal));
  if (system.friction == 0)
    return curved;
  return std::make_shared<contact::FrictionalLaw>(
      curved, std::make_shared<contact::Coulomb>(system.friction, system.friction));
}

Problem problem_of(const RotorInRing &system) {
  Model model({rotor(system.damping)});
  const auto drive = [&](const char *name, double size, double phase, const Vector3 &direction) {
    model.add_force(name,
                    std::make_shared<Harmonic>(Given::displacement, size, system.forcing, phase),
                    {.body = 0, .point = 0}, direction);
  };
  drive("along", system.amplitude, std::numbers::pi / 2 + system.phase, Vector3::UnitX());
  drive("across", 0.5 * system.amplitude, system.phase, Vector3::UnitY());
  const auto seen = [&](const Vector3 &direction) {
    Projection made = model.displacement({.body = 0, .point = 0}, direction, false);
    made.row *= -1;
    return made;
  };
  contact::ContactPair ring{.name = "ring",
                            .side_a = "rotor.head",
                            .side_b = "stop",
                            .clearance = 1,
                            .gap = seen(Vector3::UnitX()),
                            .law = law_of(system),
                            .origin = "benchmark"};
  const Projection second = seen(Vector3::UnitY());
  ring.circle = std::make_shared<contact::CircularGap>(
      contact::CircularGap::Kind::inside, 1, Vector3::UnitZ(), second, contact::AcrossAxis{}, 0);
  if (system.friction > 0)
    ring.tangential.push_back({.slip = second});
  const Projection recorded = model.displacement({.body = 0, .point = 0}, Vector3::UnitX(), false);
  return {.model = std::move(model), .contacts = contact::ContactSet({ring}), .recorded = recorded};
}

Case rotor_in_ring(const std::string &name, const RotorInRing &system) {
  constexpr long settling = 150, periods = 40;
  return case_of(name, problem_of(system), system, 1, settling, periods);
}

} // namespace

Case ring() { return rotor_in_ring("ring", {.stiffness = 50}); }

Case ring_with_friction() {
  return rotor_in_ring("ring, friction", {.stiffness = 50, .friction = 0.1});
}

Case hertz_ring() { return rotor_in_ring("Hertz ring", {.stiffness = 200, .exponent = 1.5}); }

Case hertz_ring_with_friction() {
  return rotor_in_ring("Hertz ring, friction",
                       {.stiffness = 200, .exponent = 1.5, .friction = 0.1});
}

} // namespace vibroimpact::benchmarks
