// The table of units a value may carry.
#pragma once

#include "parameters/dimension.h"

#include <string>
#include <string_view>
#include <vector>

namespace vibroimpact::parameters {

/// Kept as a fraction, so that "7 mm" is the double nearest to 0.007 and not 7 times a rounded
/// thousandth.
struct UnitFactor {
  double numerator = 1;
  double denominator = 1;
  Dimension dimension{};

  double times(double number) const { return number * numerator / denominator; }
};

/// Null for an unknown unit. Names are case-sensitive: mN and MN differ.
const UnitFactor *find_unit(std::string_view name);

/// In the order of the table, for suggestions and the manual.
std::vector<std::string> unit_names();

/// a^exponent and a*b for composed units.
UnitFactor raised(const UnitFactor &unit, double exponent);
UnitFactor product(const UnitFactor &a, const UnitFactor &b);

} // namespace vibroimpact::parameters
