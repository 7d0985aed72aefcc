// Lines of a text file and the numbers in them, for messages that say file and line.
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vibroimpact::structure {

/// Parts between blanks, tabulators and these separators; none of them is empty.
inline std::vector<std::string_view> parts_of(std::string_view line, std::string_view more = "") {
  const std::string separators = " \t\r" + std::string(more);
  std::vector<std::string_view> parts;
  for (std::size_t end = 0;;) {
    const std::size_t begin = line.find_first_not_of(separators, end);
    if (begin == std::string_view::npos)
      return parts;
    end = std::min(line.find_first_of(separators, begin), line.size());
    parts.push_back(line.substr(begin, end - begin));
  }
}

/// The whole part as a number, otherwise nothing. NaN and infinity are numbers here.
template <class Number> std::optional<Number> number_of(std::string_view part) {
  if (!part.empty() && part.front() == '+')
    part.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
  if (error != std::errc() || end != part.data() + part.size())
    return std::nullopt;
  return value;
}

/// The next line of a text without its end; moves `position` behind it.
inline std::string_view take_line(std::string_view text, std::size_t &position) {
  const std::size_t end = std::min(text.find('\n', position), text.size());
  std::string_view line = text.substr(position, end - position);
  position = std::min(end + 1, text.size());
  if (!line.empty() && line.back() == '\r')
    line.remove_suffix(1);
  return line;
}

/// "line 17 of plate.dof is \"5.x\"", for messages.
inline std::string quoted_line(std::size_t number, const std::string &file, std::string_view line) {
  return "line " + std::to_string(number) + " of " + file + " is \"" +
         std::string(line.substr(0, 60)) + "\"";
}

} // namespace vibroimpact::structure
