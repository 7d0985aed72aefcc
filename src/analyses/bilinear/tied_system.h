// A model with one contact that is open or tied, under one harmonic excitation.
//
// With the angle tau = omega t and ' = d/dtau the state is y = [q, q', 1, sin tau, cos tau], so
// that both phases are linear without further terms, y' = A y, also where a coordinate is free or
// at resonance. The gap is g = w q + b s + c with the contact's row w. Tied means g = 0, g' = 0 by
// a force F along w:
//
//   q''_tied = q''_open + M^-1 w^T F / omega^2,   F = -omega^2 g''_open / (w M^-1 w^T)
//
// At closing the momentum of the coordinates is kept but for one impulse along w that stops the
// gap,
//
//   q'+ = q'- - M^-1 w^T g'- / (w M^-1 w^T)
#pragma once

#include "analyses/run/system.h"
#include "common/linear_algebra.h"

namespace vibroimpact::analyses {

class TiedSystem {
public:
  /// `source`: the harmonic excitation; angular_frequency omega > 0 [rad/s].
  TiedSystem(const System &system, std::size_t source, double angular_frequency);

  /// InputError unless the model is linear, the excitation harmonic, the others constant, and
  /// exactly one contact active, whose points can move.
  static void check(const System &system, std::size_t source);

  Index states() const { return 2 * n_; } ///< entries of y before 1, sin, cos
  Index size() const { return 2 * n_ + 3; }
  double angular_frequency() const { return omega_; }

  const Matrix &open() const { return open_; }       ///< A, size x size
  const Matrix &closed() const { return closed_; }   ///< A
  const Matrix &closing() const { return closing_; } ///< y+ = closing y-; sets the gap to zero too
  const RowVector &gap() const { return gap_; }      ///< [m]
  const RowVector &gap_rate() const { return gap_rate_; } ///< [m] per rad
  const RowVector &force() const { return force_; }       ///< F while tied, > 0 pushes apart [N]
  /// A projection as a form of y.
  RowVector form(const model::Projection &projection) const;
  /// The derivative of a form while open, or while tied.
  RowVector rate(const RowVector &form, bool tied) const { return form * (tied ? closed_ : open_); }

private:
  void make_open(const model::Model &model);
  void make_closed(const model::Model &model, const contact::ContactPair &pair);

  Index n_;
  double omega_;
  Matrix sources_; ///< s and its first two derivatives by [1, sin, cos]: 3 rows for each source
  Matrix open_, closed_, closing_;
  RowVector gap_, gap_rate_, force_;
};

} // namespace vibroimpact::analyses
