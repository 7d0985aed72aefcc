// The equations of motion for one combination of contact modes in which everything is linear:
//
//   y' = A y + b + sum over sources (l s + m s' + p s''),   y = [q, v, internal states]
#pragma once

#include "motion/system/equations.h"

#include <utility>
#include <vector>

namespace vibroimpact::motion {

/// constant + row * [y, then s, s', s'' of each source]
struct LinearRow {
  RowVector row; ///< physical size + 3 sources
  double constant = 0;
};

/// What a form of the local state of a contact has of positions, rates and internal states.
LinearRow row_of_motion(const Equations &equations, std::size_t contact,
                        const contact::AffineForm &form);

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
  /// Of the present modes, whether they are linear or not: then with the laws of the contacts and
  /// the springs of the model made linear at a state. Gradients are right, constants are not.
  static LinearSystem tangent(const Equations &equations, double time, const Vector &state);
  /// Of the present modes, without the test that they are linear.
  static LinearSystem of_modes(const Equations &equations);

  /// The time derivative of a row, which must have no s''.
  LinearRow derivative(const LinearRow &row) const;
  /// A form of the local state of a contact, with the forces that it sees.
  LinearRow row(const Equations &equations, std::size_t contact,
                const contact::AffineForm &form) const;

  /// y and its first derivatives, one column of `rows` each, from the equations themselves; `rows`
  /// holds derivatives of y, then of s, s', s'' of each source, which must be filled in already,
  /// and y in column 0.
  void differentiate(Matrix &rows) const;

private:
  explicit LinearSystem(std::vector<contact::AffineLaw> laws) : laws_(std::move(laws)) {}
  void assemble(const Equations &equations, const Matrix &stiffness, const Matrix &damping);
  void add_contact(const Equations &equations, std::size_t contact);
  void follow_normal_force(const Equations &equations, std::size_t contact);
  void add_form(const Equations &equations, std::size_t contact, const contact::AffineForm &form,
                const Vector &into);
  void hold(const Equations &equations);

  std::vector<contact::AffineLaw> laws_; ///< of the contacts
  Vector mass_;
  Matrix matrix_;
  Vector constant_;
  std::vector<Load> loads_;
  ConstraintForces constraint_forces_;
};

} // namespace vibroimpact::motion
