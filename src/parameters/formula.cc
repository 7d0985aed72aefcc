#include "parameters/formula.h"

#include "parameters/expression_reader.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::parameters {

namespace {

using FormulaStep = Step::Kind;

Dual linear(const Dual &a, double by_a, const Dual &b, double by_b, double value) {
  Dual result{.value = value};
  // An infinite slope does not count where its argument stays.
  for (std::size_t k = 0; k < 2; ++k)
    result.by[k] = (a.by[k] == 0 ? 0 : by_a * a.by[k]) + (b.by[k] == 0 ? 0 : by_b * b.by[k]);
  return result;
}

// d(a^b) = b a^(b-1) da + a^b ln(a) db
Dual power(const Dual &a, const Dual &b) {
  const double value = combined(FormulaStep::power, a.value, b.value);
  const double by_base = b.value == 0 ? 0 : b.value * std::pow(a.value, b.value - 1);
  const double by_exponent = b.by[0] == 0 && b.by[1] == 0 ? 0 : value * std::log(a.value);
  return linear(a, by_base, b, by_exponent, value);
}

struct DualNumbers {
  static Dual combined(FormulaStep kind, const Dual &a, const Dual &b) {
    const double value = parameters::combined(kind, a.value, b.value);
    switch (kind) {
    case FormulaStep::add:
      return linear(a, 1, b, 1, value);
    case FormulaStep::subtract:
      return linear(a, 1, b, -1, value);
    case FormulaStep::multiply:
      return linear(a, b.value, b, a.value, value);
    case FormulaStep::divide:
      return linear(a, 1 / b.value, b, -value / b.value, value);
    default:
      return power(a, b);
    }
  }
  static Dual called(std::size_t function, const Dual *first, std::size_t count) {
    if (!takes_several_values(function))
      return linear(*first, function_slope(function, first->value), {}, 0,
                    function_value(function, first->value));
    const auto less = [](const Dual &a, const Dual &b) { return a.value < b.value; };
    return *(function_names()[function] == "min" ? std::min_element(first, first + count, less)
                                                 : std::max_element(first, first + count, less));
  }
};

} // namespace

Formula::Formula(const std::string &text, const VariableTable &variables,
                 const std::array<std::string, 2> &arguments)
    : steps_(read_steps(text, variables, {arguments.begin(), arguments.end()})) {}

Dual Formula::operator()(double first, double second) const {
  const std::array<Dual, 2> arguments = {Dual{.value = first, .by = {1, 0}},
                                         Dual{.value = second, .by = {0, 1}}};
  stack_.clear();
  for (const Step &step : steps_) {
    if (step.kind == FormulaStep::constant)
      stack_.push_back({.value = step.constant.value});
    else if (step.kind == FormulaStep::argument)
      stack_.push_back(arguments[step.index]);
    else if (step.kind == FormulaStep::negate)
      stack_.back() = linear(stack_.back(), -1, {}, 0, -stack_.back().value);
    else
      perform(step, stack_, DualNumbers{});
  }
  return stack_.back();
}

} // namespace vibroimpact::parameters
