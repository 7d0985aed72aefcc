#include "continuation/branch.h"

#include "common/signals.h"
#include "continuation/branch_system.h"
#include "continuation/curve_continuation.h"
#include "continuation/newton.h"
#include "continuation/stored_steps.h"

namespace vibroimpact::continuation {

std::string name_of(Special kind) {
  switch (kind) {
  case Special::fold:
    return "fold";
  case Special::branch_point:
    return "branch point";
  case Special::flip:
    return "flip";
  case Special::neimark_sacker:
    return "Neimark-Sacker";
  case Special::graze:
    return "graze";
  case Special::grazing_fold:
    return "grazing fold";
  case Special::pattern_change:
    return "change of pattern";
  }
  throw std::logic_error("a special point of no kind");
}

BranchPoint solve(Problem &problem, const Point &guess, const Settings &settings, double furthest) {
  const ScaledProblem scaled(problem, guess);
  const Index n = scaled.states();
  Vector u = scaled.scaled(guess);
  // Far from the solution corrections are cut to `furthest`; the rest is Newton's method with all
  // its checks.
  constexpr int most_cuts = 30;
  for (int cut = 0; cut < most_cuts; ++cut) {
    leave_if_stopped();
    const Linearisation at = scaled.evaluate(u, guess.chart);
    const Vector correction = solve_dense(at.slope.leftCols(n), -at.residual);
    if (correction.norm() <= furthest)
      break;
    u.head(n) += correction * (furthest / correction.norm());
  }
  const Vector key = Vector::Unit(scaled.unknowns(), n);
  Corrected corrected = correct(scaled, u, guess.chart, key, furthest, settings);
  return branch_point(scaled,
                      make_node(scaled, corrected.u, guess.chart, std::move(corrected.at), key));
}

Branch follow(Problem &problem, const Start &start, const Settings &settings,
              const CurveListener<Branch> &listener, StepRecord *record) {
  RecordedSystem<BranchSystem> system(record, problem, start, settings);
  return CurveContinuation(system, settings, listener).run();
}

Start branch_from(Problem &doubled, const SpecialPoint &flip, const Settings &settings) {
  const ScaledProblem problem(doubled, flip.at.point);
  const Vector u = problem.scaled(flip.at.point);
  Vector direction = Vector::Zero(u.size());
  direction.head(problem.states()) = flip.vector.col(0);
  const double distance = settings.switch_distance;
  const Corrected corrected = correct(problem, u + distance * direction, flip.at.point.chart,
                                      direction, distance, settings);
  const double least = settings.shorter_return;
  if (problem.nearest_return(corrected.u, flip.at.point.chart).first < least)
    throw NumericalError("the branch behind the flip is not found: Newton's method falls back");
  return {problem.point(corrected.u, flip.at.point.chart), direction, true};
}

} // namespace vibroimpact::continuation
