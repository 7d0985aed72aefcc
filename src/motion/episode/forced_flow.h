// A linear system under an unknown force, x' = S x + b f, block by block, and what it makes of the
// force over a step. A force along two directions has a load b for each.
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
  /// `loads`: b of each direction, in units of x per second and newton, all of the size of x;
  /// places that no block has stay zero.
  ForcedFlow(const std::vector<FlowBlock> &blocks, const std::vector<Vector> &loads);
  ForcedFlow(const std::vector<FlowBlock> &blocks, const Vector &load)
      : ForcedFlow(blocks, std::vector{load}) {}

  Index size() const { return load().size(); }
  int n_loads() const { return static_cast<int>(driven_.size()); }
  const Vector &load(int direction = 0) const { return driven(direction).load; }
  /// Largest |exponent| [1/s]; 1 where all are zero, where it only sets a scale.
  double fastest() const { return fastest_; }
  /// row S
  Vector before(const Vector &row) const;
  /// x += T sum over k of (T S)^k b moments[k]; moments: `terms` of them [N].
  void add(double duration, const double *moments, int terms, double *x, int direction = 0) const;

private:
  /// Blocks that rotate, which the force drives, in arrays.
  struct Pairs {
    std::vector<int> real, imaginary; ///< places
    std::vector<double> rate, frequency, real_load, imaginary_load;
    std::size_t size() const { return real.size(); }
  };
  /// What a force along one direction drives.
  struct Driven {
    Vector load;
    Pairs pairs{};
    std::vector<FlowBlock> others{}; ///< all other blocks
    std::vector<Vector> other_loads{};
  };
  const Driven &driven(int direction) const { return driven_[static_cast<std::size_t>(direction)]; }
  static void add_block(const FlowBlock &block, Driven &driven);
  void add_pairs(double duration, const double *moments, int terms, const Driven &driven,
                 double *x) const;
  static void add_others(double duration, const double *moments, int terms, const Driven &driven,
                         double *x);

  /// Blocks that rotate: the places of both coordinates, rate, and frequency.
  struct Turning {
    int real = 0, imaginary = 0;
    double rate = 0, frequency = 0;
  };
  std::vector<Turning> turning_;
  std::vector<FlowBlock> blocks_; ///< that do not rotate
  std::vector<Driven> driven_;    ///< by directions
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
  int n_terms() const { return static_cast<int>(rows_.cols()); }
  /// size x terms, column k: row S^k / (k! fastest^k): with x0 the coefficients of the free motion
  /// in powers of fastest (t - t0).
  const Matrix &rows() const { return rows_; }
  /// g_k = row S^k b / fastest^k
  const Vector &responses(int direction = 0) const {
    return responses_[static_cast<std::size_t>(direction)];
  }
  /// Coefficients of the free motion from x0: the first `terms`, the constant in the first.
  void free_motion(const double *x, int terms, double *coefficients) const;

private:
  const ForcedFlow &flow_;
  double constant_;
  Vector last_; ///< row S^k / fastest^k of the last coefficient
  double factorial_ = 1;
  Matrix rows_;
  std::vector<Vector> responses_; ///< to each load
};

} // namespace vibroimpact::motion
