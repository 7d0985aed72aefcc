// Deviations in a linear phase, y' = A y + b + loads of the sources: exact to rounding.
//
// Deviations of the state obey d' = A d, d(h) = exp(A h) d(0), in the coordinates in which A is
// block-diagonal. Those by a key obey d' = A d + dA/dp y + ..., which with the sources' coordinates
// w, w' = G w, is the derivative of one exponential:
//
//   [y, w]' = M [y, w],   M = [A B; 0 G],   d[y, w](h) = exp(M h) d[y, w](0)
//                                               + int exp(M (h - s)) dM exp(M s) ds [y, w](0)
#pragma once

#include "motion/exact/excitation.h"
#include "motion/variation/key_tangent.h"

#include <optional>

namespace vibroimpact::motion {

/// The linear phase of one combination of contact modes.
class LinearFlow {
public:
  /// For the present modes of the equations, which are linear.
  explicit LinearFlow(const Equations &equations);

  /// exp(A h), physical_size() squared.
  Matrix propagator(double h) const;
  /// tr A [1/s]: the determinant of the propagator is exp(h tr A).
  double divergence() const { return system_.matrix().trace(); }

  /// What keys add to deviations that are zero at `time`, h later: physical_size() x keys. `state`
  /// is that of the motion at `time`. Nothing where a source has no closed form.
  std::optional<Matrix> forced(const Equations &equations, const std::vector<KeyTangent *> &keys,
                               double time, const Vector &state, double h);

private:
  Matrix input_matrix(const Excitation &excitation, const Matrix &generator) const;
  Matrix changed_inputs(const Excitation &excitation, const Matrix &generator,
                        const Matrix &generator_change,
                        const KeyTangent::LinearTangent &tangent) const;

  LinearSystem system_;
  ModalForm modal_;
  double radius_ = 0;                               ///< of the eigenvalues [1/s]
  std::vector<KeyTangent::LinearTangent> tangents_; ///< once asked for
};

} // namespace vibroimpact::motion
