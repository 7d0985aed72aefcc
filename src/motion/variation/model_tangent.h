// The derivative by a key of the numbers that a model and its gaps are made of.
//
// At a fixed state forces are linear in these numbers, but for the cubic springs, and
//
//   M a = F   =>   M da/dp = dF/dp - dM/dp a
//
// Differences of whole forces would lose what their largest terms leave of digits in every
// evaluation; these derivatives are taken once, and what a key does not change stays zero.
#pragma once

#include "contact/contact_set.h"
#include "model/model.h"
#include "motion/system/equations.h"

#include <vector>

namespace vibroimpact::motion {

/// A neighbouring model, with its weight in the derivative.
struct WeightedModel {
  const model::Model *model = nullptr;
  const contact::ContactSet *contacts = nullptr;
  double weight = 0;
};

/// Of a direction of a contact (contact::Direction).
struct DirectionTangent {
  double offset = 0;
  double speed = 0;
  model::Projection projection;
};

/// Of a circular gap (contact::CircularGap).
struct CircleTangent {
  double clearance = 0;
  double surface_speed = 0;
};

class ModelTangent {
public:
  /// Keeps a reference to the model. Of models with the same structure; none: nothing changes.
  ModelTangent(const model::Model &model, const contact::ContactSet &contacts,
               const std::vector<WeightedModel> &neighbours);

  const DirectionTangent &along(std::size_t contact, int direction) const {
    return directions_[contact][static_cast<std::size_t>(direction)];
  }

  /// Zero of a plane gap.
  const CircleTangent &circle(std::size_t contact) const { return circles_[contact]; }

  /// What the accelerations at a fixed state, fixed values of the sources and fixed contact forces
  /// [N] change by, as a force: dF/dp - dM/dp a. Rotors are left out.
  Vector force(ConstVectorView q, ConstVectorView velocity, ConstVectorView acceleration,
               const std::vector<SourceValues> &sources, const Vector &contact_forces) const;

private:
  struct Loads {
    Vector load, rate_load, inertial_load;
  };
  /// k3 (row q + base_coefficients s)^3 row
  struct CubicSpring {
    std::size_t connection = 0;
    double stiffness = 0; ///< derivative
    model::Projection elongation;
  };
  void take_loads(const std::vector<WeightedModel> &neighbours);
  void take_springs(const std::vector<WeightedModel> &neighbours);
  void take_circles(const contact::ContactSet &contacts,
                    const std::vector<WeightedModel> &neighbours);
  void take_directions(const contact::ContactSet &contacts,
                       const std::vector<WeightedModel> &neighbours);
  Vector cubic_forces(ConstVectorView q, const std::vector<SourceValues> &sources) const;

  const model::Model &model_;
  Vector mass_;
  Matrix stiffness_, damping_; ///< 0 x 0: unchanged
  std::vector<Loads> loads_;   ///< per source
  std::vector<CubicSpring> springs_;
  std::vector<std::vector<DirectionTangent>> directions_; ///< per contact
  std::vector<CircleTangent> circles_;                    ///< per contact
};

} // namespace vibroimpact::motion
