// A problem in scaled unknowns u = (x / s_x, p / s_p) and residuals F / s_x: one hyperplane and one
// measure of length for states and keys of all units. Multipliers do not change, since x and P(x)
// are scaled alike.
#pragma once

#include "continuation/problem.h"

namespace vibroimpact::continuation {

struct Linearisation {
  Vector residual; ///< n, scaled
  Matrix slope;    ///< dF/du, n x (n + keys), scaled
  Pattern pattern;
  double chart_margin = 0;
};

/// An extension (problem.h) with the guard's least value as the last residual.
struct LinearisedExtension {
  Linearisation smooth;
  double value = 0;
  RowVector gradient; ///< of the value by u
  Touch touch = Touch::smooth;
  int kind = 0;
  Vector jump; ///< scaled; empty unless the touch is a corner
};

class ScaledProblem {
public:
  /// `sample` tells how many states and keys there are. std::logic_error for scales that do not
  /// fit.
  ScaledProblem(Problem &problem, const Point &sample);

  Problem &problem() const { return problem_; }
  Index states() const { return states_; }
  Index unknowns() const { return scales_.size(); }
  const Vector &scales() const { return scales_; }

  Vector scaled(const Point &point) const;
  Point point(const Vector &u, double chart) const;

  /// NumericalError where F has no value or a value that is not finite.
  Linearisation evaluate(const Vector &u, double chart) const;
  LinearisedExtension extend(const Vector &u, double chart, const Graze &graze) const;
  /// Moves u to another chart and tangents (columns) with it.
  Vector transfer(const Vector &u, double from, double to, Matrix &tangents) const;
  /// The smallest length of a shorter return, scaled, and its multiple; infinite where there is
  /// none.
  std::pair<double, int> nearest_return(const Vector &u, double chart) const;

private:
  Linearisation scaled(Evaluation evaluation) const;

  Problem &problem_;
  Index states_;
  Vector scales_;
};

} // namespace vibroimpact::continuation
