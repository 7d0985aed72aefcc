// Tables in text files: lines of cells between separators.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::parameters {

using Cells = std::vector<std::string>;

/// Calls `use` with the number (from 1) and the cells of every line of `content`, without blanks
/// and quotation marks around cells. Empty lines, comments (# or %) and a byte order mark are left
/// out. `separator`: "comma", "semicolon" or "space" (blanks and tabs).
void for_each_table_line(const std::string &content, const std::string &separator,
                         const std::function<void(long, const Cells &)> &use);

/// The whole cell as a number; none when it is no number.
std::optional<double> cell_number(const std::string &cell);

} // namespace vibroimpact::parameters
