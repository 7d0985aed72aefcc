// A linear system under one unknown force, x' = S x + b f, block by block, and what it makes of the
// force over a step.
//
//   x(t0 + X T) = exp(S X T) x0 + T sum over k of (T S)^k b (I_k f)(X)
//
// with the repeated integrals I_k of force_operators.h: the exponential under the integral as its
// Taylor series, which needs no eigenvectors, so that free bodies and critical damping are nothing
// special. With theta = T max|exponent| the terms fall like theta^k / k!.
#pragma once

#include "common/linear_algebra.h"

#include <vector>

namespace vibroimpact::motion {

/// Coordinates that go on by themselves: x' = generator x at these places.
struct FlowBlock {
  std::vector<int> places;
  Matrix generator; ///< [1/s]
};

class ForcedFlow {
public:
  /// `size`: of x; places that no block has stay zero. `load`: b, in units of x per second and
  /// newton.
  ForcedFlow(const std::vector<FlowBlock> &blocks, const Vector &load);

  Index size() const { return load_.size(); }
  const Vector &load() const { return load_; }
  /// Largest |exponent| [1/s]; 1 where all are zero, where it only sets a scale.
  double fastest() const { return fastest_; }
  /// row S
  Vector before(const Vector &row) const;
  /// x += T sum over k of (T S)^k b moments[k]; moments: `terms` of them [N].
  void add(double duration, const double *moments, int terms, double *x) const;

private:
  /// Blocks that rotate, which the force drives, in arrays.
  struct Pairs {
    std::vector<int> real, imaginary; ///< places
    std::vector<double> rate, frequency, real_load, imaginary_load;
    std::size_t size() const { return real.size(); }
  };
  void add_pairs(double duration, const double *moments, int terms, double *x) const;
  void add_others(double duration, const double *moments, int terms, double *x) const;

  /// Blocks that rotate: the places of both coordinates, rate, and frequency.
  struct Turning {
    int real = 0, imaginary = 0;
    double rate = 0, frequency = 0;
  };
  std::vector<Turning> turning_;
  std::vector<FlowBlock> blocks_; ///< that do not rotate
  Pairs pairs_;
  std::vector<FlowBlock> others_; ///< all other blocks that it drives
  std::vector<Vector> other_loads_;
  Vector load_;
  double fastest_ = 0;
  mutable std::vector<double> sums_; ///< real, then imaginary
};

/// u = row x + constant of such a system, and its Taylor coefficients.
class ForcedOutput {
public:
  /// Keeps a reference to the flow. Makes `terms` coefficients.
  ForcedOutput(const ForcedFlow &flow, Vector row, double constant, int terms);
  /// Makes `terms` coefficients at least; those that are there stay.
  void require(int terms);

  const ForcedFlow &flow() const { return flow_; }
  double constant() const { return constant_; }
  int n_terms() const { return static_cast<int>(responses_.size()); }
  /// size x terms, column k: row S^k / (k! fastest^k): with x0 the coefficients of the free motion
  /// in powers of fastest (t - t0).
  const Matrix &rows() const { return rows_; }
  /// g_k = row S^k b / fastest^k
  const Vector &responses() const { return responses_; }
  /// Coefficients of the free motion from x0: the first `terms`, the constant in the first.
  void free_motion(const double *x, int terms, double *coefficients) const;

private:
  const ForcedFlow &flow_;
  double constant_;
  Vector last_; ///< row S^k / fastest^k of the last coefficient
  double factorial_ = 1;
  Matrix rows_;
  Vector responses_;
};

} // namespace vibroimpact::motion
