#include "motion/path/step_costs.h"

namespace vibroimpact::motion {

namespace {

/// Evaluations of the equations in an attempt of a step of order 8.
constexpr double evaluations = 14;
/// Attempts that locate a change.
constexpr double attempts_for_change = 2;
/// How much dearer the steps must be: others who look into the motion may pay for the change.
constexpr double margin = 2;

} // namespace

// The figures are times of single operations [ns], by trial on the machine that the benchmarks were
// made on.
double StepCosts::cost_of_attempt() const {
  const auto n = static_cast<double>(equations_.layout().n);
  const auto acting = static_cast<double>(equations_.n_acting());
  const auto contacts = static_cast<double>(equations_.layout().n_contacts);
  return evaluations * (105 + 7 * n + acting * (60 + 3.5 * n)) + 2600 + 52 * n +
         acting * (520 + 17 * n) + contacts * (175 + 3.5 * n);
}

void StepCosts::note_step(long attempts, bool changes) {
  const auto n = static_cast<double>(equations_.layout().n);
  const auto acting = static_cast<double>(equations_.n_acting());
  spent_ +=
      (static_cast<double>(attempts) + (changes ? attempts_for_change : 0)) * cost_of_attempt();
  by_moments_ += changes ? 1e4 + 1200 * n : 5e3 + 500 * n + acting * (6500 + 60 * n);
}

// Tables for a dozen lengths of steps have to be made first.
bool StepCosts::crowded() const {
  const double tables = 1e5 * static_cast<double>(equations_.layout().n);
  return spent_ > tables + margin * by_moments_;
}

} // namespace vibroimpact::motion
