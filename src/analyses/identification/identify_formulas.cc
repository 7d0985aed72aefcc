#include "analyses/identification/identify_formulas.h"

#include "common/scalar.h"
#include "common/zero.h"
#include "contact/restitution_relation.h"

#include <boost/math/special_functions/log1p.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::analyses {

namespace {

constexpr double smallest_restitution = 1e-6;

// Integral of w/(1 + d w) over w from v to 1. With u' = w v_c it is the energy that has left the
// relative motion: u'' = -lambda k u^n (1 + d u') gives
//   lambda k u^(n+1) / ((n+1) v_c^2) = G(u'/v_c)
double spent_energy(double d, double v) {
  if (d == 0)
    return 0.5 * (1 - v * v);
  // An antiderivative is [d w - ln(1 + d w)] / d^2.
  return (boost::math::log1pmx(d * v) - boost::math::log1pmx(d)) / (d * d);
}

// u'/v_c at the largest force: the derivative of u^n (1 + d u') vanishes where
// v = (n+1)/n d G(v). The left side rises and the right side falls from v = 0 to 1.
double speed_at_peak(double d, double exponent) {
  if (d == 0)
    return 0;
  const auto mismatch = [d, exponent](double v) {
    return exponent / (exponent + 1) * v - d * spent_energy(d, v);
  };
  return zero_between(mismatch, 0, 1);
}

double printed_lowest_ratio(double compliance) { return compliance * (2 - compliance); }
double printed_restitution(double ratio, double compliance, double /*exponent*/) {
  return 2 / (compliance + std::sqrt(ratio - printed_lowest_ratio(compliance))) - 1;
}

double corrected_restitution(double ratio, double /*compliance*/, double /*exponent*/) {
  return 2 / (1 + std::sqrt(ratio - 1)) - 1;
}

double exact_set_restitution(double ratio, double /*compliance*/, double exponent) {
  return free_collision_restitution(ratio, exponent);
}
double unit_lowest_ratio(double /*compliance*/) { return 1; }

double balanced_damping(double e) { return 0.75 * (1 - e * e); }

double exact_damping(double e) {
  if (e == 0)
    return std::numeric_limits<double>::infinity();
  return std::isnan(e) ? nan : contact::dimensionless_damping("exact", e);
}

// All combinations of the four quantities at the ends of their intervals.
constexpr unsigned interval_corners = 1U << 4U;
double at_corner(double value, double uncertainty, unsigned corner, unsigned bit) {
  return value * ((corner >> bit & 1U) != 0 ? 1 + uncertainty : 1 - uncertainty);
}

} // namespace

const std::array<FormulaSet, n_formula_sets> &formula_sets() {
  static constexpr std::array<FormulaSet, n_formula_sets> sets = {{
      {"printed", printed_restitution, printed_lowest_ratio, balanced_damping},
      {"corrected", corrected_restitution, unit_lowest_ratio, balanced_damping},
      {"exact", exact_set_restitution, unit_lowest_ratio, exact_damping},
  }};
  return sets;
}

double pulse_ratio(const PulseFigures &pulse, const ContactConstants &contact) {
  const double n = contact.exponent;
  const double energy =
      contact.stiffness / (n + 1) * std::pow(pulse.peak_force / contact.stiffness, (n + 1) / n);
  return 8 * energy / (pulse.impulse * pulse.impulse * contact.compliance);
}

double free_collision_ratio(double restitution, double exponent) {
  const double d = contact::dimensionless_damping("exact", restitution);
  const double v = speed_at_peak(d, exponent);
  // f_m = k u^n (1 + d u') with u from spent_energy, J = (1 + e) v_c / lambda
  return 8 * spent_energy(d, v) * std::pow(1 + d * v, (exponent + 1) / exponent) /
         ((1 + restitution) * (1 + restitution));
}

double free_collision_restitution(double ratio, double exponent) {
  if (!(ratio >= 1))
    return nan;
  if (ratio == 1)
    return 1;
  if (ratio >= free_collision_ratio(smallest_restitution, exponent))
    return 0;
  const auto mismatch = [ratio, exponent](double e) {
    return free_collision_ratio(e, exponent) - ratio;
  };
  return zero_between(mismatch, smallest_restitution, 1, 50);
}

Identified identify(const FormulaSet &set, const PulseFigures &pulse,
                    const ContactConstants &contact, const Scales &scales) {
  const double e = set.restitution(pulse_ratio(pulse, contact),
                                   scales.dimensionless(contact.compliance), contact.exponent);
  const double approach_speed = pulse.impulse * contact.compliance / (1 + e);
  return {.restitution = e,
          .approach_speed = approach_speed,
          .damping_factor = contact.stiffness * set.dimensionless_damping(e) / approach_speed};
}

Interval restitution_interval(const FormulaSet &set, const PulseFigures &pulse,
                              const ContactConstants &contact, const Scales &scales,
                              const Uncertainties &uncertainties) {
  Interval interval{.low = std::numeric_limits<double>::infinity(),
                    .high = -std::numeric_limits<double>::infinity()};
  bool solvable = false;
  for (unsigned corner = 0; corner < interval_corners; ++corner) {
    const PulseFigures shown{.impulse = at_corner(pulse.impulse, uncertainties.impulse, corner, 0),
                             .peak_force =
                                 at_corner(pulse.peak_force, uncertainties.peak_force, corner, 1)};
    const ContactConstants known{
        .compliance = at_corner(contact.compliance, uncertainties.compliance, corner, 2),
        .stiffness = at_corner(contact.stiffness, uncertainties.stiffness, corner, 3),
        .exponent = contact.exponent};
    const double ratio = pulse_ratio(shown, known);
    const double compliance = scales.dimensionless(known.compliance);
    const double lowest_ratio = set.lowest_ratio(compliance);
    solvable = solvable || ratio >= lowest_ratio;
    const double e = set.restitution(std::max(ratio, lowest_ratio), compliance, contact.exponent);
    interval.low = std::min(interval.low, e);
    interval.high = std::max(interval.high, e);
  }
  if (!solvable)
    return {.low = nan, .high = nan};
  return interval;
}

} // namespace vibroimpact::analyses
