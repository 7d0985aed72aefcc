#include "analyses/curves/branch_follower.h"

#include "common/error.h"
#include "continuation/stored_steps.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

using continuation::Branch;
using continuation::BranchPoint;
using continuation::Problem;
using continuation::SpecialPoint;

void BranchFollower::run(const std::shared_ptr<Problem> &problem, long halves,
                         const BranchPoint &first) {
  if (rule_.directions != Directions::backward)
    tasks_.push_back(
        {.problem = problem, .halves = halves, .start = {.point = first.point, .direction = {}}});
  if (rule_.directions != Directions::forward)
    tasks_.push_back({.problem = problem,
                      .halves = halves,
                      .start = {.point = first.point, .direction = {}, .forward = false},
                      .sign = -1});
  bool closed = false;
  for (; !tasks_.empty() && tasks_.front().level == 0; tasks_.pop_front())
    if (!closed)
      closed = follow(tasks_.front()) == continuation::End::closed;
  for (; !tasks_.empty(); tasks_.pop_front())
    enter(tasks_.front());
}

// A branch whose first point is not found is left out with its reason.
void BranchFollower::enter(Task &task) {
  task.number = branches_ + 1;
  try {
    follow(task);
    ++branches_;
  } catch (const NumericalError &error) {
    sink_.drop(task.number);
    sink_.note_missing(task.key, error.what());
  }
}

continuation::End BranchFollower::follow(const Task &task) {
  sink_.begin(task.number, task.halves, task.sign);
  const bool with_start = task.sign > 0 || rule_.directions == Directions::backward;
  const Branch branch = continuation::follow(
      *task.problem, task.start, rule_.continuation,
      {.point = progress_.part(task.start.point, with_start, static_cast<double>(tasks_.size()),
                               [&](const BranchPoint &point) { sink_.add(point); }),
       .special = [&](const SpecialPoint &special) { sink_.add(special); }},
      steps_);
  sink_.end(branch);
  progress_.finish();
  if (branch.end == continuation::End::shorter_return)
    forget(task, branch.points.back().point.keys[0]);
  if (task.level < rule_.levels)
    for (const SpecialPoint &special : branch.special)
      switch_at(task, special);
  return branch.end;
}

// A branch that begins at one special point and ends at another need not be followed from there.
void BranchFollower::forget(const Task &done, double key) {
  constexpr double same = 1e-6; // of the range; where a branch ends the key turns
  const continuation::Range &range = rule_.continuation.first_key;
  std::erase_if(tasks_, [&](const Task &task) {
    return &task != &done && task.level > 0 && task.level == done.level &&
           std::abs(task.key - key) < same * (range.upper - range.lower);
  });
}

// A branch that cannot be entered is left out with its reason; the special point stays.
void BranchFollower::switch_at(const Task &task, const SpecialPoint &special) {
  if (special.kind != continuation::Special::flip)
    return;
  const std::shared_ptr<Problem> doubled = task.problem->doubled();
  try {
    const continuation::Start start = recorded(
        steps_, "switch", [&] { return branch_from(*doubled, special, rule_.continuation); });
    tasks_.push_back({.problem = doubled,
                      .halves = 2 * task.halves,
                      .start = start,
                      .level = task.level + 1,
                      .key = special.at.point.keys[0]});
  } catch (const NumericalError &error) {
    sink_.note_missing(special.at.point.keys[0], error.what());
  }
}

} // namespace vibroimpact::analyses
