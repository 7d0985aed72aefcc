// The motion of a linear system between two contact changes, exactly, from the start of a step on.
//
// Rows: y (size of the system), then s, s', s'' of each source. Two ways:
//   ModalMotion   sum of complex exponentials: free vibration in the eigenvectors, responses to
//                 constant and exponential (harmonic) sources
//   TaylorMotion  Taylor series of the matrix exponential, for systems without a full set of
//                 eigenvectors (free bodies, critical damping), resonance, and sources with
//                 polynomials; its steps are no longer than 1 / spectral radius
// Both choose the step from a bound of the error that the dense output of the step will have.
#pragma once

#include "motion/segment/guard_curves.h"
#include "motion/segment/guard_forms.h"

#include <memory>
#include <span>
#include <vector>

namespace vibroimpact::motion {

/// Derivatives of y at the ends of a step: the dense output of internal states has degree 7, that
/// of the coordinates, whose rates are among y, degree 9.
constexpr int dense_derivatives = 3;

/// Error the dense output may have: relative to the size that a row has in the phase, plus
/// `absolute` (one entry per row of y).
struct DenseTolerance {
  double relative = 0;
  Vector absolute;
};

class LinearMotion {
public:
  virtual ~LinearMotion() = default;

  /// A new phase from y at the common origin of the sources' closed forms. False: impossible this
  /// way.
  virtual bool begin(const Vector &y, std::span<const model::ExponentialForm> sources) = 0;
  /// Longest step from here whose dense output is good enough [s].
  virtual double natural_step() = 0;
  /// Rows at `tau` [s] after the start of the step; column m holds the m-th derivative, m = 0 ...
  /// dense_derivatives.
  virtual void derivatives(double tau, Matrix &rows) = 0;
  /// The same at the start of the phase, to the last digit: what is zero there comes out as zero.
  virtual void initial_derivatives(Matrix &rows) = 0;
  /// Rows at several instants after the start of the step, one column each.
  virtual void values(std::span<const double> instants, Matrix &rows) = 0;
  /// The length from `start` on, both counted from the start of the step, over which
  /// WorkQuadrature::points Gauss points integrate products of two rates to rounding; at most
  /// `rest`.
  virtual double quadrature_length(double start, double rest) const = 0;
  /// The next step starts `tau` later.
  virtual void move(double tau) = 0;

  /// The forms that guards() looks at; call it before begin().
  virtual void watch(const GuardForms &forms) = 0;
  /// The observed forms as functions of the time since the start of the step, up to `end`. Valid
  /// until the next call of a member.
  virtual const GuardCurves &guards(double end) = 0;
};

/// The longest step of a Hermite polynomial of degree 9 for the coordinates and 7 for the internal
/// states, from the largest ratios of their derivatives of order 10 and 8 to the error allowed.
double dense_step(double tenth_derivative, double eighth_derivative);

std::unique_ptr<LinearMotion> make_modal_motion(const LinearSystem &system, Index n_coordinates,
                                                const DenseTolerance &tolerance);
std::unique_ptr<LinearMotion> make_taylor_motion(const LinearSystem &system, Index n_coordinates,
                                                 const DenseTolerance &tolerance);

/// Modal where that is possible.
class LinearPhase {
public:
  /// For the present modes of the equations.
  LinearPhase(const Equations &equations, const DenseTolerance &tolerance);

  /// The motion from y on. `sources`: closed forms with the start of the phase as origin.
  LinearMotion &begin(const Vector &y, std::span<const model::ExponentialForm> sources);
  const LinearSystem &system() const { return system_; }

private:
  LinearSystem system_;
  std::unique_ptr<LinearMotion> modal_, taylor_;
};

} // namespace vibroimpact::motion
