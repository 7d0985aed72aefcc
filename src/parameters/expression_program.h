// An expression as a list of steps that work on a stack of numbers.
#pragma once

#include "parameters/expression.h"

#include <string>
#include <vector>

namespace vibroimpact::parameters {

/// A step of it: it puts a number on the stack, or replaces the newest ones by their result.
struct Step {
  enum class Kind { constant, argument, negate, add, subtract, multiply, divide, power, call };
  Kind kind;
  Number constant{};
  std::size_t index = 0; ///< of the argument, or of the function among function_names()
  std::size_t count = 0; ///< of the values a function is called with
};

/// min and max; `function` is an index into function_names().
bool takes_several_values(std::size_t function);
/// Of one that takes a single value, and its derivative.
double function_value(std::size_t function, double argument);
double function_slope(std::size_t function, double argument);
/// Sum, difference, product, quotient or power.
double combined(Step::Kind kind, double a, double b);

/// What the step leaves on the stack in place of its values; `Arithmetic` combines and calls.
template <class Type, class Arithmetic>
void perform(const Step &step, std::vector<Type> &stack, const Arithmetic &arithmetic) {
  const std::size_t taken = step.kind == Step::Kind::call ? step.count : 2;
  Type *const first = stack.data() + stack.size() - taken;
  *first = step.kind == Step::Kind::call ? arithmetic.called(step.index, first, step.count)
                                         : arithmetic.combined(step.kind, first[0], first[1]);
  stack.resize(stack.size() - taken + 1);
}

/// Read once, computed as often as wanted, with or without dimensions.
class Program {
public:
  /// `arguments` hide variables of the same names. Throws Refused.
  Program(const std::string &text, const VariableTable &variables,
          const std::vector<std::string> &arguments);

  /// The value with its dimension, of an expression without arguments; it may be infinite or no
  /// number. Throws Refused where unlike things are added or compared, or where a function or an
  /// exponent has a unit.
  Number quantity() const;

  /// The bare value in SI for these arguments, in their order.
  double value(const std::vector<double> &arguments);

private:
  std::string text_;
  std::vector<Step> steps_;
  std::vector<double> stack_{};
};

} // namespace vibroimpact::parameters
