// A recursive descent, each level of precedence by its own function:
//
//   sum := product {(+|-) product}      product := signed {(*|/) signed}
//   signed := {+|-} power               power := operand [^ signed]
//   operand := number [unit] | unit | variable | argument | pi | ( sum ) | function ( sum {, sum} )
//
// so that -2^2 = -4 and 2^3^2 = 2^9.
#include "parameters/expression_reader.h"

#include "parameters/file_units.h"
#include "parameters/text.h"
#include "parameters/tokens.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>

namespace vibroimpact::parameters {

namespace {

using Kind = Step::Kind;

class Reader {
public:
  Reader(const std::string &text, const VariableTable &variables,
         const std::vector<std::string> &arguments)
      : text_(text), variables_(variables), arguments_(arguments), tokens_(tokens_of(text)) {}

  std::vector<Step> read() {
    sum();
    if (is(")"))
      refuse("has a ')' without '('");
    if (is(","))
      refuse_comma();
    return std::move(steps_);
  }

private:
  /// The stack of the processor bounds how deep parentheses and powers may nest.
  class Level {
  public:
    explicit Level(Reader &reader) : depth_(reader.depth_) {
      constexpr int most = 100;
      if (++depth_ > most)
        reader.refuse("nests parentheses or powers more than " + std::to_string(most) + " deep");
    }
    ~Level() { --depth_; }
    Level(const Level &) = delete;
    Level &operator=(const Level &) = delete;

  private:
    int &depth_;
  };

  [[noreturn]] void refuse(const std::string &problem) const {
    throw Refused("'" + text_ + "' " + problem);
  }
  [[noreturn]] void refuse_structure() const {
    refuse("cannot be computed: check its operators and commas");
  }
  /// A decimal comma, "5,3 mm", must not pass for two values.
  [[noreturn]] void refuse_comma() const {
    refuse("holds a comma, but is one number; decimals follow a point");
  }

  bool at_end() const { return position_ == tokens_.size(); }
  bool is(const char *symbol) const {
    return !at_end() && tokens_[position_].kind == Token::Kind::symbol &&
           tokens_[position_].text == symbol;
  }
  bool take(const char *symbol) {
    const bool found = is(symbol);
    position_ += found ? 1 : 0;
    return found;
  }

  void emit(Kind kind) { steps_.push_back({.kind = kind}); }
  void emit(const Number &constant) {
    steps_.push_back({.kind = Kind::constant, .constant = constant});
  }

  void sum() {
    product();
    while (is("+") || is("-")) {
      const Kind kind = take("+") ? Kind::add : Kind::subtract;
      position_ += kind == Kind::subtract ? 1 : 0;
      product();
      emit(kind);
    }
  }

  void product() {
    signed_power();
    while (is("*") || is("/")) {
      const Kind kind = take("*") ? Kind::multiply : Kind::divide;
      position_ += kind == Kind::divide ? 1 : 0;
      signed_power();
      emit(kind);
    }
  }

  void signed_power() {
    bool negative = false;
    for (; is("+") || is("-"); ++position_)
      negative = negative != is("-");
    power();
    if (negative)
      emit(Kind::negate);
  }

  void power() {
    operand();
    if (!at_end() && (tokens_[position_].kind != Token::Kind::symbol || is("(")))
      refuse("lacks an operator such as '*' before '" + tokens_[position_].text + "'");
    if (!take("^"))
      return;
    const Level level(*this);
    signed_power();
    emit(Kind::power);
  }

  void operand() {
    if (at_end())
      open_ > 0 ? refuse("has a '(' that is not closed") : refuse_structure();
    const Token &token = tokens_[position_];
    if (token.kind == Token::Kind::number)
      number(token.value);
    else if (token.kind == Token::Kind::name)
      name(token.text);
    else if (take("("))
      parenthesis();
    else
      refuse_symbol();
  }

  [[noreturn]] void refuse_symbol() const {
    if (is(")") && open_ == 0)
      refuse("has a ')' without '('");
    if (is(",") && !in_function_)
      refuse_comma();
    refuse_structure();
  }

  void parenthesis() {
    if (inside(false) != 1)
      refuse_comma();
  }

  /// What stands behind a '(' and its ')'; returns the number of values, which commas separate.
  std::size_t inside(bool in_function) {
    const Level level(*this);
    const bool outside = std::exchange(in_function_, in_function);
    ++open_;
    std::size_t count = 0;
    do {
      sum();
      ++count;
    } while (take(","));
    if (!take(")"))
      refuse("has a '(' that is not closed");
    --open_;
    in_function_ = outside;
    return count;
  }

  void number(double value) {
    ++position_;
    const std::optional<UnitFactor> unit = read_unit(tokens_, position_, UnitBegin::directly);
    emit(unit ? with_unit(*unit, value) : Number{.value = value});
  }

  Number with_unit(const UnitFactor &unit, double value) const {
    if (variables_.dimensionless)
      check_plain(unit, text_);
    return {.value = unit.times(value), .dimension = unit.dimension, .bare = false};
  }

  void name(const std::string &name) {
    const auto argument = std::find(arguments_.begin(), arguments_.end(), name);
    if (position_ + 1 < tokens_.size() && tokens_[position_ + 1].text == "(") {
      call(name);
    } else if (argument != arguments_.end()) {
      steps_.push_back({.kind = Kind::argument,
                        .index = static_cast<std::size_t>(argument - arguments_.begin())});
      ++position_;
    } else if (const auto variable = variables_.find(name); variable != variables_.end()) {
      emit(variable->second);
      ++position_;
    } else if (const std::optional<UnitFactor> unit = lone_unit()) {
      emit(with_unit(*unit, 1));
    } else if (name == "pi") {
      emit(Number{.value = std::numbers::pi});
      ++position_;
    } else {
      refuse_name(name);
    }
  }

  /// A unit without a number. "6 / N / m" divides by both: only the first belongs to the division.
  std::optional<UnitFactor> lone_unit() {
    const bool is_divisor = position_ > 0 && tokens_[position_ - 1].text == "/";
    return read_unit(tokens_, position_, is_divisor ? UnitBegin::alone : UnitBegin::directly);
  }

  void call(const std::string &function) {
    const auto found = std::find(function_names().begin(), function_names().end(), function);
    if (found == function_names().end())
      refuse("calls the unknown function '" + function + "'" +
             suggestion(function, function_names()));
    const auto index = static_cast<std::size_t>(found - function_names().begin());
    position_ += 2;
    const std::size_t count = inside(true);
    if (count != 1 && !takes_several_values(index))
      refuse_structure();
    steps_.push_back({.kind = Kind::call, .index = index, .count = count});
  }

  [[noreturn]] void refuse_name(const std::string &name) const {
    std::vector<std::string> known = unit_names();
    for (const auto &[variable, value] : variables_)
      known.push_back(variable);
    refuse("holds '" + name + "', which is neither a unit nor a variable" +
           suggestion(name, known));
  }

  const std::string &text_;
  const VariableTable &variables_;
  const std::vector<std::string> &arguments_;
  std::vector<Token> tokens_;
  std::size_t position_ = 0;
  std::vector<Step> steps_{};
  int open_ = 0;             ///< parentheses
  bool in_function_ = false; ///< the innermost parenthesis holds the values of a function
  int depth_ = 0;
};

} // namespace

std::vector<Step> read_steps(const std::string &text, const VariableTable &variables,
                             const std::vector<std::string> &arguments) {
  return Reader(text, variables, arguments).read();
}

} // namespace vibroimpact::parameters
