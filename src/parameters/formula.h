// A function of two arguments with its exact partial derivatives.
#pragma once

#include "parameters/expression_program.h"

#include <array>
#include <string>
#include <vector>

namespace vibroimpact::parameters {

/// A number with its partial derivatives by two arguments.
struct Dual {
  double value = 0;
  std::array<double, 2> by{};
};

/// An expression of two arguments, differentiated by the rules of calculus for each of its steps.
/// Where a function has a corner (abs, min, max), the derivative is one of those beside it, and
/// zero for abs at zero.
class Formula {
public:
  /// `arguments` hide variables of the same names. Throws Refused.
  Formula(const std::string &text, const VariableTable &variables,
          const std::array<std::string, 2> &arguments);

  /// In SI; neither value nor derivatives need be finite.
  Dual operator()(double first, double second) const;
  /// What it is made of; arguments have the indices 0 and 1.
  const std::vector<Step> &steps() const { return steps_; }

private:
  std::vector<Step> steps_;
  mutable std::vector<Dual> stack_{};
};

} // namespace vibroimpact::parameters
