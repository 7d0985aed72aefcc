// A parameter of time in which roots of the time since the begin and until the end are smooth.
//
//   x(xi) = I_xi(p, q),   the regularized incomplete beta function,
//
// is a polynomial of degree p + q - 1 that goes like xi^p at one end and 1 - x like (1 - xi)^q at
// the other, so that x^(1/p) and (1 - x)^(1/q) have Taylor series in xi there. p = q = 1: x = xi.
#pragma once

namespace vibroimpact::motion {

class EpisodeTime {
public:
  /// p, q >= 1
  EpisodeTime(int begin_root, int end_root);

  /// Of xi in [0, 1], rest = 1 - xi.
  struct Point {
    long double x, rest;      ///< x and 1 - x, each to its own last digit
    long double begin, end;   ///< x / xi^p and (1 - x) / (1 - xi)^q, which have no zero in [0, 1]
    long double slope_factor; ///< dx/dxi over xi^(p-1) (1 - xi)^(q-1)
  };
  Point at(long double xi, long double rest) const;
  /// xi of x, within the rounding of 1.
  long double inverse(long double x, long double rest) const;
  /// Largest dx/dxi.
  double steepest() const;

private:
  int p_, q_;
};

} // namespace vibroimpact::motion
