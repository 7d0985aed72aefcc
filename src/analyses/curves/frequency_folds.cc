#include "analyses/curves/frequency_folds.h"

#include "common/error.h"
#include "common/zero.h"
#include "continuation/newton.h"
#include "continuation/node.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

using continuation::BranchPoint;
using continuation::Corrected;
using continuation::ScaledProblem;

namespace {

constexpr double frequency_rounding = 1e-9; // of the frequency, which linear motions keep
// Of the way to the neighbours; the difference is exact but for its fourth power.
constexpr double difference_step = 2e-2;
constexpr int fold_digits =
    26; // binary, of the way; where the frequency turns they give all of its own

} // namespace

bool FrequencyFolds::turns() const {
  if (last_.size() < 3)
    return false;
  const auto beside = [&](const Seen &other) {
    return other.at.point.chart == last_[1].at.point.chart &&
           other.at.pattern == last_[1].at.pattern;
  };
  const double before = last_[1].frequency - last_[0].frequency;
  const double after = last_[2].frequency - last_[1].frequency;
  const double least = frequency_rounding * last_[1].frequency;
  return beside(last_[0]) && beside(last_[2]) && before * after < 0 && std::abs(before) > least &&
         std::abs(after) > least;
}

BranchPoint FrequencyFolds::located(periodic::EnergyOrbits &motions) const {
  const BranchPoint &middle = last_[1].at;
  const ScaledProblem problem(motions, middle.point);
  const Vector from = problem.scaled(middle.point);
  const auto at = [&](double way) {
    return correct(problem, from + way * middle.tangent, middle.point.chart, middle.tangent,
                   settings_.longest_step, settings_, continuation::Until::rounding);
  };
  const double back = middle.tangent.dot(problem.scaled(last_[0].at.point) - from);
  const double ahead = middle.tangent.dot(problem.scaled(last_[2].at.point) - from);
  const double h = difference_step * std::min(-back, ahead);
  const auto frequency = [&](double way) {
    return 1 / motions.period(problem.point(at(way).u, middle.point.chart));
  };
  const auto rise = [&](double way) {
    return (8 * (frequency(way + h) - frequency(way - h)) -
            (frequency(way + 2 * h) - frequency(way - 2 * h))) /
           (12 * h);
  };
  Corrected found = at(zero_between(rise, back, ahead, fold_digits));
  BranchPoint fold = branch_point(problem, make_node(problem, found.u, middle.point.chart,
                                                     std::move(found.at), middle.tangent));
  fold.arclength = middle.arclength + middle.tangent.dot(found.u - from);
  return fold;
}

std::optional<BranchPoint> FrequencyFolds::next(periodic::EnergyOrbits &motions,
                                                const BranchPoint &point) {
  last_.push_back({point, 1 / motions.period(point.point)});
  if (last_.size() > 3)
    last_.pop_front();
  if (!turns())
    return std::nullopt;
  try {
    return located(motions);
  } catch (const NumericalError &) {
    return std::nullopt;
  }
}

} // namespace vibroimpact::analyses
