// Small operations on the text of parameter files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vibroimpact::parameters {

/// Without blanks at both ends, every run of white space inside made one blank.
std::string normalised(std::string_view text);

/// Entries separated by commas outside parentheses, and by "->" if `arrows`; normalised. Text
/// without any entry gives an empty list; an entry itself may be empty ("1,,2").
std::vector<std::string> split_list(const std::string &text, bool arrows = false);

std::string join(const std::vector<std::string> &parts, const std::string &separator);

/// Shortest text that tells the number to six digits, for messages.
std::string number_text(double value);

/// Text of at most about `most` bytes: of a longer one the beginning and the end, with "..." for
/// what is left out.
std::string shortened(const std::string &text, std::size_t most);

/// Is it UTF-8 without control characters other than tabs and line breaks?
bool is_plain_text(std::string_view text);

bool begins_with_letter(std::string_view name);

/// The candidate with the smallest edit distance to `word`, or "" when none is near enough to be
/// meant. Upper and lower case count as equal.
std::string nearest(const std::string &word, const std::vector<std::string> &candidates);

/// "; did you mean 'X'?", or "" without a near candidate.
std::string suggestion(const std::string &word, const std::vector<std::string> &candidates);

} // namespace vibroimpact::parameters
