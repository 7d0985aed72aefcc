// A motion within a linear phase as polynomials, between any two of its instants.
//
// Amplitudes are known at every instant to the last digits, and with them all derivatives. Between
// two instants observers see Hermite polynomials (step_view.h), whose error is chosen: with p
// derivatives known at both ends of a step of length h,
//
//   |f - P| <= max|f^(2p)| / (2p)! max (t (h - t))^p
//
// and the derivatives of that bound for the derivatives of f (Birkhoff and Priver 1967). Steps are
// as long as displacement, velocity and acceleration of each body, of each internal state and of
// each source keep the tolerance, relative to what they have reached in the phase, of which a
// thousandth counts from one part of it to the next.
#pragma once

#include "motion/interval/end_point.h"
#include "motion/phase/exact_phase.h"
#include "motion/system/equations.h"

#include <array>
#include <vector>

namespace vibroimpact::motion {

class ExactSegment {
public:
  /// Keeps references. `tolerance`: relative; `longest` [s].
  ExactSegment(const Equations &equations, const ExactPhase &phase, double tolerance,
               double longest);

  /// The inputs of the phase are others.
  void renew();

  /// A part of the motion begins, in the phase of the part before it or anew.
  void begin(const double *amplitudes, bool anew);
  /// Length of the longest step from these amplitudes on, after begin() [s].
  double step(const double *amplitudes);
  std::size_t bytes() const { return sizes_.size() * bytes_of(sizes_[0]); }
  /// What is known of the motion there; the work integrals in the state stay.
  void fill(double time, const double *amplitudes, EndPoint &point);

private:
  // What a step is measured by: a body, an internal state, a source.
  struct Measure {
    Index row = 0;  ///< of the columns of the phase
    Index into = 0; ///< place among the measures
    bool first_order = false;
  };
  void list_measures(const Equations &equations);
  void measure(const PhaseGroup &group);
  void add_sizes(const Measure &of, Index unit, const std::array<double, 4> &sizes);
  void measure_dense(const PhaseGroup &group);
  void differentiate();
  void take_magnitudes(const double *amplitudes);
  double allowed(const Vector &sizes, const Vector &errors, double factor, int power) const;

  const ExactPhase &phase_;
  const StateLayout &layout_;
  double tolerance_, longest_;
  std::vector<Measure> measures_;
  Index n_second_ = 0, n_first_ = 0; ///< measures of the second and of the first order
  std::array<Matrix, 4> sizes_;      ///< of value, rate, acceleration, error; measures x units
  Vector magnitudes_;
  std::array<Vector, 3> reached_; ///< value, rate and acceleration
  Vector errors_;
  double fastest_growth_ = 0;
  Vector coordinates_, moved_, rows_;
};

} // namespace vibroimpact::motion
