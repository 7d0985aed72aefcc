// The equations of motion for one combination of contact modes in which everything is linear:
//
//   y' = A y + b + sum over sources (l s + m s' + p s''),   y = [q, v, internal states]
//
// and its complex eigenvectors, y = W a with a real basis W: two columns (2 Re w, -2 Im w) for a
// pair of conjugate eigenvalues, one for a real one. A is balanced by powers of two before the
// decomposition, so that positions and velocities in different units do no harm.
#pragma once

#include "motion/exact/modal_form.h"
#include "motion/system/equations.h"

#include <complex>
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
  struct Mode {
    Complex eigenvalue;   ///< imaginary part >= 0 [1/s]
    Index column = 0;     ///< in basis()
    bool is_pair = false; ///< with its conjugate, two columns
  };

  /// Forces of the contacts whose gap is held: constants + rows * [y, then s, s', s'' of each
  /// source]
  struct ConstraintForces {
    std::vector<std::size_t> contacts;
    Matrix rows;      ///< held contacts x (size + 3 sources)
    Vector constants; ///< held contacts
  };

  Index size() const { return matrix_.rows(); }
  const Vector &mass() const { return mass_; }
  const Matrix &matrix() const { return matrix_; }
  const Vector &constant() const { return constant_; }
  const std::vector<Load> &loads() const { return loads_; }
  const ConstraintForces &constraint_forces() const { return constraint_forces_; }
  /// Of the present modes, without the rest.
  static ConstraintForces constraint_forces(const Equations &equations);
  double spectral_radius() const { return spectral_radius_; }

  /// False where the eigenvectors are too nearly dependent to be used.
  bool diagonalizable() const { return diagonalizable_; }
  const std::vector<Mode> &modes() const { return modes_; }
  const Matrix &basis() const { return basis_; }     ///< W
  const Matrix &inverse() const { return inverse_; } ///< W^-1

  /// y and its first derivatives, one column of `rows` each, from the equations themselves; `rows`
  /// holds derivatives of y, then of s, s', s'' of each source, which must be filled in already,
  /// and y in column 0.
  void differentiate(Matrix &rows) const;

  /// The particular solution r exp(e t) for the input g exp(e t), e with imaginary part >= 0, a
  /// real input when it is zero. False in resonance: e so near an eigenvalue that the solution is
  /// lost in rounding, or does not exist.
  bool response(Complex exponent, const ComplexVector &input, ComplexVector &solution) const;

private:
  LinearSystem() = default;
  void assemble(const Equations &equations);
  void add_contact(const Equations &equations, std::size_t contact);
  void add_form(const Equations &equations, std::size_t contact, const contact::AffineForm &form,
                const Vector &into);
  void hold(const Equations &equations);
  void decompose();

  Vector mass_;
  Matrix matrix_;
  Vector constant_;
  std::vector<Load> loads_;
  ConstraintForces constraint_forces_;
  double spectral_radius_ = 0;
  bool diagonalizable_ = false;
  std::vector<Mode> modes_;
  Matrix basis_, inverse_;
  Vector scale_;              ///< of the balanced coordinates
  ComplexVector eigenvalues_; ///< all of them
  Vector left_sizes_;         ///< norms of the rows of left_ in balanced coordinates
  Eigen::MatrixXcd eigenvectors_, left_;
};

} // namespace vibroimpact::motion
