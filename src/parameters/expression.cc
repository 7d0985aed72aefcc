#include "parameters/expression.h"

#include "parameters/expression_program.h"
#include "parameters/file_units.h"
#include "parameters/text.h"
#include "parameters/tokens.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::parameters {

namespace {

bool contains_word(const std::vector<std::string> &list, const std::string &word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// The plain case, "-30 mm", needs no parser.
std::optional<Number> literal_value(const std::string &text, bool dimensionless) {
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
  if (unit && dimensionless)
    check_plain(*unit, text);
  Number number{.value = unit ? unit->times(value) : value, .bare = !unit};
  number.dimension = unit ? unit->dimension : Dimension{};
  return number;
}

} // namespace

Number evaluate(const std::string &text, const VariableTable &variables) {
  if (normalised(text).empty())
    throw Refused("a number is missing");
  const std::optional<Number> literal = literal_value(text, variables.dimensionless);
  const Number number = literal ? *literal : Program(text, variables, {}).quantity();
  if (!std::isfinite(number.value))
    throw Refused("'" + text + "' is not a finite number");
  return number;
}

Function::Function(const std::string &text, const VariableTable &variables,
                   const std::vector<std::string> &arguments)
    : program_(std::make_unique<Program>(text, variables, arguments)) {}

Function::Function(Function &&) noexcept = default;
Function::~Function() = default;

double Function::operator()(const std::vector<double> &arguments) {
  return program_->value(arguments);
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
    if (variables.contains(word) && !contains_word(used, word))
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
  if (contains_word(function_names(), name) || name == "pi")
    throw Refused("'" + name + "' is a function or constant and cannot be the name of a variable");
}

bool fits(const Number &number, const Dimension &expected) {
  if (expected.any)
    return true;
  const bool is_frequency = expected.angle != 0 && expected.time != 0;
  if (number.bare)
    return !is_frequency;
  Dimension found = number.dimension;
  if (expected.length != 0 || expected.mass != 0)
    found.angle = expected.angle;
  return found == expected;
}

} // namespace vibroimpact::parameters
