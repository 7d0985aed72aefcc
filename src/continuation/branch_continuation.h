// The walk along a branch: prediction, correction, length of steps, and the checks after each step.
#pragma once

#include "common/bytes.h"
#include "continuation/pattern_changes.h"

namespace vibroimpact::continuation {

class BranchContinuation {
public:
  /// Keeps a reference to the record, if there is one (branch.h).
  BranchContinuation(Problem &problem, const Start &start, const Settings &settings,
                     const Listener &listener, StepRecord *record);
  Branch run();

private:
  struct Bound {
    End end;
    double value; ///< scaled
  };
  /// How a branch goes on behind a graze.
  struct Behind {
    Vector graze;
    std::string guard;
    Node node;
    double step = 0;
    std::optional<std::vector<SpecialPoint>> special; ///< none: not found

    friend void members(auto &visit, As<Behind> auto &behind) {
      visit(behind.graze, behind.guard, behind.node, behind.step, behind.special);
    }
  };

  /// One accepted step or one that is shortened.
  void step();
  void shorten(const std::string &why);
  std::optional<Behind> behind_graze() const;
  /// True if the branch goes on behind a graze, or ends there.
  bool cross();
  /// The point at the distance of a step, or the start or a bound where that lies before it.
  Node next_node();
  Node attempt(const Vector &ahead) const;
  Node at_bound(const Vector &beyond, const Bound &bound) const;
  /// Special points up to the next point; its arclength is that through the graze on the way.
  std::vector<SpecialPoint> examine(Node &next);
  std::vector<SpecialPoint> special_up_to(Node &next, const Piece &piece) const;
  /// Refuses a step in which two special points may hide, whose tests have one sign at both its
  /// ends.
  void check_pairs(const Piece &piece);
  bool pair_suspected(const Node &next, double Tests::*test) const;

  void accept(Node next, std::vector<SpecialPoint> special);
  void end(End end, const std::string &reason);
  bool ends_at_shorter(std::vector<SpecialPoint> special, const Node &next);
  void choose_step(const Node &next);
  void add(BranchPoint point, std::vector<SpecialPoint> special);

  std::optional<Bound> bound_passed(const Vector &u) const;
  bool passes_start(const Node &next) const;
  void take_chart_of_start();
  bool move_for_pattern(const Node &next);
  bool move_chart(double least_margin);
  std::pair<double, int> nearest_return(const Vector &u, double chart) const;

  ScaledProblem problem_;
  Settings settings_;
  Listener listener_;
  StepRecord *record_;
  Branch branch_;
  Node here_, first_;
  std::optional<Node> before_; ///< the point before, where its pattern is that of this one
  bool ended_ = false;
  double step_;
  int halvings_ = 0;            ///< of the step at hand, for suspected pairs
  bool turned_back_ = false;    ///< the key has gone against its direction at the start
  bool moved_ = false;          ///< the chart was chosen for the step at hand
  std::optional<Bound> bound_;  ///< that ends the step at hand
  bool closes_ = false;         ///< the step at hand ends at the start
  std::vector<Vector> crossed_; ///< grazes
};

} // namespace vibroimpact::continuation
