// The walk along a curve of special points in two keys.
#pragma once

#include "continuation/locus_equation.h"
#include "continuation/newton.h"
#include "continuation/piece.h"

#include <optional>

namespace vibroimpact::continuation {

struct LocusNode {
  Vector u;
  double chart = 0;
  Vector tangent; ///< of length 1
  Augmented at;
  int iterations = 0;
  double arclength = 0;
};

class LocusContinuation {
public:
  /// Keeps a reference to the record, if there is one (locus.h).
  LocusContinuation(Problem &problem, const LocusStart &start, const Settings &settings,
                    const std::function<void(const LocusPoint &)> &listener, StepRecord *record);
  Locus run();

private:
  struct Bound {
    Index unknown;
    double value; ///< scaled
  };

  /// `compute()`, or what it gave in an earlier run, with what the problem remembers then.
  template <class Compute> auto recorded_step(const char *kind, const Compute &compute) const;
  void find_first(const LocusStart &start);
  void hold_at_bounds();
  void step();
  LocusNode next_node();
  LocusNode at_bound(const Vector &beyond, const Bound &bound, double largest) const;
  LocusNode solve(const Vector &guess, const Vector &normal, double largest, Until until) const;
  LocusNode compute(const Vector &guess, const Vector &normal, double largest, Until until) const;
  Linearisation linearisation(const Vector &u, double chart) const;
  Vector first_tangent(bool forward) const;
  /// Where the cusp's test changes its sign before `next`, with the borders of the step.
  std::optional<LocusNode> cusp_before(const LocusNode &next) const;
  void accept(LocusNode next);
  void add(const LocusNode &node);
  void end_at_steps(const std::string &why);
  void end(LocusEnd end, const std::string &reason);
  std::optional<Bound> bound_passed(const Vector &u) const;
  bool passes_start(const LocusNode &next) const;
  void move_chart();
  LocusPoint locus_point(const LocusNode &node) const;

  ScaledProblem problem_;
  Settings settings_;
  LocusKind kind_;
  std::function<void(const LocusPoint &)> listener_;
  StepRecord *record_;
  std::unique_ptr<LocusEquation> equation_;
  Locus locus_;
  LocusNode here_, first_;
  std::optional<Hermite> path_; ///< to here from the point before, in the same chart
  double step_;
  bool ended_ = false, turned_back_ = false, closes_ = false, bounded_ = false;
};

} // namespace vibroimpact::continuation
