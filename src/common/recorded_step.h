// A step whose outcome is kept: its value, or the reason of its NumericalError.
#pragma once

#include "common/bytes.h"
#include "common/error.h"
#include "common/step_record.h"

#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace vibroimpact {

/// What `compute` gives, or gave in the run that has kept it; without a record it is computed.
/// `kind` names the step: an outcome of another kind, which a run of another version may have kept,
/// is a std::runtime_error. The value can be made without arguments.
template <class Compute>
auto recorded(StepRecord *record, const std::string &kind, const Compute &compute) {
  using Value = std::decay_t<decltype(compute())>;
  if (record == nullptr)
    return Value(compute());
  std::optional<Value> value;
  std::string reason;
  if (const std::optional<std::string_view> kept = record->next()) {
    Cursor cursor(*kept);
    if (const auto kept_kind = cursor.take<std::string>(); kept_kind != kind)
      throw std::runtime_error("cannot go on: the run that was interrupted kept the step \"" +
                               kept_kind + "\" where this version of the program has the step \"" +
                               kind + "\"");
    unpack(cursor.rest(), value, reason);
  } else {
    try {
      value = compute();
    } catch (const NumericalError &error) {
      reason = error.what();
    }
    record->keep(packed(kind, value, reason));
  }
  if (!value)
    throw NumericalError(reason);
  return *std::move(value);
}

} // namespace vibroimpact
