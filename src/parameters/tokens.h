// The words of an expression, and the composed unit that may follow a number.
#pragma once

#include "parameters/units.h"

#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::parameters {

struct Token {
  enum class Kind { number, name, symbol } kind;
  std::string text;
  double value = 0; ///< of a number
};

/// Throws Refused on a character that no expression holds.
std::vector<Token> tokens_of(const std::string &text);

enum class UnitBegin {
  directly,      ///< "N s/m"
  maybe_divided, ///< also "/s", as behind the number of "1/s"
  alone          ///< one unit with its exponent, "N" of "N/m"
};

/// The composed unit beginning at tokens[position], and `position` moved behind it; nothing, and
/// `position` kept, if there is none. Throws Refused on one that can be read in two ways.
std::optional<UnitFactor> read_unit(const std::vector<Token> &tokens, std::size_t &position,
                                    UnitBegin begin);

} // namespace vibroimpact::parameters
