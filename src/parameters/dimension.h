// Physical dimensions of parameter values: exponents of length, mass, time and angle.
#pragma once

#include <string>

namespace vibroimpact::parameters {

/// Exponents of metre, kilogram, second and radian. Angles are kept as a dimension of their own so
/// that a frequency has to say Hz or rad/s; for every other quantity the radian counts as 1.
struct Dimension {
  int length = 0;
  int mass = 0;
  int time = 0;
  int angle = 0;
  bool unchecked = false;
  bool operator==(const Dimension &) const = default;
};

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension length{.length = 1};
inline constexpr Dimension area{.length = 2};
inline constexpr Dimension second_moment{.length = 4};
inline constexpr Dimension mass{.mass = 1};
inline constexpr Dimension rotary_inertia{.length = 2, .mass = 1};
inline constexpr Dimension density{.length = -3, .mass = 1};
inline constexpr Dimension time{.time = 1};
inline constexpr Dimension inverse_time{.time = -1};
inline constexpr Dimension frequency{.time = -1, .angle = 1}; ///< inside: rad/s
inline constexpr Dimension angle{.angle = 1};
inline constexpr Dimension velocity{.length = 1, .time = -1};
inline constexpr Dimension acceleration{.length = 1, .time = -2};
inline constexpr Dimension force{.length = 1, .mass = 1, .time = -2};
inline constexpr Dimension torque{.length = 2, .mass = 1, .time = -2};
inline constexpr Dimension stress{.length = -1, .mass = 1, .time = -2};
inline constexpr Dimension stiffness{.mass = 1, .time = -2};
inline constexpr Dimension rotational_stiffness{.length = 2, .mass = 1, .time = -2};
inline constexpr Dimension damping{.mass = 1, .time = -1};
inline constexpr Dimension rotational_damping{.length = 2, .mass = 1, .time = -1};
inline constexpr Dimension inverse_velocity{.length = -1, .time = 1};
/// The dimension depends on another key: read with Values::quantity_of.
inline constexpr Dimension unchecked{.unchecked = true};
} // namespace dimension

/// The coherent SI unit, for messages and the manual: "N/m", "kg/m^3", "1", "rad/s".
std::string si_unit(const Dimension &dimension);

} // namespace vibroimpact::parameters
