// One contact of two random bodies, of any law: what the error of a motion is judged by.
#pragma once

#include "support/reference_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace vibroimpact::testing {

struct RandomContact {
  ReferenceSystem system;
  ReferenceStart start;
  double end = 0;       ///< behind the contact [s]
  double tolerance = 0; ///< from 1e-12 to 1e-6: coarser ones leave a contact few steps to judge by
};

/// Sizes, masses, speeds and durations over several decades; the bodies are free or on springs that
/// are slow beside the contact or as fast as it; restitution from 0.2 to 1.
inline RandomContact random_contact(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto decades = [&](double low, double high) { return std::pow(10, uniform(low, high)); };
  RandomContact made;
  made.tolerance = decades(-12, -6);
  const double mass_a = decades(-2, 2), mass_b = mass_a * decades(-2, 2);
  const double effective = mass_a * mass_b / (mass_a + mass_b);
  const double speed = decades(-2, 1), duration = decades(-4, -2);
  // Of Hertz's contact: u^(n+1) = (n+1) m v^2 / (2 k), about 3 u / v long.
  const double deepest = speed * duration / 3;
  ReferenceLaw law{.exponent = uniform(1.1, 3)};
  const int kind = static_cast<int>(random() % 4);
  if (kind > 1)
    law.exponent = 1.5;
  law.stiffness =
      (law.exponent + 1) * effective * speed * speed / (2 * std::pow(deepest, law.exponent + 1));
  if (kind == 1)
    law.damping = uniform(0, 3) / speed;
  if (kind == 2) {
    law.kind = ReferenceLaw::Kind::kuwabara_kono;
    law.damping = uniform(0, 0.1) * duration;
  }
  if (kind == 3) {
    law.kind = ReferenceLaw::Kind::tsuji;
    law.damping = uniform(0, 1) * std::sqrt(effective * law.stiffness);
    // Its force begins like u^(1/4), which is not smooth in the root of time: steps of order 8 err
    // by up to 20 times tolerances below that (docs/theory.md).
    made.tolerance = std::max(made.tolerance, 1e-10);
  }
  const double frequency = random() % 2 == 0 ? 0 : decades(-3, 0) / duration;
  made.system = {.mass = {mass_a, mass_b},
                 .stiffness = {mass_a * frequency * frequency, 0},
                 .damping = {0.1 * mass_a * frequency, 0},
                 .contacts = {{.row = {-1, 1}, .clearance = 0.1 * deepest, .law = law}}};
  // The contact begins while a spring has hardly acted.
  const double share = uniform(0, 1);
  made.start = {{0, 0}, {share * speed, (share - 1) * speed}};
  made.end = 4 * duration;
  return made;
}

} // namespace vibroimpact::testing
