#include "parameters/tokens.h"

#include "parameters/expression.h"

#include <cctype>
#include <charconv>

namespace vibroimpact::parameters {

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Bytes above 127 belong to the micro sign of units.
bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
         static_cast<unsigned char>(c) > 127;
}

Token number_at(const std::string &text, std::size_t position) {
  Token token{Token::Kind::number, "", 0};
  const char *begin = text.data() + position;
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), token.value);
  if (error != std::errc{})
    throw Refused("'" + text + "' holds a number that is too large or too small");
  token.text.assign(begin, end);
  return token;
}

Token name_at(const std::string &text, std::size_t position) {
  std::size_t end = position;
  while (end < text.size() && is_name_character(text[end]))
    ++end;
  return {Token::Kind::name, text.substr(position, end - position)};
}

Token token_at(const std::string &text, std::size_t position) {
  const char c = text[position];
  if (is_digit(c) || (c == '.' && position + 1 < text.size() && is_digit(text[position + 1])))
    return number_at(text, position);
  if (c == '%')
    return {Token::Kind::name, "%"};
  if (is_name_character(c))
    return name_at(text, position);
  if (std::string("+-*/^(),").find(c) != std::string::npos)
    return {Token::Kind::symbol, std::string(1, c)};
  throw Refused("'" + text + "' holds '" + std::string(1, c) + "', which no number can");
}

/// Reads composed units by recursive descent.
class UnitReader {
public:
  UnitReader(const std::vector<Token> &tokens, std::size_t position)
      : tokens_(tokens), position_(position) {}

  std::optional<UnitFactor> read(UnitBegin begin) {
    const std::optional<UnitFactor> first = power();
    if (begin == UnitBegin::alone)
      return first;
    const bool divided = begin == UnitBegin::maybe_divided && is_symbol("/");
    if (!first && !(divided && unit_begins(position_ + 1)))
      return std::nullopt;
    UnitFactor total = first.value_or(UnitFactor{});
    bool denominator_open = false;
    while (const std::optional<UnitFactor> next = next_factor(denominator_open))
      total = product(total, *next);
    return total;
  }
  std::size_t position() const { return position_; }

private:
  bool is_symbol(const char *symbol) const {
    return position_ < tokens_.size() && tokens_[position_].kind == Token::Kind::symbol &&
           tokens_[position_].text == symbol;
  }
  bool is_unit(std::size_t at) const {
    return at < tokens_.size() && tokens_[at].kind == Token::Kind::name &&
           find_unit(tokens_[at].text) != nullptr &&
           !(at + 1 < tokens_.size() && tokens_[at + 1].text == "(");
  }
  bool unit_begins(std::size_t at) const {
    return is_unit(at) || (at < tokens_.size() && tokens_[at].text == "(" && is_unit(at + 1));
  }

  std::optional<UnitFactor> next_factor(bool &denominator_open) {
    if (is_symbol("/") && unit_begins(position_ + 1)) {
      ++position_;
      denominator_open = true;
      return raised(is_symbol("(") ? group() : *power(), -1);
    }
    if (is_symbol("*") && is_unit(position_ + 1)) {
      ++position_;
      return power();
    }
    if (!is_unit(position_))
      return std::nullopt;
    if (denominator_open)
      throw Refused("the unit '" + tokens_[position_].text +
                    "' after a division can be read in two ways; write N s/m or N/(m s)");
    return power();
  }

  UnitFactor group() {
    constexpr int most = 20;
    if (++depth_ > most)
      throw Refused("a unit nests parentheses more than " + std::to_string(most) + " deep");
    ++position_;
    const UnitFactor unit = read(UnitBegin::directly).value_or(UnitFactor{});
    if (!is_symbol(")"))
      throw Refused("a unit in parentheses is not closed by ')'");
    ++position_;
    --depth_;
    return unit;
  }

  std::optional<UnitFactor> power() {
    if (!is_unit(position_))
      return std::nullopt;
    const UnitFactor unit = *find_unit(tokens_[position_].text);
    ++position_;
    if (!is_symbol("^"))
      return unit;
    ++position_;
    return raised(unit, exponent());
  }

  /// "2", "-1.5", "(3/2)".
  double exponent() {
    const bool in_parentheses = is_symbol("(");
    position_ += in_parentheses ? 1 : 0;
    double value = signed_number();
    if (in_parentheses && is_symbol("/")) {
      ++position_;
      value /= signed_number();
    }
    if (in_parentheses && !is_symbol(")"))
      throw Refused("the exponent of a unit is not closed by ')'");
    position_ += in_parentheses ? 1 : 0;
    return value;
  }

  double signed_number() {
    const double sign = is_symbol("-") ? -1 : 1;
    position_ += is_symbol("-") ? 1 : 0;
    if (position_ == tokens_.size() || tokens_[position_].kind != Token::Kind::number)
      throw Refused("the exponent of a unit is missing");
    return sign * tokens_[position_++].value;
  }

  const std::vector<Token> &tokens_;
  std::size_t position_;
  int depth_ = 0; ///< of parentheses
};

} // namespace

std::vector<Token> tokens_of(const std::string &text) {
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < text.size();) {
    if (std::isspace(static_cast<unsigned char>(text[i])) != 0) {
      ++i;
      continue;
    }
    tokens.push_back(token_at(text, i));
    i += tokens.back().text.size();
  }
  return tokens;
}

std::optional<UnitFactor> read_unit(const std::vector<Token> &tokens, std::size_t &position,
                                    UnitBegin begin) {
  UnitReader reader(tokens, position);
  const std::optional<UnitFactor> unit = reader.read(begin);
  if (unit)
    position = reader.position();
  return unit;
}

} // namespace vibroimpact::parameters
