// What the steps of a formula F(u, v) say about it: where it is linear, where its sign changes, how
// it grows from nothing.
#pragma once

#include "contact/contact_law.h"
#include "parameters/formula.h"

#include <optional>
#include <vector>

namespace vibroimpact::contact {

/// constant + by_penetration u + by_rate v
struct LinearForm {
  double constant = 0, by_penetration = 0, by_rate = 0;
};

struct FormulaShape {
  bool sees_rate = false; ///< does v stand in it?
  /// The formula itself, where it is linear.
  std::optional<LinearForm> linear{};
  /// Where v stands in one factor of a product alone, and this factor is linear: that factor.
  std::optional<LinearForm> factor{};
  /// F(u, 0) where it is k u^n.
  std::optional<ElasticForce> elastic{};
  /// How it grows with the penetration where the sides meet or part at some speed; none where it is
  /// not known to be smooth in between.
  std::optional<ForceEdge> edge{};
};

FormulaShape shape_of(const parameters::Formula &formula);

} // namespace vibroimpact::contact
