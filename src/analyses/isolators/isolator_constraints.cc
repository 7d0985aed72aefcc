#include "analyses/isolators/isolator_constraints.h"

#include "analyses/isolators/isolator_averaging.h"
#include "common/error.h"
#include "common/scalar.h"
#include "common/zero.h"

#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

namespace vibroimpact::analyses {

namespace {

StopChoice choice_on_set(double z, const IsolatorDamping &damping, double ratio) {
  return stop_of(hysteresis_set(z, damping.rho()).at, damping, ratio);
}

// Where the resonance needs no more stiffness than the jump allows, from the side of small f, where
// the allowed amplitude does not reach the stop.
double first_possible_force(const StopConditions &conditions) {
  const double end = conditions.jump_limit == JumpLimit::averaged_response
                         ? 0
                         : force_where_set_ends(conditions.damping, conditions.unfolding_ratio);
  const double low = std::max(end, (1 + 1e-9) / conditions.allowed),
               high = conditions.largest_force();
  const auto excess = [&](double force) {
    const double least = conditions.least_stiffness(force);
    return std::log(std::max(least, 1e-12) / conditions.largest_stiffness(force));
  };
  if (!(low < high) || !(excess(high) <= 0))
    return nan;
  return excess(low) <= 0 ? low : zero_between(excess, low, high);
}

std::string in_words(const StopConditions &conditions) {
  std::ostringstream text;
  const double force = conditions.largest_force();
  text << "at the largest force that leaves the working frequency linear, f = " << force
       << ", the resonance needs mu >= " << conditions.least_stiffness(force)
       << " and must have mu <= " << conditions.largest_stiffness(force) << " in order not to jump";
  return text.str();
}

} // namespace

double transmissibility(double ratio, double damping_ratio) {
  const double dashpot = 2 * damping_ratio * ratio;
  return std::hypot(1, dashpot) / std::hypot(1 - square(ratio), dashpot);
}

// T^2 [(1 - s)^2 + 4 zeta^2 s] = 1 + 4 zeta^2 s with s = lambda^2: s^2 - 2 b s + 1 - 1/T^2 = 0.
double ratio_for_transmissibility(double transmissibility, double damping_ratio) {
  const double inverse = 1 / square(transmissibility);
  const double b = 1 + 2 * square(damping_ratio) * (inverse - 1);
  return std::sqrt(b + std::sqrt(square(b) - 1 + inverse));
}

double undamped_ratio_for_transmissibility(double transmissibility) {
  return std::sqrt(1 + 1 / transmissibility);
}

double largest_linear_force(double working_ratio, double damping_ratio) {
  return std::hypot(1 - square(working_ratio), 2 * damping_ratio * working_ratio);
}

double force_where_set_ends(const IsolatorDamping &damping, double ratio) {
  return choice_on_set(1, damping, ratio).force;
}

// f falls while z grows along H.
double stiffness_on_hysteresis_set(double force, const IsolatorDamping &damping, double ratio) {
  constexpr double least = 1e-4; // f is above 1e3 ratio (zeta_0 + zeta_1) there
  const auto excess = [&](double z) { return choice_on_set(z, damping, ratio).force - force; };
  if (!(excess(1) <= 0) || !(excess(least) > 0))
    return nan;
  return choice_on_set(zero_between(excess, least, 1), damping, ratio).stiffness;
}

double StopConditions::largest_force() const {
  return largest_linear_force(working_ratio, damping.isolator) / spare();
}

double StopConditions::least_stiffness(double force) const {
  const double amplitude = allowed * force;
  if (!(amplitude > 1))
    return std::numeric_limits<double>::infinity();
  return spare() * std::max(0.0, stiffness_for_peak(force, amplitude, damping));
}

double StopConditions::largest_stiffness(double force) const {
  if (jump_limit == JumpLimit::averaged_response) {
    const double first = stiffness_of_first_jump(force, damping);
    return std::isnan(first) ? std::numeric_limits<double>::infinity() : first / spare();
  }
  return stiffness_on_hysteresis_set(force, damping, unfolding_ratio) / spare();
}

StopCorners corners_of(const StopConditions &conditions) {
  const double least = first_possible_force(conditions), most = conditions.largest_force();
  if (!std::isfinite(least))
    return {{nan, nan}, {nan, nan}, {nan, nan}};
  return {.resonance_and_jump = {conditions.largest_stiffness(least), least},
          .linear_and_resonance = {conditions.least_stiffness(most), most},
          .linear_and_jump = {conditions.largest_stiffness(most), most}};
}

// The isolator alone responds with at most f/(2 zeta_0 sqrt(1 - zeta_0^2)).
StopChoice preferred_stop(const StopConditions &conditions, const StopCorners &corners,
                          Preference preference) {
  const double zeta = conditions.damping.isolator;
  if (2 * zeta * std::sqrt(1 - square(zeta)) * conditions.allowed >= 1)
    throw NumericalError("no stop is needed: the resonance of the isolator alone stays below the "
                         "allowed displacement.");
  if (!std::isfinite(corners.linear_and_resonance.force))
    throw NumericalError("no stop meets all conditions: " + in_words(conditions) + ".");
  if (preference == Preference::largest_clearance)
    return corners.resonance_and_jump;
  if (corners.linear_and_resonance.stiffness == 0)
    throw NumericalError("no least stiffness: the dashpot of the stop alone keeps the resonance "
                         "below the allowed displacement.");
  return corners.linear_and_resonance;
}

} // namespace vibroimpact::analyses
