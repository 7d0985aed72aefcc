// The scalar equation that a curve of special points adds to F = 0, with its gradient.
//
// The gradient needs second derivatives of F: g_u = -w^T (F_xu v). As these are symmetric, w^T F_xu
// v is the derivative of w^T F_u along (v, 0): two linearisations, by central differences, whatever
// the number of coordinates. Their error of h^2 only slows Newton's method: the zeros are those of
// g itself.
#pragma once

#include "continuation/locus.h"
#include "continuation/scaled_problem.h"

namespace vibroimpact::continuation {

/// F with the equation.
struct Augmented : Linearisation {
  double value = 0;   ///< g
  RowVector gradient; ///< of g by u, n + 2
  /// Of folds: w^T F_xx (v, v), whose sign changes at a cusp. One sign as long as the borders are
  /// the same.
  double cusp = 1;
  double angle = 0; ///< Neimark-Sacker: argument of the multiplier
  /// See LocusPoint::side.
  int side = 0;
};

class LocusEquation {
public:
  virtual ~LocusEquation() = default;
  /// NumericalError where F has no value, or the multiplier is no longer there.
  virtual Augmented evaluate(const Vector &u, double chart) const = 0;
  /// Takes borders, or the multiplier, anew from a point on the curve; in a new chart as well.
  virtual void renew(const Linearisation &at, double chart) = 0;
  virtual std::unique_ptr<LocusEquation> clone() const = 0;
};

/// `at`: F at the start, which grazes do without.
std::unique_ptr<LocusEquation> make_equation(const ScaledProblem &problem, const LocusStart &start,
                                             const Linearisation &at);

/// det-free test of a singular matrix: (v, g) of [[matrix, b], [c^T, 0]] (v, g) = (0, 1) and w of
/// the transposed system. g is zero where the matrix is singular, with v and w its null vectors.
struct Bordered {
  Vector v, w;
  double g = 0;
};
struct Borders {
  Vector b, c;
  /// Null vectors of the nearest singular matrix, of length 1 and of one sense.
  static Borders of(const Matrix &matrix);
  Bordered solve(const Matrix &matrix) const;
};

} // namespace vibroimpact::continuation
