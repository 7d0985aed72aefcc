// The values of all sources at the instant at which they were asked last: loads, gaps and the power
// of moving bases ask for the same ones in every evaluation of the equations.
#pragma once

#include "model/model.h"

#include <array>
#include <limits>
#include <memory>
#include <vector>

namespace vibroimpact::motion {

class SourceMemory {
public:
  /// Keeps a reference; the functions of its sources may be replaced.
  explicit SourceMemory(const model::Model &model) : model_(model) {}

  /// s, s' or s'' of a source [unit of the source per s^derivative].
  double operator()(std::size_t source, std::size_t derivative, double time) {
    known_.resize(model_.sources().size());
    Known &known = known_[source];
    const std::shared_ptr<const model::TimeFunction> &function = model_.sources()[source].function;
    if (known.function != function) // held, so that no other one can have its address
      known = {.function = function};
    Value &value = known.values[derivative];
    if (value.time != time)
      value = {.time = time, .value = ask(*function, derivative, time)};
    return value.value;
  }

private:
  struct Value {
    double time = std::numeric_limits<double>::quiet_NaN();
    double value = 0;
  };
  struct Known {
    std::shared_ptr<const model::TimeFunction> function{};
    std::array<Value, 3> values{};
  };

  static double ask(const model::TimeFunction &function, std::size_t derivative, double time) {
    return derivative == 0   ? function.value(time)
           : derivative == 1 ? function.rate(time)
                             : function.acceleration(time);
  }

  const model::Model &model_;
  std::vector<Known> known_;
};

} // namespace vibroimpact::motion
