// Parameter files as text, for tests of whole runs inside one process.
#pragma once

#include "parameters/values.h"
#include "simulation.h"

#include <memory>
#include <string>
#include <vector>

namespace vibroimpact::testing {

/// Parses and runs all checks a run starts with; the message of the InputError, or "" if none.
inline std::string message_of(const std::string &text,
                              const std::vector<parameters::Override> &overrides = {}) {
  try {
    Simulation simulation(
        parameters::ParameterSet::parse(declare_parameters(), text, "test.prm", false, overrides),
        MPI_COMM_SELF);
    simulation.check();
  } catch (const InputError &error) {
    return error.what();
  }
  return "";
}

/// `text` with the first occurrence of `from` replaced; std::logic_error when there is none.
inline std::string changed(const std::string &text, const std::string &from,
                           const std::string &to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos)
    throw std::logic_error("the text has no '" + from + "'");
  return text.substr(0, at) + to + text.substr(at + from.size());
}

} // namespace vibroimpact::testing
