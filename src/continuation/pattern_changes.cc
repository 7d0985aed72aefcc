#include "continuation/pattern_changes.h"

#include "continuation/newton.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::continuation {

namespace {

constexpr double shortest_part = 1e-8; // patterns change to and fro by rounding within 1e-9
constexpr int most_parts = 100;        // of a step
constexpr double worth_a_trial = 0.2;  // of the length at which no graze was found

double length_of(const Node &begin, const Node &end) { return (end.u - begin.u).norm(); }

// The pattern at a hundredth of the way from the graze is that of the node: no other change lies
// between.
bool leads_to_graze(const ScaledProblem &problem, const Node &node, const LocatedGraze &graze) {
  constexpr double share = 0.01;
  const Vector way = node.u - graze.u;
  if (way.norm() < shortest_part)
    return true;
  try {
    return problem.evaluate(graze.u + share * way, graze.chart).pattern == node.at.pattern;
  } catch (const NumericalError &) {
    return true; // the solutions themselves decide
  }
}

class ChangesOfAStep {
public:
  ChangesOfAStep(const ScaledProblem &problem, const Settings &settings)
      : problem_{problem}, settings_{settings} {}

  std::vector<SpecialPoint> whole(const Node &begin, Node &end) {
    auto grazes = grazes_between(problem_, begin, end, settings_);
    if (grazes.size() > 1)
      throw NumericalError("several guards touch zero within a step");
    if (grazes.size() == 1 && explains(begin, grazes.front(), end)) {
      const Vector &at = grazes.front().u;
      end.arclength = begin.arclength + (at - begin.u).norm() + (end.u - at).norm();
      return special_points_across(problem_, begin, grazes.front(), end, settings_);
    }
    return halves(begin, end, length_of(begin, end));
  }

private:
  bool explains(const Node &begin, const LocatedGraze &graze, const Node &end) const {
    return leads_to_graze(problem_, begin, graze) && leads_to_graze(problem_, end, graze);
  }

  std::vector<SpecialPoint> part(const Node &begin, Node &end, double tried) {
    if (begin.at.pattern == end.at.pattern)
      return special_points(problem_, Piece(problem_, settings_, begin, end), settings_);
    const double length = length_of(begin, end);
    const bool last = length < shortest_part || parts_ >= most_parts;
    if (last || length <= worth_a_trial * tried) {
      if (auto found = graze_in(begin, end, last))
        return *std::move(found);
      tried = length;
    }
    return last ? enclosed(begin, end) : halves(begin, end, tried);
  }

  std::vector<SpecialPoint> halves(const Node &begin, Node &end, double tried) {
    Node middle;
    try {
      middle = Piece(problem_, settings_, begin, end).at(0.5);
    } catch (const NumericalError &) {
      return enclosed(begin, end);
    }
    ++parts_;
    auto found = part(begin, middle, tried);
    end.arclength = middle.arclength + length_of(middle, end);
    const auto behind = part(middle, end, tried);
    found.insert(found.end(), behind.begin(), behind.end());
    return found;
  }

  // The section of a motion may lie in the dip of a guard, which is seen in another chart only.
  std::optional<std::vector<SpecialPoint>> graze_in(const Node &begin, Node &end, bool last) const {
    if (auto found = across(begin, end, last))
      return found;
    if (std::min(begin.at.chart_margin, end.at.chart_margin) >= settings_.margin_at_changes)
      return std::nullopt;
    const Node &seen = begin.at.chart_margin < end.at.chart_margin ? begin : end;
    try {
      const double chart = problem_.problem().best_chart(problem_.point(seen.u, seen.chart));
      if (chart == seen.chart)
        return std::nullopt;
      const Node first = in_chart(problem_, begin, chart, settings_);
      Node second = in_chart(problem_, end, chart, settings_);
      return across(first, second, last);
    } catch (const NumericalError &) {
      return std::nullopt;
    }
  }

  std::optional<std::vector<SpecialPoint>> across(const Node &begin, const Node &end,
                                                  bool last) const {
    const auto grazes = grazes_between(problem_, begin, end, settings_);
    if (grazes.size() != 1 || !(last || explains(begin, grazes.front(), end)))
      return std::nullopt;
    try {
      return special_points_across(problem_, begin, grazes.front(), end, settings_);
    } catch (const NumericalError &) {
      return std::nullopt;
    }
  }

  std::vector<SpecialPoint> enclosed(const Node &begin, const Node &end) const {
    auto found = special_points(problem_, Piece(problem_, settings_, begin, end), settings_);
    found.push_back(make_special(problem_, Special::pattern_change, end, begin, end));
    const Index key = problem_.states();
    found.back().width = std::abs(end.u(key) - begin.u(key)) * problem_.scales()(key);
    return found;
  }

  const ScaledProblem &problem_;
  const Settings &settings_;
  int parts_ = 0;
};

} // namespace

Node in_chart(const ScaledProblem &problem, const Node &node, double chart,
              const Settings &settings) {
  Matrix tangent = node.tangent;
  const Vector u = problem.transfer(node.u, node.chart, chart, tangent);
  tangent.col(0).normalize();
  Corrected corrected = correct(problem, u, chart, tangent, settings.longest_step, settings);
  Node moved = make_node(problem, corrected.u, chart, std::move(corrected.at), tangent);
  moved.arclength = node.arclength;
  return moved;
}

std::vector<SpecialPoint> special_points_and_changes(const ScaledProblem &problem,
                                                     const Node &begin, Node &end,
                                                     const Settings &settings) {
  return ChangesOfAStep(problem, settings).whole(begin, end);
}

} // namespace vibroimpact::continuation
