// Masses that slide along x under constant normal forces, for tests.
#pragma once

#include "contact/friction/coulomb.h"
#include "contact/friction/frictional_law.h"
#include "contact/laws/constant_force.h"
#include "motion/path/trajectory.h"
#include "support/rigid_contacts.h"

#include <memory>
#include <string>
#include <vector>

namespace vibroimpact::testing {

inline std::shared_ptr<const contact::ContactLaw>
constant_with(double normal_force, std::shared_ptr<const contact::TangentialLaw> tangential) {
  return std::make_shared<contact::FrictionalLaw>(
      std::make_shared<contact::ConstantForce>(normal_force), std::move(tangential));
}

inline std::shared_ptr<const contact::ContactLaw> coulomb(double normal_force, double coefficient,
                                                          double static_coefficient) {
  return constant_with(normal_force,
                       std::make_shared<contact::Coulomb>(coefficient, static_coefficient));
}

/// Two points, or a point and the ground, that slide along x; the normal is across it, and nothing
/// moves there.
inline contact::ContactPair sliding_along_x(const model::Model &model, const std::string &side_a,
                                            const std::string &side_b,
                                            std::shared_ptr<const contact::ContactLaw> law,
                                            double surface_speed = 0) {
  contact::ContactPair pair = contact_along_x(model, side_a, side_b, 0, std::move(law));
  pair.tangential.push_back({.slip = pair.gap, .surface_speed = surface_speed});
  pair.gap.row.setZero();
  for (double &coefficient : pair.gap.base_coefficients)
    coefficient = 0;
  return pair;
}

/// A mass with the coordinates x and y, on a spring along x or free; its only point is called
/// "head".
inline std::shared_ptr<const reduction::ReducedBody> particle(const std::string &name, double mass,
                                                              double spring = 0) {
  auto body = std::make_shared<reduction::ReducedBody>();
  body->name = name;
  body->type = "lumped";
  body->mass = Vector::Constant(2, mass);
  body->stiffness = Vector::Zero(2);
  body->stiffness[0] = spring;
  body->damping = Matrix::Zero(2, 2);
  body->base_participation = Matrix::Zero(2, 3);
  body->base_participation(0, 0) = body->base_participation(1, 1) = mass;
  body->total_mass = Vector3::Constant(mass);
  Matrix rows = Matrix::Zero(6, 2);
  rows(0, 0) = rows(1, 1) = 1;
  body->points.push_back({.name = "head", .position = Vector3::Zero(), .rows = rows});
  return body;
}

/// Of a point and the ground: the normal along y, friction along x.
inline contact::ContactPair oblique_contact(const model::Model &model, const std::string &side,
                                            double clearance,
                                            std::shared_ptr<const contact::ContactLaw> law) {
  contact::ContactPair pair = contact_along_x(model, side, "", clearance, std::move(law));
  pair.tangential.push_back({.slip = pair.gap});
  model::PointReference point;
  model.find_point(side, point);
  const model::Projection across = model.displacement(point, Vector3::UnitY(), true);
  pair.gap.row = -across.row;
  for (std::size_t k = 0; k < across.base_coefficients.size(); ++k)
    pair.gap.base_coefficients[k] = -across.base_coefficients[k];
  return pair;
}

/// Contact changes with the state at each.
class Changes : public motion::Observer {
public:
  struct Change {
    double time = 0;
    std::size_t contact = 0;
    std::string from, to; ///< names of modes
    Vector state;
  };
  explicit Changes(const contact::ContactSet &contacts) : contacts_(contacts) {}
  void step(const motion::StepView & /*view*/) override {}
  void event(const motion::ContactEvent &event) override {
    const auto name = [&](int mode) {
      const std::string full =
          contacts_.pairs()[event.contact].law->modes()[static_cast<std::size_t>(mode)].name;
      const std::size_t comma = full.find(", ");
      return comma == std::string::npos ? full : full.substr(comma + 2);
    };
    list.push_back({event.time, event.contact, name(event.from), name(event.to), *event.state});
  }
  std::vector<Change> list;

private:
  const contact::ContactSet &contacts_;
};

} // namespace vibroimpact::testing
