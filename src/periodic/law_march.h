// A contact law led along a gap that is a Fourier series: its force, guards and internal states,
// with their derivatives by the coefficients of the gap at a fixed phase.
#pragma once

#include "contact/contact_law.h"
#include "periodic/harmonic_grid.h"

namespace vibroimpact::periodic {

/// Where a law stands at a phase.
struct LawState {
  int mode = 0;
  Vector internal; ///< z
  Matrix by_gap;   ///< dz/dy: internal states x coefficients

  bool repeats(const LawState &before) const;
};

/// A part of the period in one mode, at the nodes of Gauss's rule.
struct LawPart {
  double begin = 0, length = 0; ///< [rad]
  bool acts = false;            ///< with a force, or internal states that may change
  Matrix basis;                 ///< coefficients x nodes
  RowVector gap, gap_rate;      ///< at the start, the nodes, and the end: nodes + 2
  Matrix internal;              ///< internal states x nodes
  Vector force;                 ///< nodes [N]; of parts that act, as the next
  Matrix force_slope;           ///< by the coefficients of the gap: coefficients x nodes
  LawState end;

  /// Phase of the start (0), the nodes (1...), and the end.
  double place(Index k) const;
};

/// A change of mode: the force on both sides, and how the instant moves with the gap.
struct LawPassage {
  double force_before = 0, force_after = 0;
  RowVector phase_slope; ///< coefficients [rad/m]
  LawState after;
};

class LawMarch {
public:
  /// Keeps references. `gap` [m] has the coefficients of the grid, `frequency` in rad/s.
  LawMarch(const contact::ContactLaw &law, const RowVector &gap, double frequency,
           const HarmonicGrid &grid);

  /// At phase zero: without internal states what the gap and its rate say, with them the law's
  /// initial ones.
  LawState start() const;
  const std::vector<contact::Guard> &guards(const LawState &state) const;

  /// NumericalError where the law objects to a state of it.
  LawPart part(Index interval, const LawState &state) const;
  LawPart part(double begin, double end, const LawState &state) const;
  /// Of a guard at the places of a part that begins in `state`: nodes + 2.
  Vector guard_values(const LawPart &part, const LawState &state,
                      const contact::Guard &guard) const;
  /// At a later phase, the mode being kept.
  double guard_value(const LawState &state, double begin, double phase,
                     const contact::Guard &guard) const;
  LawPassage pass(const LawState &state, double phase, const contact::Guard &guard) const;

private:
  struct Local;
  struct Stages;
  Local local(double phase) const;
  /// With the harmonic functions at the nodes, the start and the end.
  LawPart make_part(double begin, double end, Matrix basis, const Vector &first, const Vector &last,
                    const LawState &state) const;
  void act(LawPart &part, const LawState &state) const;
  void refuse_objections(const LawPart &part, const LawState &state) const;
  bool inactive(const LawState &state) const;
  Stages stages(const LawState &state, const RowVector &gap, const RowVector &rate,
                double length) const;
  std::vector<Matrix> carry_slopes(const Stages &stages, LawPart &part, const Matrix &rate_slope,
                                   const LawState &state) const;

  const contact::ContactLaw &law_;
  const HarmonicGrid &grid_;
  RowVector gap_, rate_, acceleration_; ///< by time, by the phase for the last one
  double frequency_;                    ///< [rad/s]
  Index internals_;
};

} // namespace vibroimpact::periodic
