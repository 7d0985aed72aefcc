#include "parameters/dimension.h"

#include <array>
#include <sstream>
#include <vector>

namespace vibroimpact::parameters {

namespace {

struct Named {
  Dimension dimension;
  const char *name;
  const char *example;
};

const std::array named_dimensions{
    Named{dimension::none, "a pure number", "0.5"},
    Named{dimension::length, "a length", "5 mm"},
    Named{dimension::area, "an area", "20 mm^2"},
    Named{{.length = 3}, "a volume", "1 cm^3"},
    Named{dimension::second_moment, "a second moment of area", "4 cm^4"},
    Named{dimension::mass, "a mass", "50 g"},
    Named{dimension::rotary_inertia, "a moment of inertia", "0.01 kg m^2"},
    Named{dimension::density, "a density", "7850 kg/m^3"},
    Named{{.length = -2, .mass = 1}, "a mass per area", "20 kg/m^2"},
    Named{{.length = -1, .mass = 1}, "a mass per length", "2 kg/m"},
    Named{dimension::time, "a time", "20 ms"},
    Named{dimension::inverse_time, "an inverse time", "0.1/s"},
    Named{dimension::frequency, "a frequency", "3 Hz"},
    Named{{.time = -2, .angle = 1}, "an angular acceleration", "2 rad/s^2"},
    Named{dimension::angle, "an angle", "30 deg"},
    Named{dimension::velocity, "a velocity", "0.5 m/s"},
    Named{dimension::acceleration, "an acceleration", "9.81 m/s^2"},
    Named{dimension::force, "a force", "10 N"},
    Named{{.length = 1, .mass = 1, .time = -1}, "an impulse", "0.2 N s"},
    Named{dimension::torque, "a torque, an energy or a rotational stiffness", "2 N m"},
    Named{{.length = 2, .mass = 1, .time = -3}, "a power", "5 W"},
    Named{dimension::stress, "a stress", "206 GPa"},
    Named{dimension::stiffness, "a stiffness", "10 kN/m"},
    Named{dimension::hertz_stiffness, "a Hertz stiffness", "1e9 N/m^1.5"},
    Named{{.length = -2, .mass = 1, .time = -2}, "a cubic stiffness", "1e6 N/m^3"},
    Named{dimension::damping, "a damping", "5 N s/m"},
    Named{dimension::rotational_damping, "a rotational damping", "0.1 N m s"},
    Named{dimension::inverse_velocity, "an inverse velocity", "0.2 s/m"},
    Named{{.length = -1}, "an inverse length", "1/m"},
};

const Named *find_named(const Dimension &dimension) {
  for (const Named &named : named_dimensions)
    if (named.dimension == dimension)
      return &named;
  return nullptr;
}

struct Factor {
  std::string unit;
  double exponent;
};

std::string power(const std::string &unit, double exponent) {
  if (exponent == 1)
    return unit;
  std::ostringstream text;
  text << unit << '^' << exponent;
  return text.str();
}

std::string joined(const std::vector<std::string> &units) {
  std::string text;
  for (const std::string &unit : units)
    text += (text.empty() ? "" : " ") + unit;
  return text;
}

std::string fraction(const std::vector<Factor> &factors) {
  std::vector<std::string> above;
  std::vector<std::string> below;
  for (const Factor &factor : factors) {
    if (factor.exponent > 1e-9)
      above.push_back(power(factor.unit, factor.exponent));
    else if (factor.exponent < -1e-9)
      below.push_back(power(factor.unit, -factor.exponent));
  }
  std::string numerator = above.empty() ? "1" : joined(above);
  if (below.empty())
    return numerator;
  return numerator + "/" + (below.size() == 1 ? below.front() : "(" + joined(below) + ")");
}

} // namespace

std::string si_unit(const Dimension &dimension) {
  if (dimension.any)
    return "depends on other keys";
  if (dimension == dimension::stress)
    return "Pa";
  if (dimension == Dimension{.length = 2, .mass = 1, .time = -3})
    return "W";
  const bool with_newton =
      dimension.mass == 1 && (dimension.time == -2 || dimension.time == -1) && dimension.angle == 0;
  if (with_newton)
    return fraction({{"N", 1}, {"m", dimension.length - 1}, {"s", dimension.time + 2}});
  return fraction({{"kg", dimension.mass},
                   {"rad", dimension.angle},
                   {"m", dimension.length},
                   {"s", dimension.time}});
}

std::string described(const Dimension &dimension) {
  if (dimension.any)
    return "a number whose unit depends on other keys";
  const Named *named = find_named(dimension);
  return std::string(named != nullptr ? named->name : "a quantity") + " [" + si_unit(dimension) +
         "]";
}

std::string example_value(const Dimension &dimension) {
  const Named *named = find_named(dimension);
  if (named != nullptr)
    return named->example;
  const std::string unit = si_unit(dimension);
  return unit.starts_with("1/") ? unit : "1 " + unit;
}

} // namespace vibroimpact::parameters
