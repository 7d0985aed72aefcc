// Energies and impulses of a step of a linear phase, by Gauss quadrature of their rates.
#pragma once

#include "motion/system/linear_system.h"

#include <array>

namespace vibroimpact::motion {

class WorkQuadrature {
public:
  static constexpr int points = 7;
  /// The rule integrates exp(e t) over h with the relative error error_factor |e h|^14:
  /// (7!)^4 / (15 (14!)^3).
  static constexpr double error_factor = 6.5e-20;

  explicit WorkQuadrature(const Equations &equations);

  /// The points of the rule from `start` on for a length h [s after the start of the step].
  static std::array<double, points> instants(double start, double h);

  /// Adds the integrals over a length h to the work integrals in `state`. `rows`: y, then s, s',
  /// s'' of each source, one column per point.
  void add(double h, const Matrix &rows, const LinearSystem::ConstraintForces &held, Vector &state);

private:
  void add_point(double weight, const Matrix &rows, Index point, Vector &state);
  double add_contacts(double weight, const double *y, Vector &state);
  double constraint_force(std::size_t contact, const double *y) const;
  double damping_power(ConstVectorView velocity);

  const Equations &equations_;
  const LinearSystem::ConstraintForces *held_ = nullptr; ///< during add()
  contact::LawResponse response_;
  Vector damping_;
};

} // namespace vibroimpact::motion
