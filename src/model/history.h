// What the time history of an excitation needs to know about the excitation.
#pragma once

#include "model/coherence.h"
#include "model/time_function.h"
#include "parameters/values.h"

#include <memory>
#include <string>
#include <vector>

namespace vibroimpact::model {

using TimeFunctionPointer = std::shared_ptr<const TimeFunction>;

struct HistoryContext {
  std::string name{}; ///< of the excitation
  std::string type;   ///< "force", "base velocity", as in the parameter file
  Given given = Given::displacement;
  bool moves_base = false; ///< then s'' acts, and must be finite
  parameters::Dimension dimension;
  CoherentPlaces coherent{};
  std::string file_folder; ///< that file names refer to
  /// "NAME HASH" of files whose content is fixed; others may hold anything.
  std::vector<std::string> file_checksums;
};

} // namespace vibroimpact::model
