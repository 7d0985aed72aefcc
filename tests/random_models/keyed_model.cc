#include "random_models/keyed_model.h"

#include "common/error.h"
#include "reduction/reduce_body.h"
#include "simulation.h"

#include <algorithm>

namespace vibroimpact::testing {

namespace {

constexpr const char *paths[] = {"Contact/k0/Clearance",
                                 "Contact/k0/Linear penalty/Stiffness",
                                 "Contact/k0/Kelvin-Voigt/Stiffness",
                                 "Contact/k0/Kelvin-Voigt/Damping constant",
                                 "Contact/k0/Kelvin-Voigt bumper/Stiffness",
                                 "Contact/k0/Kelvin-Voigt bumper/Damping constant",
                                 "Contact/k0/Bilinear stop/Damping constant",
                                 "Contact/k0/Hertz/Stiffness",
                                 "Contact/k0/Hunt-Crossley/Restitution coefficient",
                                 "Contact/k0/Hunt-Crossley/Stiffness",
                                 "Contact/k0/Tsuji/Damping coefficient",
                                 "Contact/k0/Kuwabara-Kono/Dissipation time",
                                 "Contact/k0/Newton restitution/Restitution coefficient",
                                 "Excitation/e0/Amplitude",
                                 "Excitation/e0/Frequency",
                                 "Excitation/e0/Ramp/Rate",
                                 "Excitation/e0/Impulse/Duration",
                                 "Connection/c0/Stiffness",
                                 "Connection/c0/Cubic stiffness",
                                 "Body/b/Mass m0/Mass",
                                 "Contact/f0/Linear penalty/Stiffness",
                                 "Contact/f0/Constant force/Force",
                                 "Contact/f0/Friction/Surface speed",
                                 "Contact/f0/Friction/Coulomb/Coefficient",
                                 "Contact/f0/Friction/Coulomb/Static coefficient",
                                 "Contact/f0/Friction/Spring-slider/Stiffness",
                                 "Contact/f0/Friction/Spring-slider/Coefficient",
                                 "Contact/f0/Friction/Spring-slider/Damping constant",
                                 "Contact/f0/Friction/Viscous/Damping constant"};

} // namespace

std::shared_ptr<const parameters::ParameterSet> KeyedModel::set(Overrides overrides) const {
  overrides.push_back({.path = "File folder", .value = folder_, .origin = "test"});
  return parameters::ParameterSet::parse(declare_parameters(), text_, "model.prm", false,
                                         overrides);
}

std::vector<std::shared_ptr<const reduction::ReducedBody>>
KeyedModel::reduce(const parameters::Values &root) const {
  std::vector<std::shared_ptr<const reduction::ReducedBody>> bodies;
  for (const std::string &name : root.instances("Body")) {
    auto body = std::make_shared<reduction::ReducedBody>(
        reduction::reduce_body(root.instance("Body", name), name, folder_, MPI_COMM_SELF));
    body->name = name;
    bodies.push_back(std::move(body));
  }
  return bodies;
}

// Bodies that no key changes are reduced once.
analyses::System KeyedModel::build(const Overrides &overrides) const {
  const auto parsed = set(overrides);
  const parameters::Values root = parsed->root();
  const bool change =
      std::any_of(overrides.begin(), overrides.end(),
                  [](const parameters::Override &one) { return one.path.starts_with("Body"); });
  if (!change && bodies_.empty())
    bodies_ = reduce(root);
  analyses::System system =
      analyses::build_system(root, root.instance("Analysis", "a"), change ? reduce(root) : bodies_);
  system.integration.relative_tolerance = tolerance_;
  return system;
}

std::vector<analyses::SweptParameter> KeyedModel::keys() const {
  std::vector<analyses::SweptParameter> keys;
  for (const char *path : paths)
    try {
      const auto number = set({})->number_at(path);
      if (number && number->value != 0)
        keys.push_back({.path = path, .unit = number->unit, .values = {number->value}});
    } catch (const InputError &) {
    }
  return keys;
}

} // namespace vibroimpact::testing
