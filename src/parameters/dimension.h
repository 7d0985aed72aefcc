// Physical dimensions of parameter values: exponents of length, mass, time and angle.
#pragma once

#include <string>

namespace vibroimpact::parameters {

/// Exponents of metre, kilogram, second and radian; they need not be whole (a Hertz stiffness has
/// N/m^1.5). Angles are kept as a dimension of their own so that a frequency has to say Hz or
/// rad/s; where length or mass is involved the radian counts as 1.
struct Dimension {
  double length = 0;
  double mass = 0;
  double time = 0;
  double angle = 0;
  bool any = false; ///< of a key whose unit depends on other keys; no value has it

  /// Exponents come out of products and roots: they are equal when they agree to 1e-9.
  constexpr bool operator==(const Dimension &other) const {
    return any == other.any && equal(length, other.length) && equal(mass, other.mass) &&
           equal(time, other.time) && equal(angle, other.angle);
  }

private:
  static constexpr bool equal(double a, double b) { return a - b < 1e-9 && b - a < 1e-9; }
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
inline constexpr Dimension hertz_stiffness{.length = -0.5, .mass = 1, .time = -2}; ///< N/m^1.5
inline constexpr Dimension damping{.mass = 1, .time = -1};
inline constexpr Dimension rotational_damping{.length = 2, .mass = 1, .time = -1};
inline constexpr Dimension inverse_velocity{.length = -1, .time = 1};
/// For a key whose unit depends on another key: the reader asks Values::require_dimension().
inline constexpr Dimension any{.any = true};
} // namespace dimension

/// The coherent SI unit, for messages and the manual: "N/m", "kg/m^3", "1", "rad/s".
std::string si_unit(const Dimension &dimension);

/// With its name where it has one: "a length [m]", "a quantity [N/m^1.7]".
std::string described(const Dimension &dimension);

/// A value a user could write for it: "5 mm", "3 Hz".
std::string example_value(const Dimension &dimension);

} // namespace vibroimpact::parameters
