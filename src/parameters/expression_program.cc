// Dimensions obey the same steps as the values: those of products add, those of powers are
// multiplied, sums and comparisons ask for equal ones.
#include "parameters/expression_program.h"

#include "parameters/expression_reader.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vibroimpact::parameters {

namespace {

using StepKind = Step::Kind;

/// What a function does with the dimension of its arguments.
enum class Rule { plain, root, keep, angle, least, greatest };

struct FunctionEntry {
  const char *name;
  Rule rule;
  double (*value)(double) = nullptr;
  double (*slope)(double) = nullptr;
};

const std::vector<FunctionEntry> functions{
    {"sqrt", Rule::root, std::sqrt, [](double x) { return 0.5 / std::sqrt(x); }},
    {"exp", Rule::plain, std::exp, std::exp},
    {"ln", Rule::plain, std::log, [](double x) { return 1 / x; }},
    {"log10", Rule::plain, std::log10, [](double x) { return 1 / (x * std::numbers::ln10); }},
    {"abs", Rule::keep, std::fabs, [](double x) { return x > 0   ? 1.0
                                                         : x < 0 ? -1.0
                                                                 : 0.0; }},
    {"min", Rule::least},
    {"max", Rule::greatest},
    {"sin", Rule::angle, std::sin, std::cos},
    {"cos", Rule::angle, std::cos, [](double x) { return -std::sin(x); }},
    {"tan", Rule::angle, std::tan, [](double x) { return 1 + std::tan(x) * std::tan(x); }},
    {"asin", Rule::plain, std::asin, [](double x) { return 1 / std::sqrt((1 - x) * (1 + x)); }},
    {"acos", Rule::plain, std::acos, [](double x) { return -1 / std::sqrt((1 - x) * (1 + x)); }},
    {"atan", Rule::plain, std::atan, [](double x) { return 1 / (1 + x * x); }},
    {"sinh", Rule::plain, std::sinh, std::cosh},
    {"cosh", Rule::plain, std::cosh, std::sinh},
    {"tanh", Rule::plain, std::tanh,
     [](double x) { return (1 - std::tanh(x)) * (1 + std::tanh(x)); }}};

} // namespace

double combined(StepKind kind, double a, double b) {
  switch (kind) {
  case StepKind::add:
    return a + b;
  case StepKind::subtract:
    return a - b;
  case StepKind::multiply:
    return a * b;
  case StepKind::divide:
    return a / b;
  default:
    return std::pow(a, b);
  }
}

namespace {

/// The exponents of a + factor * b.
Dimension sum_of(const Dimension &a, double factor, const Dimension &b) {
  return {.length = a.length + factor * b.length,
          .mass = a.mass + factor * b.mass,
          .time = a.time + factor * b.time,
          .angle = a.angle + factor * b.angle};
}

/// Numbers that know their dimensions.
class Quantities {
public:
  explicit Quantities(const std::string &text) : text_(text) {}

  Number combined(StepKind kind, const Number &a, const Number &b) const {
    Number result{.value = parameters::combined(kind, a.value, b.value), .bare = a.bare && b.bare};
    if (kind == StepKind::multiply || kind == StepKind::divide)
      result.dimension = sum_of(a.dimension, kind == StepKind::multiply ? 1 : -1, b.dimension);
    else if (kind == StepKind::power)
      result.dimension = sum_of({}, plain(b).value, a.dimension);
    else
      result.dimension = common(a, b);
    return result;
  }

  Number called(std::size_t function, const Number *first, std::size_t count) const {
    const auto &[name, rule, value, slope] = functions[function];
    if (rule == Rule::least || rule == Rule::greatest)
      return extreme(rule == Rule::least, first, count);
    Number result{.value = value(first->value), .bare = first->bare};
    if (rule == Rule::keep)
      result.dimension = first->dimension;
    else if (rule == Rule::root)
      result.dimension = sum_of({}, 0.5, first->dimension);
    else if (!(rule == Rule::angle && first->dimension == dimension::angle))
      plain(*first);
    return result;
  }

private:
  Number extreme(bool least, const Number *first, std::size_t count) const {
    Number result = *first;
    for (std::size_t i = 1; i < count; ++i) {
      result.dimension = common(result, first[i]);
      result.bare = result.bare && first[i].bare;
      result.value =
          least ? std::min(result.value, first[i].value) : std::max(result.value, first[i].value);
    }
    return result;
  }

  /// Of two that are added or compared. A zero without a unit goes with everything.
  Dimension common(const Number &a, const Number &b) const {
    if (a.bare && a.value == 0)
      return b.dimension;
    if (!(b.bare && b.value == 0) && !(a.dimension == b.dimension))
      refuse();
    return a.dimension;
  }

  const Number &plain(const Number &number) const {
    if (!(number.dimension == dimension::none))
      refuse();
    return number;
  }

  [[noreturn]] void refuse() const {
    throw Refused("'" + text_ +
                  "' adds or compares different dimensions, or has a unit in a function's argument"
                  " or exponent");
  }

  const std::string &text_;
};

struct PlainNumbers {
  static double combined(StepKind kind, double a, double b) {
    return parameters::combined(kind, a, b);
  }
  static double called(std::size_t function, const double *first, std::size_t count) {
    const auto &[name, rule, value, slope] = functions[function];
    if (rule == Rule::least)
      return *std::min_element(first, first + count);
    return rule == Rule::greatest ? *std::max_element(first, first + count) : value(*first);
  }
};

/// Products of exponents that are no binary fractions, such as (x^(1/3))^3.
double rounded(double exponent) {
  return std::abs(exponent) < 1e6 ? std::round(exponent * 1e9) / 1e9 : exponent;
}

} // namespace

Program::Program(const std::string &text, const VariableTable &variables,
                 const std::vector<std::string> &arguments)
    : text_(text), steps_(read_steps(text, variables, arguments)) {}

Number Program::quantity() const {
  const Quantities arithmetic(text_);
  std::vector<Number> stack;
  for (const Step &step : steps_) {
    if (step.kind == StepKind::constant)
      stack.push_back(step.constant);
    else if (step.kind == StepKind::negate)
      stack.back().value = -stack.back().value;
    else
      perform(step, stack, arithmetic);
  }
  Number result = stack.back();
  Dimension &found = result.dimension;
  found = {rounded(found.length), rounded(found.mass), rounded(found.time), rounded(found.angle)};
  result.literal = false;
  return result;
}

double Program::value(const std::vector<double> &arguments) {
  stack_.clear();
  for (const Step &step : steps_) {
    if (step.kind == StepKind::constant)
      stack_.push_back(step.constant.value);
    else if (step.kind == StepKind::argument)
      stack_.push_back(arguments[step.index]);
    else if (step.kind == StepKind::negate)
      stack_.back() = -stack_.back();
    else
      perform(step, stack_, PlainNumbers{});
  }
  return stack_.back();
}

bool takes_several_values(std::size_t function) { return functions[function].value == nullptr; }

double function_value(std::size_t function, double argument) {
  return functions[function].value(argument);
}

double function_slope(std::size_t function, double argument) {
  return functions[function].slope(argument);
}

const std::vector<std::string> &function_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const FunctionEntry &function : functions)
      list.emplace_back(function.name);
    return list;
  }();
  return names;
}

} // namespace vibroimpact::parameters
