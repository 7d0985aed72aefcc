// Which data the points of a VTU file have, in which order.
#pragma once

#include "common/linear_algebra.h"

#include <deal.II/numerics/data_component_interpretation.h>

#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace vibroimpact::output {

/// Of every point: displacement [m], rotation [rad] and the number of the body (from 1; 0 for what
/// belongs to none). The rest is there where it is known.
struct PointData {
  bool velocity = false;  ///< [m/s]
  bool contact = false;   ///< force [N], gap [m], peak force [N], state
  unsigned von_mises = 0; ///< [Pa]: the largest; with 3 also that of the first and second face
  std::span<const char *const> stress{}; ///< components of the stress of a cell [Pa]

  /// Components of all of them.
  unsigned size() const {
    return 7 + (velocity ? 3 : 0) + (contact ? 6 : 0) + von_mises +
           static_cast<unsigned>(stress.size());
  }
  /// A name for each component.
  std::vector<std::string> names() const;
  using Vectors =
      std::vector<std::tuple<unsigned, unsigned, std::string,
                             dealii::DataComponentInterpretation::DataComponentInterpretation>>;
  /// Those of three components: first, last, name.
  Vectors vectors() const;
};

} // namespace vibroimpact::output
