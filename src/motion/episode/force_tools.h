// What belongs to a shape of forces and to no system: its nodes and its integrals, made once.
#pragma once

#include "motion/episode/force_operators.h"

#include <map>
#include <memory>

namespace vibroimpact::motion {

/// Instants at which the motion within a step is shown, both ends included: the Gauss-Lobatto
/// points of [0, 1], whose weights integrate what is smooth, and two or more next to each end: the
/// slower the force begins or ends, the closer.
struct ShownPoints {
  ShownPoints(const ForceFamily &family, int inner_lobatto_points);
  const GaussRule rule;   ///< in x
  ForceOperators between; ///< targets: the inner ones
};

/// The nodes of a Gauss rule for what is smooth within a step.
struct QuadraturePoints {
  QuadraturePoints(const ForceFamily &family, int count);
  const GaussRule rule;
  ForceOperators at_nodes;
};

class ForceTools {
public:
  explicit ForceTools(const ForceShape &shape);
  ForceTools(const ForceTools &) = delete;
  ForceTools &operator=(const ForceTools &) = delete;

  const ForceFamily family;
  ForceOperators at_nodes; ///< targets: the nodes, then the end
  ShownPoints &shown(int inner);
  QuadraturePoints &quadrature(int points);

private:
  std::map<int, std::unique_ptr<ShownPoints>> shown_;
  std::map<int, std::unique_ptr<QuadraturePoints>> quadratures_;
};

/// The same object for the same shape.
ForceTools &force_tools(const ForceShape &shape);

} // namespace vibroimpact::motion
