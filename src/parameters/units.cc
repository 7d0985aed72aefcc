#include "parameters/units.h"

#include <array>
#include <cmath>
#include <numbers>

namespace vibroimpact::parameters {

namespace {

struct Unit {
  const char *name;
  UnitFactor factor;
};

constexpr double pi = std::numbers::pi;

// The micro sign has two code points, U+00B5 and the Greek letter U+03BC; keyboards produce both.
const std::array units{
    Unit{"m", {1, 1, dimension::length}},
    Unit{"mm", {1, 1e3, dimension::length}},
    Unit{"cm", {1, 1e2, dimension::length}},
    Unit{"um", {1, 1e6, dimension::length}},
    Unit{"\u00b5m", {1, 1e6, dimension::length}},
    Unit{"\u03bcm", {1, 1e6, dimension::length}},
    Unit{"nm", {1, 1e9, dimension::length}},
    Unit{"km", {1e3, 1, dimension::length}},
    Unit{"kg", {1, 1, dimension::mass}},
    Unit{"g", {1, 1e3, dimension::mass}},
    Unit{"t", {1e3, 1, dimension::mass}},
    Unit{"s", {1, 1, dimension::time}},
    Unit{"ms", {1, 1e3, dimension::time}},
    Unit{"us", {1, 1e6, dimension::time}},
    Unit{"\u00b5s", {1, 1e6, dimension::time}},
    Unit{"\u03bcs", {1, 1e6, dimension::time}},
    Unit{"min", {60, 1, dimension::time}},
    Unit{"h", {3600, 1, dimension::time}},
    Unit{"rad", {1, 1, dimension::angle}},
    Unit{"deg", {pi, 180, dimension::angle}},
    Unit{"Hz", {2 * pi, 1, dimension::frequency}},
    Unit{"kHz", {2e3 * pi, 1, dimension::frequency}},
    Unit{"MHz", {2e6 * pi, 1, dimension::frequency}},
    Unit{"rpm", {2 * pi, 60, dimension::frequency}},
    Unit{"N", {1, 1, dimension::force}},
    Unit{"mN", {1, 1e3, dimension::force}},
    Unit{"kN", {1e3, 1, dimension::force}},
    Unit{"MN", {1e6, 1, dimension::force}},
    Unit{"Nm", {1, 1, dimension::torque}},
    Unit{"kNm", {1e3, 1, dimension::torque}},
    Unit{"Nmm", {1, 1e3, dimension::torque}},
    Unit{"Ns", {1, 1, {.length = 1, .mass = 1, .time = -1}}},
    Unit{"Pa", {1, 1, dimension::stress}},
    Unit{"kPa", {1e3, 1, dimension::stress}},
    Unit{"MPa", {1e6, 1, dimension::stress}},
    Unit{"GPa", {1e9, 1, dimension::stress}},
    Unit{"J", {1, 1, dimension::torque}},
    Unit{"W", {1, 1, {.length = 2, .mass = 1, .time = -3}}},
    Unit{"g0", {980665, 1e5, dimension::acceleration}}, // standard gravity, exact by definition
    Unit{"%", {1, 1e2, dimension::none}},
};

} // namespace

const UnitFactor *find_unit(std::string_view name) {
  for (const Unit &unit : units)
    if (name == unit.name)
      return &unit.factor;
  return nullptr;
}

std::vector<std::string> unit_names() {
  std::vector<std::string> names;
  names.reserve(units.size());
  for (const Unit &unit : units)
    names.emplace_back(unit.name);
  return names;
}

UnitFactor raised(const UnitFactor &unit, double exponent) {
  const Dimension &d = unit.dimension;
  const Dimension dimension{.length = d.length * exponent,
                            .mass = d.mass * exponent,
                            .time = d.time * exponent,
                            .angle = d.angle * exponent};
  if (exponent < 0)
    return {std::pow(unit.denominator, -exponent), std::pow(unit.numerator, -exponent), dimension};
  return {std::pow(unit.numerator, exponent), std::pow(unit.denominator, exponent), dimension};
}

UnitFactor product(const UnitFactor &a, const UnitFactor &b) {
  return {a.numerator * b.numerator,
          a.denominator * b.denominator,
          {.length = a.dimension.length + b.dimension.length,
           .mass = a.dimension.mass + b.dimension.mass,
           .time = a.dimension.time + b.dimension.time,
           .angle = a.dimension.angle + b.dimension.angle}};
}

} // namespace vibroimpact::parameters
