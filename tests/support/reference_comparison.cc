#include "support/reference_comparison.h"

#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kuwabara_kono.h"
#include "contact/laws/tsuji.h"
#include "model/piecewise_function.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::testing {

namespace {

using namespace model;

std::shared_ptr<const TimeFunction> function_of(const ReferenceHarmonic &source) {
  if (source.frequency == 0)
    return make_constant(Given::displacement, source.amplitude * std::sin(source.phase));
  return std::make_shared<Harmonic>(Given::displacement, source.amplitude, source.frequency,
                                    source.phase);
}

// Coordinates from..to-1, each with a point that it alone moves.
std::shared_ptr<const reduction::ReducedBody> body(const ReferenceSystem &system, std::size_t from,
                                                   std::size_t to) {
  auto body = std::make_shared<reduction::ReducedBody>();
  const auto n = static_cast<Index>(to - from);
  body->name = "body" + std::to_string(from);
  body->type = "lumped";
  body->mass = Eigen::Map<const Vector>(system.mass.data() + from, n);
  body->stiffness = Eigen::Map<const Vector>(system.stiffness.data() + from, n);
  body->damping = Eigen::Map<const Vector>(system.damping.data() + from, n).asDiagonal();
  body->base_participation = Matrix::Zero(n, 3);
  body->base_participation.col(0) = body->mass;
  body->total_mass = Vector3(body->mass.sum(), 0, 0);
  for (Index j = 0; j < n; ++j) {
    Matrix rows = Matrix::Zero(6, n);
    rows(0, j) = 1;
    body->points.push_back(
        {.name = "p" + std::to_string(j), .position = Vector3::Zero(), .rows = rows});
  }
  return body;
}

RowVector row_of(const std::vector<double> &row) {
  return Eigen::Map<const RowVector>(row.data(), static_cast<Index>(row.size()));
}

Model model_of(const ReferenceSystem &system) {
  std::vector<std::shared_ptr<const reduction::ReducedBody>> bodies;
  const std::size_t n = system.mass.size();
  for (std::size_t i = 0; i < n; i += system.one_body ? n : 1)
    bodies.push_back(body(system, i, system.one_body ? n : i + 1));
  Model model(bodies);
  std::vector<std::size_t> all(bodies.size());
  for (std::size_t b = 0; b < all.size(); ++b)
    all[b] = b;
  if (system.base)
    model.add_base_motion("base", function_of(*system.base), all, Vector3::UnitX());
  for (std::size_t i = 0; i < system.forces.size(); ++i)
    if (system.forces[i])
      model.add_force("force" + std::to_string(i), function_of(*system.forces[i]),
                      {.body = system.one_body ? 0 : i, .point = system.one_body ? i : 0},
                      Vector3::UnitX());
  for (const ReferenceSpring &spring : system.springs)
    model.add_connection(
        {.name = "spring",
         .side_a = bodies.front()->name + ".p0",
         .side_b = bodies.back()->name + ".p0",
         .elongation = {.row = row_of(spring.row),
                        .base_coefficients = std::vector<double>(model.sources().size(), 0)},
         .stiffness = spring.stiffness,
         .cubic_stiffness = spring.cubic,
         .damping = spring.damping});
  return model;
}

std::shared_ptr<const contact::ContactLaw> law_of(const ReferenceLaw &law) {
  using Kind = ReferenceLaw::Kind;
  if (law.kind == Kind::kuwabara_kono)
    return std::make_shared<contact::KuwabaraKono>(law.stiffness, law.damping);
  if (law.kind == Kind::tsuji)
    return std::make_shared<contact::Tsuji>(law.stiffness, law.damping);
  const contact::HertzConstants constants{.stiffness = law.stiffness, .exponent = law.exponent};
  if (law.damping == 0)
    return std::make_shared<contact::Hertz>(constants);
  return contact::HuntCrossley::with_dissipation(constants, law.damping);
}

contact::ContactSet contacts_of(const ReferenceSystem &system, const Model &model) {
  std::vector<contact::ContactPair> pairs;
  for (const ReferenceContact &contact : system.contacts) {
    Projection gap{.row = row_of(contact.row),
                   .base_coefficients = std::vector<double>(model.sources().size(), 0)};
    if (contact.by_base != 0)
      gap.base_coefficients[0] = contact.by_base;
    pairs.push_back({.name = "contact" + std::to_string(pairs.size()),
                     .side_a = model.bodies().front()->name + ".p0",
                     .side_b = "stop",
                     .clearance = contact.clearance,
                     .gap = gap,
                     .law = law_of(contact.law),
                     .origin = "test"});
  }
  return contact::ContactSet(pairs);
}

double relative(Real value, Real truth, Real scale) {
  return static_cast<double>(std::abs(value - truth) / scale);
}

double relative(const Vector &values, const Reals &truth, const Reals &largest) {
  const Real most = *std::max_element(largest.begin(), largest.end());
  double worst = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    worst = std::max(worst, relative(values[static_cast<Index>(i)], truth[i],
                                     std::max(largest[i], 1e-3L * most)));
  return worst;
}

// `mass` meets at the contact.
void include(const motion::Impact &impact, const ReferenceImpact &truth, double mass,
             MotionError &error) {
  const Real energy = mass * truth.approach_speed * truth.approach_speed / 2;
  error.instant = std::max({error.instant, relative(impact.start_time, truth.start, truth.duration),
                            relative(impact.duration, truth.duration, truth.duration)});
  error.impulse =
      std::max({error.impulse, relative(impact.impulse, truth.impulse, truth.impulse),
                relative(impact.separation_speed, truth.separation_speed, truth.approach_speed)});
  error.energy =
      std::max(error.energy, relative(impact.dissipated_energy, truth.dissipated, energy));
  error.deepest =
      std::max(error.deepest, relative(impact.maximum_penetration, truth.deepest, truth.deepest));
}

} // namespace

ProgramMotion program_motion(const ReferenceSystem &system, const ReferenceStart &start, double end,
                             double tolerance, const std::string &method) {
  const Model model = model_of(system);
  const contact::ContactSet contacts = contacts_of(system, model);
  motion::Settings settings;
  settings.method = method;
  settings.relative_tolerance = tolerance;
  settings.event_tolerance = 1e-16;
  motion::Trajectory trajectory(model, contacts, settings);
  motion::ImpactLog log(contacts, 0);
  trajectory.start(0, Eigen::Map<const Vector>(start.displacement.data(), model.size()),
                   Eigen::Map<const Vector>(start.velocity.data(), model.size()));
  trajectory.advance(end, log);
  ProgramMotion motion{.displacement = trajectory.state().head(model.size()),
                       .velocity = trajectory.state().segment(model.size(), model.size()),
                       .impacts = {},
                       .accuracy = trajectory.accuracy()};
  for (std::size_t c = 0; c < contacts.size(); ++c)
    motion.impacts.push_back(log.impacts(c));
  return motion;
}

double MotionError::largest() const { return std::max({state, instant, impulse}); }

MotionError compare(const ProgramMotion &motion, const ReferenceSystem &system,
                    const ReferenceResult &reference) {
  MotionError error;
  error.state = std::max(
      relative(motion.displacement, reference.displacement, reference.largest_displacement),
      relative(motion.velocity, reference.velocity, reference.largest_velocity));
  for (std::size_t c = 0; c < reference.impacts.size(); ++c) {
    if (motion.impacts[c].size() != reference.impacts[c].size()) {
      error.same_contacts = false;
      continue;
    }
    double flexibility = 0;
    for (std::size_t i = 0; i < system.mass.size(); ++i)
      flexibility += std::pow(system.contacts[c].row[i], 2) / system.mass[i];
    for (std::size_t i = 0; i < reference.impacts[c].size(); ++i)
      include(motion.impacts[c][i], reference.impacts[c][i], 1 / flexibility, error);
  }
  return error;
}

double amplification(const ReferenceSystem &system, const ReferenceStart &start, double end) {
  constexpr double relative_change = 1e-9;
  const ReferenceResult reference = reference_motion(system, start, end);
  const Real speed =
      *std::max_element(reference.largest_velocity.begin(), reference.largest_velocity.end());
  double worst = 1;
  for (std::size_t j = 0; j < system.mass.size(); ++j) {
    ReferenceStart beside = start;
    beside.velocity[j] += relative_change * static_cast<double>(speed);
    const ReferenceResult changed = reference_motion(system, beside, end);
    for (std::size_t i = 0; i < system.mass.size(); ++i)
      worst = std::max({worst,
                        relative(changed.velocity[i], reference.velocity[i],
                                 relative_change * reference.largest_velocity[i]),
                        relative(changed.displacement[i], reference.displacement[i],
                                 relative_change * reference.largest_displacement[i])});
  }
  return worst;
}

} // namespace vibroimpact::testing
