#include "parameters/check_value.h"

#include "parameters/text.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::parameters {

namespace {

const std::vector<std::string> true_words{"true", "yes", "on"};
const std::vector<std::string> false_words{"false", "no", "off"};

bool contains(const std::vector<std::string> &list, const std::string &word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

std::string with_unit(double value, const Dimension &dimension) {
  const std::string unit = si_unit(dimension);
  if (unit == "1")
    return number_text(value);
  return number_text(value) + (unit.starts_with("1/") ? unit.substr(1) : " " + unit);
}

/// A value in the range; the usual one of the dimension if it is.
std::string example_for(const Dimension &dimension, const Range &range) {
  if (dimension.any)
    return "";
  std::string usual = example_value(dimension);
  if (range.contains(evaluate(usual, {}).value))
    return usual;
  if (std::isfinite(range.lower) && std::isfinite(range.upper))
    return with_unit((range.lower + range.upper) / 2, dimension);
  return with_unit(std::isfinite(range.lower) ? range.lower + 1 : range.upper - 1, dimension);
}

std::string range_note(const Range &range, const std::string &unit) {
  const std::string sentence = range.sentence(unit);
  return sentence == "any" ? "" : " (" + sentence + ")";
}

std::string number_expectation(const Dimension &dimension, const Range &range,
                               const std::string &example) {
  const std::string shown = example.empty() ? example_for(dimension, range) : example;
  return described(dimension) + " is expected" +
         range_note(range, dimension.any ? "" : si_unit(dimension)) +
         (shown.empty() ? "" : ", for example " + shown);
}

std::string whole_number_expectation(const Key &key) {
  const double lower = std::isfinite(key.range.lower) ? std::ceil(key.range.lower) + 1 : 1;
  const std::string example =
      key.default_value.empty() ? number_text(std::min(lower, key.range.upper)) : key.default_value;
  return "a whole number is expected" + range_note(key.range, "") + ", for example " + example;
}

std::string list_expectation(const Key &key) {
  const std::string example =
      key.default_value.empty() ? example_for(key.dimension, key.range) : key.default_value;
  return "separated by commas, " + count_sentence(key) + " are expected, each " +
         described(key.dimension) + range_note(key.range, si_unit(key.dimension)) +
         (example.empty() ? "" : ", for example " + example);
}

/// Adds to a refusal what would be right, which `expected` gives.
template <class Expected>
Number evaluated(const std::string &text, const VariableTable &variables, Expected expected) {
  try {
    return evaluate(text, variables);
  } catch (const Refused &refused) {
    const std::string problem = refused.what();
    throw Refused(problem + (problem.ends_with('?') ? " " : "; ") + expected());
  }
}

void check_quantities(Value &value, const VariableTable &variables) {
  const Key &key = *value.key;
  const std::vector<std::string> parts = split_list(value.text, true);
  const auto count = static_cast<int>(parts.size());
  if (count < key.minimum_count || count > key.maximum_count)
    throw Refused("the number of values is " + std::to_string(count) + "; " + expectation(key));
  for (const std::string &part : parts) {
    if (part.empty())
      throw Refused("an entry of the list is empty; " + expectation(key));
    value.numbers.push_back(checked_number(part, key.dimension, key.range, "", variables));
  }
}

void check_integer(Value &value, const VariableTable &variables) {
  const Key &key = *value.key;
  const Number number = evaluated(value.text, variables, [&key] { return expectation(key); });
  const bool whole = number.dimension == dimension::none && std::rint(number.value) == number.value;
  // Above 2^53 a double cannot hold every whole number.
  if (!whole || std::abs(number.value) > 9007199254740992.0)
    throw Refused("'" + value.text + "' is not a whole number; " + expectation(key));
  if (!key.range.contains(number.value))
    throw Refused("'" + value.text + "' is out of range; " + expectation(key));
  value.numbers.push_back(number);
}

void check_names(std::vector<std::string> names, const Key &key) {
  if (contains(names, ""))
    throw Refused("an entry of the list is empty; " + expectation(key));
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end())
    throw Refused("'" + *twice + "' is listed twice; " + expectation(key));
}

void check_word(const Value &value) {
  const Key &key = *value.key;
  if (key.kind == KeyKind::choice && !contains(key.options, value.text))
    throw Refused("'" + value.text + "' is not possible" + suggestion(value.text, key.options) +
                  (nearest(value.text, key.options).empty() ? "; " : " ") + expectation(key));
  if (key.kind == KeyKind::boolean && !contains(true_words, value.text) &&
      !contains(false_words, value.text))
    throw Refused("'" + value.text + "' is not possible; " + expectation(key));
  if (key.kind == KeyKind::names)
    check_names(split_list(value.text), key);
}

bool may_be_empty(const Key &key) {
  const bool free = key.kind == KeyKind::text || key.kind == KeyKind::names ||
                    key.kind == KeyKind::variables ||
                    (key.kind == KeyKind::quantities && key.minimum_count == 0);
  return free || key.default_value.empty();
}

} // namespace

std::string wrong_dimension(const std::string &text, const Number &number,
                            const Dimension &expected, const Range &range,
                            const std::string &example) {
  const std::string what = number.bare ? "has no unit" : "is " + described(number.dimension);
  const std::string explanation =
      expected == dimension::frequency ? "; a frequency must say Hz, kHz, MHz, rad/s or rpm" : "";
  return "'" + text + "' " + what + explanation + "; " +
         number_expectation(expected, range, example);
}

Number checked_number(const std::string &text, const Dimension &dimension, const Range &range,
                      const std::string &example, const VariableTable &variables) {
  const Number number =
      evaluated(text, variables, [&] { return number_expectation(dimension, range, example); });
  if (!fits(number, dimension))
    throw Refused(wrong_dimension(text, number, dimension, range, example));
  if (!range.contains(number.value))
    throw Refused("'" + text + "'" +
                  (number.literal ? "" : ", which is " + with_unit(number.value, dimension) + ",") +
                  " is out of range; " + number_expectation(dimension, range, example));
  return number;
}

std::string count_sentence(const Key &key) {
  const int least = key.minimum_count;
  const int most = key.maximum_count;
  if (most == std::numeric_limits<int>::max())
    return least == 0 ? "any number of values" : "at least " + std::to_string(least) + " values";
  if (least == most)
    return std::to_string(least) + " values";
  return std::to_string(least) + " to " + std::to_string(most) + " values";
}

std::string expectation(const Key &key) {
  switch (key.kind) {
  case KeyKind::quantity:
    return number_expectation(key.dimension, key.range, key.default_value);
  case KeyKind::quantities:
    return list_expectation(key);
  case KeyKind::integer:
    return whole_number_expectation(key);
  case KeyKind::boolean:
    return "true or false is expected (or yes, no, on, off)";
  case KeyKind::choice:
    return "one of these is expected: " + join(key.options, ", ");
  case KeyKind::names:
    return "different names separated by commas are expected";
  case KeyKind::variables:
    return "NAME = VALUE is expected, separated by commas";
  case KeyKind::text:
    break;
  }
  return "text is expected";
}

void check_value(Value &value, const VariableTable &variables) {
  const Key &key = *value.key;
  value.numbers.clear();
  if (value.text.empty()) {
    if (!may_be_empty(key))
      throw Refused("a value is missing; " + expectation(key));
    return;
  }
  if (key.kind == KeyKind::quantity)
    value.numbers = {
        checked_number(value.text, key.dimension, key.range, key.default_value, variables)};
  else if (key.kind == KeyKind::quantities)
    check_quantities(value, variables);
  else if (key.kind == KeyKind::integer)
    check_integer(value, variables);
  else
    check_word(value);
}

bool boolean_value(const std::string &text) { return contains(true_words, text); }

} // namespace vibroimpact::parameters
