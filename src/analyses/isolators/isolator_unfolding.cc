#include "analyses/isolators/isolator_unfolding.h"

#include "common/scalar.h"
#include "common/zero.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace vibroimpact::analyses {

namespace {

using std::numbers::pi;

// G(1) = W^2 + A (1 - rho) + alpha_2 = 0 and G_z(1) = W - rho A + 2 alpha_2 = 0 with A = alpha_1^2,
// W = u(1) + eta and u'(1) = 1/2: 4 alpha_2^2 + (1 - 4 rho A) alpha_2 + rho^2 A^2 + A (1 - rho) =
// 0.
double set_b3(double first, double rho, double sign) {
  const double a = square(first);
  return (4 * rho * a - 1 + sign * std::sqrt(1 - 16 * a + 8 * rho * a)) / 8;
}

} // namespace

const double largest_damping_ratio = 4 / pi - 1;

double IsolatorDamping::rho() const { return 8 / (pi * (1 + sigma())); }

UnfoldingParameters unfolding_of(const StopChoice &stop, const IsolatorDamping &damping,
                                 double ratio) {
  const double first = pi * ratio * (damping.stop + damping.isolator) / (2 * stop.stiffness);
  return {.first = first,
          .second =
              square(damping.rho() * first / 2) - square(pi * stop.force / (4 * stop.stiffness))};
}

StopChoice stop_of(const UnfoldingParameters &at, const IsolatorDamping &damping, double ratio) {
  const double stiffness = pi * ratio * (damping.stop + damping.isolator) / (2 * at.first);
  const double left = set_b2(at.first, damping.rho()) - at.second;
  return {.stiffness = stiffness, .force = 4 * stiffness / pi * std::sqrt(left)};
}

double set_b2(double first, double rho) { return square(rho * first / 2); }
double set_b3_plus(double first, double rho) { return set_b3(first, rho, 1); }
double set_b3_minus(double first, double rho) { return set_b3(first, rho, -1); }

// With W = u + eta: G_zz = 0 gives W = (u'^2 + alpha_2)/z, as u'' = -z; G_z = 0 then
// A = 2 (u' (u'^2 + alpha_2) + alpha_2 z^2)/(rho z), and G = 0 a quadratic equation for alpha_2.
// Put
//
//   alpha_2 = u'^2 (z^2/v - 1) + z^2 w,   v = u' + z^2,   c = 2/rho - 2 z:
//   z w^2 + (z (2 u'^2/v + z^2) + c v) w - u'^3 z^3/v^2 = 0,    A = 2 z v w / rho.
//
// The last term is negative: one root is positive, and it alone has A > 0. Nothing cancels as z ->
// 0, where w -> z^3 rho/2, nor at rho z = 1, where G = 0 cannot be solved for A.
HysteresisPoint hysteresis_set(double z, double rho) {
  const double slope = 1 - square(z) / 2;
  const double v = slope + square(z);
  const double b = z * (2 * square(slope) / v + square(z)) + (2 / rho - 2 * z) * v;
  const double c = slope * square(slope) * z * square(z) / square(v);
  const double root = std::sqrt(square(b) + 4 * z * c);
  const double w = b > 0 ? 2 * c / (b + root) : (root - b) / (2 * z);
  const double second = square(slope) * (square(z) / v - 1) + square(z) * w;
  const double backbone = z - z * square(z) / 6;
  const double side = z * (square(slope) / v + w); // W
  return {.z = z,
          .at = {.first = std::sqrt(2 * z * v * w / rho), .second = second},
          .eta = side - backbone};
}

HysteresisPoint hysteresis_above(double first, double rho) {
  constexpr double least = 1e-4;
  const auto distance = [&](double z) { return hysteresis_set(z, rho).at.first - first; };
  const double at_least = distance(least), at_one = distance(1);
  if (at_least > 0 || at_one < 0)
    throw std::domain_error("no point of the hysteresis set has this alpha_1");
  if (at_one == 0)
    return hysteresis_set(1, rho);
  return hysteresis_set(zero_between(distance, least, 1), rho);
}

std::string name_of(Region region) {
  switch (region) {
  case Region::none:
    break;
  case Region::one:
    return "I";
  case Region::two:
    return "II";
  case Region::three:
    return "III";
  case Region::four:
    return "IV";
  }
  return "none";
}

// On H itself the two folds are one point: it counts to IV, as a stop does that is put there and
// rounded.
Region region_of(const UnfoldingParameters &at, double rho) {
  if (!(at.second < set_b2(at.first, rho)))
    return Region::none;
  if (at.second > set_b3_plus(at.first, rho))
    return Region::one;
  if (at.second > set_b3_minus(at.first, rho))
    return Region::two;
  constexpr double on_set = 1e-9;
  const double z_least = 1e-3; // there alpha_1 is below 1e-6
  if (at.first <= hysteresis_set(z_least, rho).at.first)
    return at.second > -1 + on_set ? Region::three : Region::four;
  if (at.first >= hysteresis_set(1, rho).at.first)
    return Region::four;
  return at.second > hysteresis_above(at.first, rho).at.second + on_set ? Region::three
                                                                        : Region::four;
}

int folds_in(Region region) {
  switch (region) {
  case Region::one:
  case Region::three:
    return 2;
  case Region::two:
    return 1;
  case Region::none:
  case Region::four:
    break;
  }
  return 0;
}

UnfoldingParameters example_of(Region region, double rho) {
  const double first = hysteresis_set(1, rho).at.first / 2;
  const double b3_minus = set_b3_minus(first, rho), b3_plus = set_b3_plus(first, rho);
  const double hysteresis = hysteresis_above(first, rho).at.second;
  switch (region) {
  case Region::one:
    return {first, (set_b2(first, rho) + b3_plus) / 2};
  case Region::two:
    return {first, (b3_plus + b3_minus) / 2};
  case Region::three:
    return {first, (b3_minus + hysteresis) / 2};
  case Region::four:
    return {first, 2 * hysteresis - b3_minus};
  case Region::none:
    break;
  }
  throw std::logic_error("no example of no region");
}

} // namespace vibroimpact::analyses
