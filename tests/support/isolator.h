// The isolator with two elastic stops, as a system and as what builds it at other values of keys.
#pragma once

#include "analyses/analysis.h"
#include "contact/laws/bilinear_stop.h"
#include "support/recorded_windows.h"

namespace vibroimpact::testing {

/// x'' + 0.02 x' + x = f sin(lambda t), with stops of stiffness mu and damping 0.4 at |x| = 1.
inline analyses::System isolator_system(double lambda, double mu, double f = 0.52) {
  model::Model model({single_mass("block", 1, 1, 0.02)});
  model.add_force("push",
                  std::make_shared<model::Harmonic>(model::Given::displacement, f, lambda, 0), {},
                  Vector3::UnitX());
  const auto law = std::make_shared<contact::BilinearStop>(mu, 0.4);
  contact::ContactPair right = contact_along_x(model, "block.head", "", 1, law);
  contact::ContactPair left = right;
  right.name = "right";
  left.name = "left";
  left.gap.row *= -1;
  return system_of(std::move(model), contact::ContactSet({right, left}));
}

/// Keeps the one point of an analysis of isolators, whose keys are "f" and the stiffness.
class IsolatorPoint : public analyses::LineContext {
public:
  explicit IsolatorPoint(double lambda) : lambda_(lambda) {}
  const PointResult *find(const std::vector<std::size_t> & /*index*/) const override {
    return nullptr;
  }
  void store(PointResult stored) override { result = std::move(stored); }
  void skip() override {}
  analyses::System build(const std::vector<parameters::Override> &overrides) const override {
    double mu = 2, f = 0.52;
    for (const parameters::Override &one : overrides)
      (one.path == "f" ? f : mu) = std::stod(one.value);
    return isolator_system(lambda_, mu, f);
  }

  PointResult result;

private:
  double lambda_;
};

} // namespace vibroimpact::testing
