// A step whose outcome is kept: its value, or the reason of its NumericalError. Values are
// serialised by Boost.
#pragma once

#include "common/dense_archive.h"
#include "common/error.h"
#include "common/step_record.h"

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/string.hpp>

#include <optional>
#include <sstream>
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
    std::istringstream stream{std::string(*kept), std::ios::binary};
    boost::archive::binary_iarchive archive(stream, boost::archive::no_header);
    std::string kept_kind;
    archive >> kept_kind;
    if (kept_kind != kind)
      throw std::runtime_error("cannot go on: the run that was interrupted kept the step \"" +
                               kept_kind + "\" where this version of the program has the step \"" +
                               kind + "\"");
    archive >> value >> reason;
  } else {
    try {
      value = compute();
    } catch (const NumericalError &error) {
      reason = error.what();
    }
    std::ostringstream stream(std::ios::binary);
    boost::archive::binary_oarchive archive(stream, boost::archive::no_header);
    archive << kind << std::as_const(value) << std::as_const(reason);
    record->keep(stream.str());
  }
  if (!value)
    throw NumericalError(reason);
  return *std::move(value);
}

} // namespace vibroimpact
