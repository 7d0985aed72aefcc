#include "parameters/text.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace vibroimpact::parameters {

namespace {

bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

std::string lower_case(std::string text) {
  for (char &c : text)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Insertions, deletions, replacements and swaps of neighbours (Damerau 1964, restricted form).
std::size_t edit_distance(const std::string &a, const std::string &b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

} // namespace

std::string normalised(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (!is_blank(c))
      result += c;
    else if (!result.empty() && result.back() != ' ')
      result += ' ';
  }
  if (!result.empty() && result.back() == ' ')
    result.pop_back();
  return result;
}

std::vector<std::string> split_list(const std::string &text, bool arrows) {
  std::vector<std::string> parts;
  if (normalised(text).empty())
    return parts;
  int depth = 0;
  std::string part;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    const bool arrow = arrows && depth == 0 && text.compare(i, 2, "->") == 0;
    if (arrow || (depth == 0 && text[i] == ',')) {
      parts.push_back(normalised(part));
      part.clear();
      i += arrow ? 1 : 0;
    } else {
      part += text[i];
    }
  }
  parts.push_back(normalised(part));
  return parts;
}

std::string join(const std::vector<std::string> &parts, const std::string &separator) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : separator) + parts[i];
  return text;
}

std::string number_text(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string shortened(const std::string &text, std::size_t most) {
  if (text.size() <= most)
    return text;
  // Not within a character: its later bytes are 10xxxxxx.
  const auto boundary = [&text](std::size_t at) {
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U)
      ++at;
    return at;
  };
  return text.substr(0, boundary(most / 2)) + " ... " +
         text.substr(boundary(text.size() - most / 2));
}

bool is_plain_text(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const bool control = (first < 0x20 && !is_blank(text[i])) || first == 0x7F;
    // 110xxxxx, 1110xxxx and 11110xxx begin characters of two, three and four bytes; C0, C1 and
    // those above F4 begin none.
    const std::size_t length = first < 0x80                    ? 1
                               : first >= 0xC2 && first < 0xE0 ? 2
                               : first >= 0xE0 && first < 0xF0 ? 3
                               : first >= 0xF0 && first < 0xF5 ? 4
                                                               : 0;
    if (control || length == 0 || i + length > text.size())
      return false;
    for (std::size_t k = 1; k < length; ++k)
      if ((static_cast<unsigned char>(text[i + k]) & 0xC0U) != 0x80U)
        return false;
    i += length;
  }
  return true;
}

bool begins_with_letter(std::string_view name) {
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0;
}

std::string nearest(const std::string &word, const std::vector<std::string> &candidates) {
  std::string best;
  // One wrong letter in three; in words of one or two letters only the case may be wrong.
  const std::size_t allowed = word.size() < 3 ? 0 : word.size() / 3;
  std::size_t smallest = allowed + 1;
  if (word.size() > 100)
    return best; // no name, and its distances would take long
  for (const std::string &candidate : candidates) {
    const std::size_t distance = edit_distance(lower_case(word), lower_case(candidate));
    if (distance < smallest) {
      smallest = distance;
      best = candidate;
    }
  }
  return best;
}

std::string suggestion(const std::string &word, const std::vector<std::string> &candidates) {
  const std::string best = nearest(word, candidates);
  return best.empty() ? "" : "; did you mean '" + best + "'?";
}

} // namespace vibroimpact::parameters
