// Numbers with units, and expressions of them: "30 mm", "lambda * 1 kN/m", "sqrt(2) * 0.3 m".
#pragma once

#include "parameters/dimension.h"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace vibroimpact::parameters {

/// What is wrong with a value, as a clause to be put after its place: "'1/0' is not finite".
class Refused : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

struct Number {
  double value = 0; ///< in SI
  Dimension dimension{};
  bool bare = true;    ///< no unit anywhere in it, not even in its variables: taken as SI
  bool literal = true; ///< one number with at most one unit
};

class Program;

/// The variables of a file by name, and whether units may stand in its numbers.
struct VariableTable : std::map<std::string, Number> {
  using map::map;
  bool dimensionless = false; ///< Units = dimensionless: evaluate() and Function refuse units
};

/// The value of one number or expression. Throws Refused.
Number evaluate(const std::string &text, const VariableTable &variables);

/// An expression whose arguments take many values one after the other.
class Function {
public:
  /// `arguments` hide variables of the same names. Throws Refused.
  Function(const std::string &text, const VariableTable &variables,
           const std::vector<std::string> &arguments);
  Function(Function &&) noexcept;
  Function(const Function &) = delete;
  Function &operator=(Function &&) = delete;
  Function &operator=(const Function &) = delete;
  ~Function();

  /// The arguments in their order, in SI; so is the value, which need not be finite.
  double operator()(const std::vector<double> &arguments);

private:
  std::unique_ptr<Program> program_;
};

/// The variables that `text` uses. Text that is no expression gives those whose names stand in it.
std::vector<std::string> used_variables(const std::string &text, const VariableTable &variables);

/// Does one of the names stand in `text`?
bool uses_any(const std::string &text, const std::set<std::string> &names);

/// Throws Refused unless a variable may be called so: letters, digits and underscores, beginning
/// with a letter, and not the name of a unit, function or constant.
void check_variable_name(const std::string &name);

/// May a number of this dimension stand where `expected` is asked for? A bare number may, except
/// for frequencies; the radian counts as 1 where length or mass is involved.
bool fits(const Number &number, const Dimension &expected);

/// Functions an expression may call, for messages and the manual.
const std::vector<std::string> &function_names();

} // namespace vibroimpact::parameters
