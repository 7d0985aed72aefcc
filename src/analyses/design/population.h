// A population of trial points that evolves towards the least value of one objective, or towards
// the Pareto front of several.
//
// Differential evolution, current-to-pbest/1/bin [zhang2009jade]: from a member x and one of the
// best, p, and two others a and b,
//
//   v = x + F (p - x) + F (a - b),
//
// of which each coordinate replaces that of x with the probability C, at least one does. F is drawn
// anew for each trial from [0.1, 0.9], C = 0.7. Coordinates beyond a bound are put onto it. Of one
// objective, a trial takes the place of x where it is no worse [storn1997differential]; of several,
// it joins the members, and the one leaves that is dominated most or lies closest to its neighbours
// on the front [deb2002nsga]. A trial that meets the constraints is better than one that does not;
// of two that do not, that which misses them by less [deb2000constraints]; a failed one is worst.
//
// Trial k depends on the outcomes of the trials up to k - N alone, N being the size of the
// population. N trials can therefore be computed at once, in any order on any ranks, and the search
// is the same.
#pragma once

#include "common/linear_algebra.h"

#include <cstdint>
#include <vector>

namespace vibroimpact::analyses {

/// What a trial point gave.
struct TrialValue {
  bool failed = false;
  double excess = 0;         ///< by how much constraints are missed; 0 where all are met
  std::vector<double> goals; ///< to be small; any values where it failed
};

/// Is `a` better than `b`: in the order above and, among those that meet all constraints, no worse
/// in any and better in one objective?
bool dominates(const TrialValue &a, const TrialValue &b);
/// Positions of those that none of the others dominates and that did not fail.
std::vector<std::size_t> not_dominated(const std::vector<TrialValue> &values);

class Population {
public:
  struct Settings {
    std::size_t size = 0;      ///< N, at least 4
    Vector start;              ///< trial 0; as many coordinates as there are keys, in [0, 1]
    std::uint64_t seed = 0;    ///< of what is drawn at random
    std::size_t number = 0;    ///< of the search: equal seeds and numbers give equal trials
    double tolerance = 0;      ///< of the coordinates
    double goal_tolerance = 0; ///< relative, of a single objective; 0 for none
  };
  explicit Population(Settings settings);

  std::size_t size() const { return settings_.size; }
  /// Coordinates of trial k, when all trials up to k - N have been taken in. The first N are spread
  /// over the box as a Latin hypercube.
  Vector propose(std::size_t trial) const;
  /// Trials are taken in by their number, some may be left out.
  void take_in(std::size_t trial, Vector coordinates, TrialValue value);
  /// Of the members.
  std::vector<Vector> coordinates() const;
  /// Of a single objective: the members lie within the tolerance, or their values do.
  bool converged() const;

private:
  struct Member {
    Vector coordinates;
    TrialValue value;
  };
  Vector first_trial(std::size_t trial) const;
  std::vector<std::size_t> best() const;
  void remove_the_worst();

  Settings settings_;
  std::vector<Member> members_;
};

} // namespace vibroimpact::analyses
