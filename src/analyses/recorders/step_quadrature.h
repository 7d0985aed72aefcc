// Gauss-Legendre nodes on a step: exact for polynomials up to degree 13, and so for squares of what
// the dense output gives.
#pragma once

#include <boost/math/quadrature/gauss.hpp>

#include <array>

namespace vibroimpact {

struct QuadratureNode {
  double tau = 0;    ///< in the step, 0 ... 1
  double weight = 0; ///< the weights add up to 1
};

inline const std::array<QuadratureNode, 7> &step_nodes() {
  static const std::array<QuadratureNode, 7> nodes = [] {
    using Rule = boost::math::quadrature::gauss<double, 7>;
    std::array<QuadratureNode, 7> list{};
    for (std::size_t i = 0; i < 4; ++i) { // the rule holds the half with x >= 0, 0 first
      list[3 + i] = {(1 + Rule::abscissa()[i]) / 2, Rule::weights()[i] / 2};
      list[3 - i] = {(1 - Rule::abscissa()[i]) / 2, Rule::weights()[i] / 2};
    }
    return list;
  }();
  return nodes;
}

} // namespace vibroimpact
