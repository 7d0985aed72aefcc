// The Integration section of the parameter file.
#pragma once

#include "parameters/values.h"

#include <cstddef>
#include <string>

namespace vibroimpact::motion {

struct Settings {
  std::string method = "exact"; ///< "exact", "moments", "rk", "bdf", "theta" or "arkimex"
  double relative_tolerance = 1e-9;
  double absolute_tolerance = 0;  ///< of displacements at the points [m]; 0: none
  double event_tolerance = 1e-12; ///< of the instant of a contact change [s]
  double maximum_step = 0;        ///< [s]; 0: none
  long maximum_steps = 0;         ///< per case; 0: none
  long maximum_events = 0;        ///< per case; 0: none
  /// Of what is prepared of linear phases, for each motion [B]; it changes no result.
  std::size_t prepared_bytes = std::size_t{512} << 20;
};

void declare_integration(parameters::Section &root);
Settings read_integration(const parameters::Values &root);

} // namespace vibroimpact::motion
