#include "structure/beam_definition.h"

#include <utility>

namespace vibroimpact::structure {

namespace {

std::string message(const std::string &kind, const std::string &name, const std::string &key,
                    const std::string &problem) {
  const std::string section = name.empty() ? kind : kind + " " + name;
  return section + (key.empty() ? "" : "/" + key) + " " + problem;
}

} // namespace

DefinitionError::DefinitionError(std::string kind, std::string name, std::string key,
                                 std::string problem)
    : InputError(message(kind, name, key, problem)), kind_(std::move(kind)), name_(std::move(name)),
      key_(std::move(key)), problem_(std::move(problem)) {}

} // namespace vibroimpact::structure
