// The equations of motion for one combination of contact modes in which everything is linear:
//
//   y' = A y + b + sum over sources (l s + m s' + p s''),   y = [q, v, internal states]
#pragma once

#include "motion/system/equations.h"

#include <vector>

namespace vibroimpact::motion {

class LinearSystem {
public:
  /// For the present modes of the equations. std::logic_error when they are not linear.
  explicit LinearSystem(const Equations &equations);

  /// True when the model and the present modes of all contacts are linear.
  static bool holds(const Equations &equations);

  struct Load {
    Vector value, rate, acceleration; ///< size() entries each: what s, s', s'' are multiplied by
  };
  /// The forces of Equations::holding(), in its order: constants + rows * [y, then s, s', s'' of
  /// each source]
  struct ConstraintForces {
    Matrix rows;      ///< held directions x (size + 3 sources)
    Vector constants; ///< held directions
  };

  Index size() const { return matrix_.rows(); }
  const Vector &mass() const { return mass_; }
  const Matrix &matrix() const { return matrix_; }
  const Vector &constant() const { return constant_; }
  const std::vector<Load> &loads() const { return loads_; }
  const ConstraintForces &constraint_forces() const { return constraint_forces_; }
  /// Of the present modes, without the rest.
  static ConstraintForces constraint_forces(const Equations &equations);

  /// y and its first derivatives, one column of `rows` each, from the equations themselves; `rows`
  /// holds derivatives of y, then of s, s', s'' of each source, which must be filled in already,
  /// and y in column 0.
  void differentiate(Matrix &rows) const;

private:
  LinearSystem() = default;
  void assemble(const Equations &equations);
  void add_contact(const Equations &equations, std::size_t contact);
  void add_form(const Equations &equations, std::size_t contact, const contact::AffineForm &form,
                const Vector &into);
  void hold(const Equations &equations);

  Vector mass_;
  Matrix matrix_;
  Vector constant_;
  std::vector<Load> loads_;
  ConstraintForces constraint_forces_;
};

} // namespace vibroimpact::motion
