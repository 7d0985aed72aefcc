// Runs a parameter file with one transient analysis inside this process.
#pragma once

#include "common/result_sink.h"
#include "parameters/values.h"

#include <string>
#include <vector>

namespace vibroimpact::testing {

struct ModelRun {
  enum class Status { finished, failed, refused };

  Status status = Status::refused;
  std::string reason{};        ///< why it failed or was refused
  std::vector<Field> fields{}; ///< of the analysis
  double seconds = 0;          ///< of processor time
};

/// Runs analysis "a" of the text; `folder` is where its records lie.
ModelRun run_model(const std::string &text, const std::string &folder,
                   std::vector<parameters::Override> overrides);

} // namespace vibroimpact::testing
