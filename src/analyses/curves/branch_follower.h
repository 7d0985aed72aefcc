// Follows branches of periodic motions along a key, and those that begin at their special points.
#pragma once

#include "analyses/curves/curve_progress.h"
#include "analyses/keys/branch_keys.h"
#include "continuation/branch.h"

#include <functional>
#include <list>
#include <memory>

namespace vibroimpact::analyses {

/// Takes what is found.
class BranchSink {
public:
  virtual ~BranchSink() = default;
  /// What follows is a part of branch `number`, 0 for that of the start, whose motions are fixed
  /// points of maps over `halves` half periods. `sign`: -1 where the arclength falls.
  virtual void begin(long number, long halves, double sign) = 0;
  virtual void add(const continuation::BranchPoint &point) = 0;
  virtual void add(const continuation::SpecialPoint &special) = 0;
  /// Forgets all of a branch.
  virtual void drop(long number) = 0;
  /// A branch that begins at this value of the key is not followed.
  virtual void note_missing(double /*key*/, const std::string & /*why*/) {}
  /// The part ends.
  virtual void end(const continuation::Branch &branch) = 0;
};

class BranchFollower {
public:
  struct Rule {
    Directions directions = Directions::both; ///< of the first branch
    continuation::Settings continuation{};
    long levels = 0; ///< of branches that begin at special points of others
  };
  /// Keeps references. `note` is called at each point with the share that is done, at least; it
  /// may throw to end the run. What the steps give is kept in the record, if there is one.
  BranchFollower(Rule rule, BranchSink &sink, std::function<void(double share)> note,
                 StepRecord *steps = nullptr)
      : rule_(std::move(rule)), sink_(sink), steps_(steps),
        progress_(rule_.continuation.first_key, 0, std::move(note)) {}

  /// From a solution that continuation::solve() has found; `halves` as for BranchSink::begin().
  void run(const std::shared_ptr<continuation::Problem> &problem, long halves,
           const continuation::BranchPoint &first);

private:
  /// A branch that is still to be followed.
  struct Task {
    std::shared_ptr<continuation::Problem> problem;
    long halves = 2; ///< half periods over which its maps go
    continuation::Start start;
    long number = 0, level = 0;
    double sign = 1;
    double key = 0; ///< of the special point where it begins
  };
  void enter(Task &task);
  continuation::End follow(const Task &task);
  void forget(const Task &done, double key);
  void switch_at(const Task &task, const continuation::SpecialPoint &special);

  Rule rule_;
  BranchSink &sink_;
  StepRecord *steps_;
  std::list<Task> tasks_;
  long branches_ = 0;
  CurveProgress progress_;
};

} // namespace vibroimpact::analyses
