// muParser computes the values; it comes with deal.II, whose own wrapper prints every error to the
// terminal. It knows no dimensions: these are found by computing the expression again with each
// base unit rescaled. A quantity of dimension m^p changes by the factor scale^p; two scales that
// give different p show that unlike things were added or compared.
#include "parameters/expression.h"

#include "parameters/text.h"
#include "parameters/tokens.h"

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace vibroimpact::parameters {

namespace {

enum Base { length, mass, time, angle };
const std::array scale_names{"L_", "M_", "T_", "A_"};
const std::vector<std::string> trigonometric{"sin", "cos", "tan"};

bool contains(const std::vector<std::string> &list, const std::string &word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

std::string digits17(double value) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.17g", value);
  return buffer.data();
}

/// By which the parser knows an argument; no name that a text can hold.
std::string parser_name(std::size_t argument) { return "X_" + std::to_string(argument) + "_"; }

/// Writes an expression as one of plain numbers, the four scales and arguments.
class Translation {
public:
  Translation(const std::string &text, const VariableTable &variables, bool zero_variables_as_one,
              const std::vector<std::string> &arguments = {})
      : text_(text), variables_(variables), zero_as_one_(zero_variables_as_one),
        arguments_(arguments), tokens_(tokens_of(text)) {
    while (position_ < tokens_.size())
      translate_next();
    if (!parentheses_.empty())
      throw Refused("'" + text_ + "' has a '(' that is not closed");
  }

  const std::string &formula() const { return formula_; }
  bool bare() const { return bare_; }
  bool uses_zero_variable() const { return uses_zero_variable_; }

private:
  struct Parenthesis {
    std::string function;
    std::size_t argument_begin;
    bool holds_angle;
  };

  void translate_next() {
    const Token &token = tokens_[position_];
    if (token.kind == Token::Kind::symbol) {
      translate_symbol(token.text);
      return;
    }
    if (after_operand_)
      throw Refused("'" + text_ + "' lacks an operator such as '*' before '" + token.text + "'");
    if (token.kind == Token::Kind::number)
      translate_number(token.value);
    else
      translate_name(token.text);
  }

  void translate_symbol(const std::string &symbol) {
    // muParser would take the last of several values: "5,3 mm" with a decimal comma as 3 mm.
    if (symbol == "," && (parentheses_.empty() || parentheses_.back().function.empty()))
      throw Refused("'" + text_ + "' holds a comma, but is one number; decimals follow a point");
    if (symbol == "(")
      open("");
    else if (symbol == ")")
      close();
    else
      formula_ += symbol;
    after_operand_ = symbol == ")";
    ++position_;
  }

  void open(const std::string &function) {
    if (after_operand_)
      throw Refused("'" + text_ + "' lacks an operator such as '*' before '('");
    formula_ += function + "(";
    parentheses_.push_back({function, formula_.size(), false});
  }

  /// Sine, cosine and tangent take an angle or a pure number; muParser's take the pure number.
  void close() {
    if (parentheses_.empty())
      throw Refused("'" + text_ + "' has a ')' without '('");
    const Parenthesis closed = parentheses_.back();
    parentheses_.pop_back();
    if (contains(trigonometric, closed.function) && closed.holds_angle) {
      formula_.insert(closed.argument_begin, "(");
      formula_ += ")/A_";
    } else if (closed.holds_angle) {
      note_angle();
    }
    formula_ += ")";
  }

  void translate_number(double value) {
    ++position_;
    const std::optional<UnitFactor> unit = read_unit(tokens_, position_, UnitBegin::directly);
    bare_ = bare_ && !unit;
    append(unit ? unit->times(value) : value, unit ? unit->dimension : Dimension{});
  }

  void translate_name(const std::string &name) {
    if (position_ + 1 < tokens_.size() && tokens_[position_ + 1].text == "(") {
      call(name);
    } else if (contains(arguments_, name)) {
      append_argument(name);
    } else if (const auto variable = variables_.find(name); variable != variables_.end()) {
      ++position_;
      append_variable(variable->second);
    } else if (const std::optional<UnitFactor> unit = read_lone_unit()) {
      bare_ = false;
      append(unit->times(1), unit->dimension);
    } else if (name == "pi") {
      ++position_;
      append(std::numbers::pi, {});
    } else {
      refuse_name(name);
    }
  }

  /// A unit without a number. "6 / N / m" divides by both: only the first belongs to the division.
  std::optional<UnitFactor> read_lone_unit() {
    const bool is_divisor = !formula_.empty() && formula_.back() == '/';
    return read_unit(tokens_, position_, is_divisor ? UnitBegin::alone : UnitBegin::directly);
  }

  void call(const std::string &function) {
    if (!contains(function_names(), function))
      throw Refused("'" + text_ + "' calls the unknown function '" + function + "'" +
                    suggestion(function, function_names()));
    open(function);
    position_ += 2;
    after_operand_ = false;
  }

  void append_argument(const std::string &name) {
    const auto found = std::find(arguments_.begin(), arguments_.end(), name);
    formula_ += parser_name(static_cast<std::size_t>(found - arguments_.begin()));
    after_operand_ = true;
    ++position_;
  }

  void append_variable(const Number &variable) {
    bare_ = bare_ && variable.bare;
    uses_zero_variable_ = uses_zero_variable_ || variable.value == 0;
    append(zero_as_one_ && variable.value == 0 ? 1 : variable.value, variable.dimension);
  }

  void append(double value, const Dimension &dimension) {
    formula_ += "(" + digits17(value);
    const std::array exponents{dimension.length, dimension.mass, dimension.time, dimension.angle};
    for (const Base base : {length, mass, time, angle})
      if (exponents[base] != 0)
        formula_ += std::string("*") + scale_names[base] + "^(" + digits17(exponents[base]) + ")";
    formula_ += ")";
    if (dimension.angle != 0)
      note_angle();
    after_operand_ = true;
  }

  void note_angle() {
    if (!parentheses_.empty())
      parentheses_.back().holds_angle = true;
  }

  [[noreturn]] void refuse_name(const std::string &name) const {
    std::vector<std::string> known = unit_names();
    for (const auto &[variable, value] : variables_)
      known.push_back(variable);
    throw Refused("'" + text_ + "' holds '" + name + "', which is neither a unit nor a variable" +
                  suggestion(name, known));
  }

  const std::string &text_;
  const VariableTable &variables_;
  bool zero_as_one_;
  std::vector<std::string> arguments_;
  std::vector<Token> tokens_;
  std::size_t position_ = 0;
  std::string formula_;
  std::vector<Parenthesis> parentheses_;
  bool after_operand_ = false;
  bool bare_ = true;
  bool uses_zero_variable_ = false;
};

/// One formula, computed for any scales. A muParser is dear to make (70 us): one serves them all,
/// and only the newest Formula may be computed.
class Formula {
public:
  Formula(const std::string &formula, std::string text) : text_(std::move(text)) {
    shared().parser.SetExpr(formula);
  }

  double at(const std::array<double, 4> &scales) {
    shared().scales = scales;
    try {
      return shared().parser.Eval();
    } catch (const mu::ParserError &) {
      throw Refused("'" + text_ + "' cannot be computed: check its operators and commas");
    }
  }

private:
  struct Shared {
    Shared() {
      for (std::size_t i = 0; i < scales.size(); ++i)
        parser.DefineVar(scale_names[i], &scales[i]);
    }
    std::array<double, 4> scales{1, 1, 1, 1};
    mu::Parser parser;
  };
  static Shared &shared() {
    static thread_local Shared instance;
    return instance;
  }

  std::string text_;
};

/// The exponent p of one base unit. Powers of two as scales keep the ratio exact, also where terms
/// nearly cancel; the second one is large so that min and max cannot hide an unlike argument.
double exponent_of(Base base, Formula &formula, double value, const std::string &text) {
  std::array<double, 2> exponents{};
  const std::array powers_of_two{2.0, 40.0};
  for (std::size_t i = 0; i < 2; ++i) {
    std::array<double, 4> scales{1, 1, 1, 1};
    scales[base] = std::exp2(powers_of_two[i]);
    exponents[i] = std::log2(formula.at(scales) / value) / powers_of_two[i];
  }
  if (!(std::abs(exponents[0] - exponents[1]) < 1e-9))
    throw Refused("'" + text +
                  "' adds or compares different dimensions, or has a unit in a function's argument"
                  " or exponent");
  return std::round(exponents[0] * 1e9) / 1e9;
}

Dimension dimension_of(Formula &formula, double value, const std::string &text) {
  return {.length = exponent_of(length, formula, value, text),
          .mass = exponent_of(mass, formula, value, text),
          .time = exponent_of(time, formula, value, text),
          .angle = exponent_of(angle, formula, value, text)};
}

/// Finds the dimension of a formula that is zero by setting its zero variables to one.
void determine_at_zero(const std::string &text, const VariableTable &variables, Number &number) {
  const Translation translation(text, variables, true);
  Formula formula(translation.formula(), text);
  const double value = formula.at({1, 1, 1, 1});
  number.determined = translation.uses_zero_variable() && std::isfinite(value) && value != 0;
  if (number.determined)
    number.dimension = dimension_of(formula, value, text);
}

/// What formulas came to that were computed before. The cases of a parameter grid meet the same
/// ones again and again, and muParser takes its time to read one.
class KnownFormulas {
public:
  struct Result {
    double value = 0;
    Dimension dimension{};
  };

  const Result *find(const std::string &formula) const {
    const auto found = results_.find(formula);
    return found == results_.end() ? nullptr : &found->second;
  }
  void add(const std::string &formula, const Result &result) {
    constexpr std::size_t most = 10000;
    if (results_.size() == most)
      results_.clear();
    results_.emplace(formula, result);
  }

private:
  std::unordered_map<std::string, Result> results_;
};

Number expression_value(const std::string &text, const VariableTable &variables) {
  static thread_local KnownFormulas known_formulas;
  const Translation translation(text, variables, false);
  Number number{.bare = translation.bare(), .literal = false};
  if (const auto *const known = known_formulas.find(translation.formula())) {
    number.value = known->value;
    number.dimension = known->dimension;
    return number;
  }
  Formula formula(translation.formula(), text);
  number.value = formula.at({1, 1, 1, 1});
  if (!std::isfinite(number.value))
    throw Refused("'" + text + "' is not a finite number");
  if (number.value == 0) {
    determine_at_zero(text, variables, number);
    return number;
  }
  number.dimension = dimension_of(formula, number.value, text);
  known_formulas.add(translation.formula(), {number.value, number.dimension});
  return number;
}

/// The plain case, "-30 mm", needs no parser.
std::optional<Number> literal_value(const std::string &text) {
  const std::vector<Token> tokens = tokens_of(text);
  std::size_t position = 0;
  const bool negative = !tokens.empty() && tokens[0].text == "-";
  if (negative || (!tokens.empty() && tokens[0].text == "+"))
    ++position;
  if (position == tokens.size() || tokens[position].kind != Token::Kind::number)
    return std::nullopt;
  const double value = (negative ? -1 : 1) * tokens[position++].value;
  const std::optional<UnitFactor> unit = read_unit(tokens, position, UnitBegin::maybe_divided);
  if (position != tokens.size())
    return std::nullopt;
  Number number{.value = unit ? unit->times(value) : value, .bare = !unit};
  number.dimension = unit ? unit->dimension : Dimension{};
  return number;
}

} // namespace

const std::vector<std::string> &function_names() {
  static const std::vector<std::string> names{"sqrt", "exp",  "ln",   "log10", "abs",  "min",
                                              "max",  "sin",  "cos",  "tan",   "asin", "acos",
                                              "atan", "sinh", "cosh", "tanh"};
  return names;
}

Number evaluate(const std::string &text, const VariableTable &variables) {
  if (normalised(text).empty())
    throw Refused("a number is missing");
  std::optional<Number> number = literal_value(text);
  if (!number)
    number = expression_value(text, variables);
  if (!std::isfinite(number->value))
    throw Refused("'" + text + "' is not a finite number");
  return *number;
}

struct Function::Parser {
  std::vector<double> values; ///< of the arguments
  mu::Parser parser;
};

Function::Function(const std::string &text, const VariableTable &variables,
                   const std::vector<std::string> &arguments)
    : text_(text), parser_(std::make_unique<Parser>()) {
  const Translation translation(text, variables, false, arguments);
  parser_->values.resize(arguments.size());
  for (std::size_t i = 0; i < arguments.size(); ++i)
    parser_->parser.DefineVar(parser_name(i), &parser_->values[i]);
  for (const char *scale : scale_names)
    parser_->parser.DefineConst(scale, 1);
  parser_->parser.SetExpr(translation.formula());
}

Function::Function(Function &&) noexcept = default;
Function::~Function() = default;

double Function::operator()(const std::vector<double> &arguments) {
  std::copy(arguments.begin(), arguments.end(), parser_->values.begin());
  try {
    return parser_->parser.Eval();
  } catch (const mu::ParserError &) {
    throw Refused("'" + text_ + "' cannot be computed: check its operators and commas");
  }
}

namespace {

/// The words of letters, digits and underscores in a text, empty ones between other characters.
template <class Visit> void visit_words(const std::string &text, Visit visit) {
  std::string word;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += c;
      continue;
    }
    visit(word);
    word.clear();
  }
  visit(word);
}

} // namespace

std::vector<std::string> used_variables(const std::string &text, const VariableTable &variables) {
  std::vector<std::string> used;
  visit_words(text, [&](const std::string &word) {
    if (variables.contains(word) && !contains(used, word))
      used.push_back(word);
  });
  return used;
}

bool uses_any(const std::string &text, const std::set<std::string> &names) {
  bool found = false;
  visit_words(text, [&](const std::string &word) { found = found || names.contains(word); });
  return found;
}

void check_variable_name(const std::string &name) {
  const bool allowed =
      begins_with_letter(name) && std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_';
      });
  if (!allowed)
    throw Refused("'" + name +
                  "' cannot be the name of a variable: use letters, digits and '_', "
                  "beginning with a letter");
  if (find_unit(name) != nullptr)
    throw Refused("'" + name + "' is a unit and cannot be the name of a variable");
  if (contains(function_names(), name) || name == "pi")
    throw Refused("'" + name + "' is a function or constant and cannot be the name of a variable");
}

bool fits(const Number &number, const Dimension &expected) {
  if (expected.any)
    return true;
  const bool is_frequency = expected.angle != 0 && expected.time != 0;
  if (number.bare)
    return !is_frequency;
  if (!number.determined)
    return true;
  Dimension found = number.dimension;
  if (expected.length != 0 || expected.mass != 0)
    found.angle = expected.angle;
  return found == expected;
}

} // namespace vibroimpact::parameters
