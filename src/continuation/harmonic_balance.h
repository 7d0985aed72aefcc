// Harmonic balance: periodic motions as Fourier series of H harmonics, by a key, as a continuation
// problem. An approximation: with H = 1 it is first-order averaging.
//
//     M q'' + C q' + K q + f(q, q') = load(t),   q(t) = a_0 + sum_h a_h cos(h phi) + b_h sin(h phi)
//
// with phi = omega t. Forces have their coefficients by alternating frequency and time: the series
// is sampled over a period, f evaluated there, and projected back (Cameron & Griffin 1989). The
// projection of a polynomial of degree d is exact with more than (d + 1) H samples.
#pragma once

#include "continuation/problem.h"

namespace vibroimpact::continuation {

/// The linear part at one value of the key; n coordinates.
struct HarmonicEquations {
  Matrix mass, damping, stiffness; ///< n x n
  double frequency = 0;            ///< omega [rad/s]
  /// Constant, cosine and sine of 1, of 2..., n rows; harmonics above H are left out as those of q
  /// are.
  Matrix load;
};

/// A force on the left-hand side at one instant.
struct ForceSample {
  Vector force;                        ///< n
  Matrix by_displacement, by_velocity; ///< n x n
};

class HarmonicSystem {
public:
  virtual ~HarmonicSystem() = default;
  virtual HarmonicEquations equations(double key) = 0;
  virtual ForceSample force(const Vector &displacement, const Vector &velocity, double phase,
                            double key) = 0;
};

class HarmonicBalance : public Problem {
public:
  /// `size`: what counts as one of each coordinate, n; `key_size` that of the key. std::logic_error
  /// for fewer samples than 2 H + 1.
  HarmonicBalance(HarmonicSystem &system, Index harmonics, Index samples, Vector size,
                  double key_size);

  /// The state is n x (2 H + 1) by columns: a_0, a_1, b_1, a_2...
  Vector scales() const override;
  /// With the derivative by the key by central differences: it only turns the tangent, and folds
  /// lie where dF/dx is singular whatever it is.
  Evaluation evaluate(const Point &point) override;
  bool is_map() const override { return false; }

  /// Displacement at a phase [rad].
  Vector displacement(const Vector &state, double phase) const;
  /// sqrt(a^2 + b^2) of one harmonic of each coordinate; |a_0| for 0.
  Vector amplitudes(const Vector &state, Index harmonic) const;

private:
  Index coefficients() const { return 2 * harmonics_ + 1; }
  Vector residual(const Vector &state, double key, Matrix *by_state);
  void add_forces(const Matrix &series, double frequency, double key, Matrix &residual,
                  Matrix *by_state);

  HarmonicSystem &system_;
  Index harmonics_;
  Vector size_;
  double key_size_;
  Matrix synthesis_;  ///< samples x (2 H + 1): series to values
  Matrix projection_; ///< (2 H + 1) x samples: values to series
  Matrix rate_;       ///< (2 H + 1) x (2 H + 1): series of dq/dphi is series * rate
};

} // namespace vibroimpact::continuation
