// Forced oscillators with stops, for tests of periodic motions.
#pragma once

#include "contact/laws/bilinear_stop.h"
#include "periodic/orbit.h"
#include "support/rigid_contacts.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace vibroimpact::testing {

/// A model that outlives the forced system made of it.
struct Oscillator {
  model::Model model;
  contact::ContactSet contacts{};
  motion::Settings settings{.relative_tolerance = 1e-12, .event_tolerance = 1e-14};

  void push(double amplitude, double omega, double phase = 0) {
    model.add_force(
        "push" + std::to_string(model.sources().size()),
        std::make_shared<model::Harmonic>(model::Given::displacement, amplitude, omega, phase), {},
        Vector3::UnitX());
  }
  /// Stops at clearances to the right and to the left.
  void stop(std::vector<std::pair<double, std::shared_ptr<const contact::ContactLaw>>> right,
            std::vector<std::pair<double, std::shared_ptr<const contact::ContactLaw>>> left = {}) {
    std::vector<contact::ContactPair> pairs;
    for (auto &[clearance, law] : right)
      pairs.push_back(contact_along_x(model, "block.head", "", clearance, law));
    for (auto &[clearance, law] : left) {
      pairs.push_back(contact_along_x(model, "block.head", "", clearance, law));
      pairs.back().gap.row *= -1;
      for (double &coefficient : pairs.back().gap.base_coefficients)
        coefficient *= -1;
    }
    contacts = contact::ContactSet(std::move(pairs));
  }
};

inline Oscillator oscillator(double mass, double stiffness, double damping) {
  return {.model = model::Model({single_mass("block", mass, stiffness, damping)})};
}

/// y'' + 2 zeta0 y' + y + stop = f sin(lambda t), stops of stiffness mu and damping 2 zeta1 beyond
/// |y| = 1.
inline Oscillator isolator(double lambda, double mu = 2, double f = 0.52, double zeta0 = 0.01,
                           double zeta1 = 0.2) {
  Oscillator isolator = oscillator(1, 1, 2 * zeta0);
  isolator.push(f, lambda);
  const auto law = std::make_shared<contact::BilinearStop>(mu, 2 * zeta1);
  isolator.stop({{1.0, law}}, {{1.0, law}});
  return isolator;
}

/// Tangents as exact as they come, states with a scale of 1.
inline motion::VariationAccuracy unit_accuracy(Index size) {
  return {.scale = Vector::Ones(size), .tolerance = 1e-12};
}

/// The map of an oscillator, with its symmetry if it has one.
struct ForcedMap {
  explicit ForcedMap(const Oscillator &of, bool look_for_symmetry = true)
      : system(of.model, of.contacts, of.settings, 0),
        map(system, unit_accuracy(system.layout().physical_size()),
            look_for_symmetry ? periodic::Symmetry::find(
                                    system, Vector::Ones(system.layout().physical_size()), 2.0)
                              : std::nullopt) {}
  periodic::ForcedSystem system;
  periodic::StroboscopicMap map;
};

} // namespace vibroimpact::testing
