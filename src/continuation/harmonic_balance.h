// Harmonic balance: periodic motions as Fourier series of H harmonics, by a key, as a continuation
// problem. An approximation: what the force has above H is left out. With H = 1 it is first-order
// averaging.
//
//     M q'' + C q' + K q + sum_e r_e^T f_e(y_e) = load(t),   y_e = r_e q + offset_e(t)
//
// with phi = omega t. The elements e are all that is not linear: a contact, a cubic spring, each
// with one displacement y_e. For given series of these the linear part has the closed form
//
//     q_h = Z_h^-1 (load_h - sum_e r_e^T f_eh),   Z_h = K - h^2 omega^2 M + i h omega C,
//
// so that the series of the y_e are the only unknowns (exact condensation: Krack & Gross 2019,
// section 4.3), m (2 H + 1) however many coordinates there are.
#pragma once

#include "continuation/problem.h"

#include <vector>

namespace vibroimpact::continuation {

/// The linear part at one value of the key: n coordinates, m elements, series of 2 H + 1
/// coefficients (harmonic_series.h) in rows.
struct HarmonicEquations {
  Matrix mass, damping, stiffness; ///< n x n
  double frequency = 0;            ///< omega [rad/s]
  Matrix load;                     ///< n x (2 H + 1)
  Matrix rows;                     ///< r_e: m x n
  Matrix offset;                   ///< m x (2 H + 1)
};

/// Series of the force of one element along a series of its displacement; both have as many
/// coefficients.
struct ForceSeries {
  RowVector force;        ///< on the left-hand side
  Matrix by_displacement; ///< of coefficients by coefficients, with the rate; on request
  double largest = 0;     ///< of |f|, within a period
};

class HarmonicSystem {
public:
  virtual ~HarmonicSystem() = default;
  /// NumericalError where the key has no such system.
  virtual HarmonicEquations equations(double key) = 0;
  /// Of the system of the last equations(). The series may have more harmonics than H.
  virtual ForceSeries force(Index element, const RowVector &displacement, bool slopes) = 0;
};

/// A motion in full.
struct HarmonicMotion {
  double frequency = 0;            ///< [rad/s]
  Matrix elements;                 ///< y: m x (2 H + 1)
  Matrix coordinates;              ///< q: n x (2 H + 1)
  std::vector<ForceSeries> forces; ///< m
};

/// What the harmonics from H + 1 on would be.
struct LeftOut {
  double force = 0;   ///< root of their mean square over that of all harmonics; 0 without forces
  Matrix coordinates; ///< the linear response to them, n x (2 H' + 1), zero up to H
};

class HarmonicBalance : public Problem {
public:
  /// `size`: what counts as one of each element's displacement, m; `key_size` that of the key.
  HarmonicBalance(HarmonicSystem &system, Index harmonics, Vector size, double key_size);

  /// The state is m x (2 H + 1) by columns: the constants of all y_e, their a_1, b_1, a_2...
  Vector scales() const override;
  /// With the derivative by the key by differences: it only turns the tangent, and folds lie where
  /// dF/dx is singular whatever it is.
  Evaluation evaluate(const Point &point) override;
  bool is_map() const override { return false; }

  /// The state without any force of the elements.
  Vector linear_response(double key);
  /// That of given coordinates, n x (2 H + 1).
  Vector state_of(const Matrix &coordinates, double key);
  /// With the derivatives of the forces on request.
  HarmonicMotion motion(const Vector &state, double key, bool slopes = false);
  /// With the harmonics H + 1 to 3 H of the forces along the motion. They would change the forces
  /// in turn, which is of higher order.
  LeftOut left_out(const HarmonicMotion &motion, double key);

private:
  Index coefficients() const { return 2 * harmonics_ + 1; }
  Matrix series(const Vector &state) const;
  Vector residual(const Vector &state, double key, Matrix *by_state);
  Vector key_derivative(const Vector &state, double key, const Vector &residual_here);

  HarmonicSystem &system_;
  Index harmonics_;
  Vector size_;
  double key_size_;
};

} // namespace vibroimpact::continuation
