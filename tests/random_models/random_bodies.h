// Bodies and the connections between them.
#pragma once

#include "random_models/random_text.h"

namespace vibroimpact::testing {

struct RandomBodies {
  std::string text;
  std::string direction;             ///< along which all of them can move
  std::vector<std::string> points;   ///< BODY.POINT
  std::vector<std::string> held;     ///< those of bodies that a static force only bends
  std::string across;                ///< axis at a right angle to it; empty: nothing moves there
  std::vector<std::string> crossing; ///< points that can move along both
  std::string pushed;                ///< direction of the excitation
};

/// `factor` multiplies the mass of the first one.
RandomBodies random_bodies(Draw &draw, double factor);

} // namespace vibroimpact::testing
