// A branch of solutions of F(x, p) = 0 as a curve that is followed.
#pragma once

#include "continuation/branch.h"
#include "continuation/curve_system.h"
#include "continuation/pattern_changes.h"

namespace vibroimpact::continuation {

class BranchSystem {
public:
  using Curve = Branch;
  using Node = continuation::Node;

  BranchSystem(Problem &problem, const Start &start, const Settings &settings);

  const ScaledProblem &problem() const { return problem_; }
  BranchPoint curve_point(const Node &node) const { return branch_point(problem_, node); }
  /// The branch may turn before a bound that the prediction passes.
  static constexpr bool ends_at_predicted_bounds = false;
  static End end_at(const Bound &bound) {
    return bound.upper ? End::upper_bound : End::lower_bound;
  }

  Node first() const;
  Node correct(const Node &from, const Vector &guess, const Vector &normal, double largest) const;
  Node in_chart(const Node &node, double chart) const;
  double best_chart(const Node &node) const;
  std::vector<SpecialPoint> special_points(const Node &from, Node &next, bool closes) const;
  std::optional<Behind<Node, SpecialPoint>> behind_graze(const Node &from) const;
  std::optional<Ending<Branch>> end_before(const Node &next,
                                           const std::vector<SpecialPoint> &special) const;
  Ending<Branch> end_at_steps(const Node &last, const std::string &why) const;

  static Vector predicted(const Node &from, double step) { return from.u + step * from.tangent; }
  double step_factor(const Node &from, const Node &next) const;
  /// Of the chart: in one where the pattern changes close by, a change is seen badly.
  double least_margin(const Node &from, const Node &next) const;
  /// Refuses a step in which two special points may hide, whose tests have one sign at both its
  /// ends.
  void check(const Node &from, const Node &next);
  void accept(const Node &from, const Node &next);
  static void take_chart(const Node & /*moved*/) {}

private:
  bool pair_suspected(const Node &from, const Node &next, double Tests::*test) const;

  ScaledProblem problem_;
  Start start_;
  Settings settings_;
  std::optional<Node> before_; ///< the point before, where its pattern is that of this one
  int halvings_ = 0;           ///< of the step at hand, for suspected pairs
};

} // namespace vibroimpact::continuation
