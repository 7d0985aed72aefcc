// What a curve that is followed asks of the system it consists of, and the answers in the record of
// a run that may be interrupted.
//
// A system has `Node`, a point of the curve with everything that is known of it: u, chart, unit
// tangent, arclength, iterations, and `at` with the pattern and the chart's margin. The answers to
// these questions evaluate motions:
//
// | question | answer |
// |---|---|
// | first()           | the node at the start |
// | correct()         | a node on a hyperplane |
// | in_chart()        | the same node in another chart |
// | best_chart()      | where a node is furthest from the end of its chart |
// | special_points()  | those up to the next node, whose arclength becomes that through them |
// | behind_graze()    | how the curve goes on behind a graze that steps do not pass |
// | end_before()      | the end before the next node, if there is one |
// | end_at_steps()    | the end at a node behind which steps fall below the least one |
//
// Everything else follows from nodes, without an evaluation.
#pragma once

#include "common/recorded_step.h"
#include "continuation/curve.h"
#include "continuation/scaled_problem.h"
#include "continuation/settings.h"

#include <optional>

namespace vibroimpact::continuation {

/// An end of a key's range.
struct Bound {
  Index unknown;
  double value; ///< scaled
  bool upper;
};
/// The first key, by its number, that is beyond its range.
std::optional<Bound> bound_passed(const ScaledProblem &problem, const Settings &settings,
                                  const Vector &u);

/// Of two vectors of length 1 [rad].
double angle_between(const Vector &a, const Vector &b);

/// An end with what lies before it: a last point, and the special points up to it.
template <class Curve> struct Ending {
  End end;
  std::string reason;
  std::optional<typename Curve::Point> last{};
  std::vector<typename Curve::Special> special{};

  friend void members(auto &visit, As<Ending> auto &ending) {
    visit(ending.end, ending.reason, ending.last, ending.special);
  }
};

/// How a curve goes on behind a graze.
template <class Node, class Special> struct Behind {
  Vector graze;
  std::string guard;
  Node node;
  double step = 0;
  std::optional<std::vector<Special>> special; ///< none: not found

  friend void members(auto &visit, As<Behind> auto &behind) {
    visit(behind.graze, behind.guard, behind.node, behind.step, behind.special);
  }
};

/// A system whose answers are stored in a record, or taken from it, with what the problem remembers
/// then: one that learns from failures as well learns the same from those that are stored.
template <class System> class RecordedSystem : public System {
public:
  using Node = typename System::Node;

  /// Keeps a reference to the record, if there is one.
  template <class... Arguments>
  explicit RecordedSystem(StepRecord *record, Arguments &&...arguments)
      : System(std::forward<Arguments>(arguments)...), record_{record} {}

  Node first() const {
    return step("first node", [&] { return System::first(); });
  }
  Node correct(const Node &from, const Vector &guess, const Vector &normal, double largest) const {
    return step("point", [&] { return System::correct(from, guess, normal, largest); });
  }
  Node in_chart(const Node &node, double chart) const {
    return step("another chart", [&] { return System::in_chart(node, chart); });
  }
  double best_chart(const Node &node) const {
    return step("best chart", [&] { return System::best_chart(node); });
  }
  auto special_points(const Node &from, Node &next, bool closes) const {
    auto [special, arclength] = step("special points", [&] {
      auto found = System::special_points(from, next, closes);
      return std::pair(std::move(found), next.arclength);
    });
    next.arclength = arclength;
    return std::move(special);
  }
  auto behind_graze(const Node &from) const {
    return step("graze", [&] { return System::behind_graze(from); });
  }
  auto end_before(const Node &next, const auto &special) const {
    return step("end before", [&] { return System::end_before(next, special); });
  }
  auto end_at_steps(const Node &last, const std::string &why) const {
    return step("end at the least step", [&] { return System::end_at_steps(last, why); });
  }

private:
  template <class Compute> auto step(const char *kind, const Compute &compute) const {
    using Value = decltype(compute());
    Problem &problem = System::problem().problem();
    auto [outcome, remembered] = recorded(record_, kind, [&] {
      std::pair<std::optional<Value>, std::string> result;
      try {
        result.first = compute();
      } catch (const NumericalError &error) {
        result.second = error.what();
      }
      return std::pair(std::move(result), problem.remembered());
    });
    problem.remember(remembered);
    if (!outcome.first)
      throw NumericalError(outcome.second);
    return *std::move(outcome.first);
  }

  StepRecord *record_;
};

} // namespace vibroimpact::continuation
