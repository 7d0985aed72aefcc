#include "analyses/recorders/step_quadrature.h"

#include <boost/math/quadrature/gauss.hpp>

namespace vibroimpact::analyses {

const std::array<QuadratureNode, 10> &step_nodes() {
  static const std::array<QuadratureNode, 10> nodes = [] {
    using Rule = boost::math::quadrature::gauss<double, 10>;
    std::array<QuadratureNode, 10> list{};
    for (std::size_t i = 0; i < 5; ++i) { // the rule holds the half with x > 0
      list[5 + i] = {(1 + Rule::abscissa()[i]) / 2, Rule::weights()[i] / 2};
      list[4 - i] = {(1 - Rule::abscissa()[i]) / 2, Rule::weights()[i] / 2};
    }
    return list;
  }();
  return nodes;
}

} // namespace vibroimpact::analyses
