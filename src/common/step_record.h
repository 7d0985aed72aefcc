// What the steps of a long computation gave, in the order in which they were taken. A computation
// that an interrupted run has begun is repeated step by step: the outcomes that are kept are read,
// and the first step without one goes on from where the run ended. What lies between the steps must
// be deterministic, and cheap.
#pragma once

#include <optional>
#include <string_view>

namespace vibroimpact {

class StepRecord {
public:
  virtual ~StepRecord() = default;
  /// The bytes that the earlier run has kept of the next step; none behind its last one. Valid as
  /// long as this object.
  virtual std::optional<std::string_view> next() = 0;
  /// Keeps those of a step that next() did not have.
  virtual void keep(std::string_view bytes) = 0;
};

} // namespace vibroimpact
