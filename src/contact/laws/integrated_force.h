// The integral of a force over the penetration, by Chebyshev polynomials on as many pieces as it
// takes.
#pragma once

#include <functional>
#include <vector>

namespace vibroimpact::contact {

class IntegratedForce {
public:
  /// force [N] at penetrations from 0 to `range` > 0 [m]. Towards zero the pieces halve, so that
  /// powers are resolved; where the force has a corner they halve until what it leaves is below the
  /// rounding of the whole.
  IntegratedForce(std::function<double(double)> force, double range);

  /// From 0 to a penetration >= 0 [J]; behind the range by the rule of Simpson.
  double operator()(double penetration) const;
  /// Largest magnitude of the force that it has met [N].
  double largest() const { return largest_; }

private:
  struct Piece {
    double begin = 0, end = 0;        ///< [m]
    double before = 0;                ///< integral up to the piece [J]
    std::vector<double> coefficients; ///< of the integral within it, Chebyshev
  };
  void add(double begin, double end, int depth);
  static double within(const Piece &piece, double penetration);

  std::function<double(double)> force_;
  double range_;
  double largest_ = 0;
  std::vector<Piece> pieces_;
};

} // namespace vibroimpact::contact
