#include "cantilever.h"

#include <boost/math/tools/roots.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace vibroimpact::benchmarks {

namespace {

// The j-th eigenvalue (from 1) lies between that of a beam held at the tip too, at its left, and
// that of the bare beam.
double eigenvalue(double mass_ratio, int j) {
  // Divided by cosh, which would overflow the digits of the higher modes.
  const auto characteristic = [&](double b) {
    return 1 / std::cosh(b) + std::cos(b) +
           mass_ratio * b * (std::cos(b) * std::tanh(b) - std::sin(b));
  };
  const double pi = std::numbers::pi;
  const double lower = j == 1 ? 1e-3 : (j - 1) * pi;
  const double upper = (j - 0.5) * pi + (j == 1 ? 0.31 : 0.1);
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      characteristic, lower, upper, boost::math::tools::eps_tolerance<double>(52), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

} // namespace

CantileverModes cantilever_modes(const Cantilever &beam, int count) {
  const double beam_mass = beam.mass_per_length * beam.length;
  const double m = beam.tip_mass / beam_mass;
  const double unit = std::sqrt(beam.bending / (beam_mass * std::pow(beam.length, 3)));
  CantileverModes modes{.angular_frequency = Vector(count), .tip_displacement = Vector(count)};
  for (int j = 0; j < count; ++j) {
    const double b = eigenvalue(m, j + 1);
    const double slope =
        b * std::tanh(b) * std::sin(b) / (std::sin(b) - std::cos(b) * std::tanh(b));
    const double modal_mass = beam_mass * (1 + m + 2 * m * slope) / 4;
    modes.angular_frequency[j] = unit * b * b;
    modes.tip_displacement[j] = 1 / std::sqrt(modal_mass);
  }
  return modes;
}

} // namespace vibroimpact::benchmarks
