// Motions with nonlinear contacts by other means than the program's, in long double: Boost.odeint's
// extrapolation of the midpoint rule (order 16), every step repeated up to the instant of an event.
// (Its Runge-Kutta-Fehlberg method of order 7(8) would not do: the error estimate of that vanishes
// for forces that depend on time alone, as does that of a contact in its first step.)
// Laws and equations are written down from their formulas; nothing is taken from the code under
// test.
//
//   m_i q_i'' + c_i q_i' + k_i q_i = forces - m_i s'' - springs + contact forces
//   gap = clearance + row q + by_base s,   s the displacement of the base
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::testing {

using Real = long double;
using Reals = std::vector<Real>;

/// Force of a penetration u > 0 [N].
struct ReferenceLaw {
  enum class Kind {
    power,         ///< k u^n (1 + d u'), none where that would pull
    kuwabara_kono, ///< k u^(3/2) + A (3/2) k u^(1/2) u', none where that would pull
    tsuji,         ///< k u^(3/2) + c u^(1/4) u'
  };
  Kind kind = Kind::power;
  double stiffness = 0;  ///< k [N/m^n]
  double exponent = 1.5; ///< n
  double damping = 0;    ///< d [s/m], A [s] or c [N s/m^1.25]
};

struct ReferenceContact {
  std::vector<double> row;
  double clearance = 0; ///< [m]
  ReferenceLaw law{};
  double by_base = 0;
};

/// Tension k e + k3 e^3 + c e' of the elongation e = row q.
struct ReferenceSpring {
  std::vector<double> row;
  double stiffness = 0, damping = 0, cubic = 0;
};

/// A sin(w t + p); w = 0: constant.
struct ReferenceHarmonic {
  double amplitude = 0, frequency = 0, phase = 0;
};

struct ReferenceSystem {
  std::vector<double> mass, stiffness, damping; ///< of each coordinate
  std::vector<ReferenceContact> contacts{};
  std::vector<ReferenceSpring> springs{};
  std::vector<std::optional<ReferenceHarmonic>> forces{}; ///< on each coordinate; may be shorter
  std::optional<ReferenceHarmonic> base{};                ///< displacement [m]
  bool one_body = false; ///< the coordinates are modes of one body, else a body each
};

struct ReferenceStart {
  std::vector<double> displacement, velocity;
};

struct ReferenceImpact {
  Real start = 0, duration = 0;
  Real approach_speed = 0, separation_speed = 0;
  Real impulse = 0, dissipated = 0; ///< [N s], [J]: the work of the force, taken from the motion
  Real deepest = 0;                 ///< largest penetration [m]
  int humps = 0;                    ///< maxima of the penetration
};

struct ReferenceResult {
  Reals displacement, velocity;                      ///< at the end
  Reals largest_displacement, largest_velocity;      ///< of each coordinate, at ends of steps
  std::vector<std::vector<ReferenceImpact>> impacts; ///< of each contact, finished ones
  long steps = 0;
};

/// From time 0 to `end`; local errors of `tolerance` of the largest values. std::runtime_error
/// after too many steps.
ReferenceResult reference_motion(const ReferenceSystem &system, const ReferenceStart &start,
                                 double end, double tolerance = 1e-17);

} // namespace vibroimpact::testing
