// Text and numbers in JSON (RFC 8259).
#pragma once

#include <string>
#include <string_view>

namespace vibroimpact {

/// The text, which is UTF-8, in quotation marks, with what JSON cannot hold literally escaped.
std::string json_string(std::string_view text);

/// Fewest digits that give back the very number. JSON has no others than finite ones: null for NaN,
/// the strings "inf" and "-inf" for the infinite ones.
std::string json_number(double value);

} // namespace vibroimpact
