#include "parameters/table_text.h"

#include <boost/algorithm/string.hpp>

#include <charconv>
#include <sstream>

namespace vibroimpact::parameters {

namespace {

Cells cells_of(const std::string &line, const std::string &separator) {
  Cells cells;
  if (separator == "space")
    boost::split(cells, line, boost::is_any_of(" \t"), boost::token_compress_on);
  else
    boost::split(cells, line, boost::is_any_of(separator == "comma" ? "," : ";"));
  for (std::string &cell : cells) {
    boost::trim(cell);
    boost::trim_if(cell, boost::is_any_of("\""));
  }
  return cells;
}

} // namespace

void for_each_table_line(const std::string &content, const std::string &separator,
                         const std::function<void(long, const Cells &)> &use) {
  std::istringstream text(content);
  std::string line;
  for (long number = 1; std::getline(text, line); ++number) {
    if (number == 1 && line.starts_with("\xEF\xBB\xBF")) // byte order mark
      line.erase(0, 3);
    boost::trim(line);
    if (!line.empty() && line[0] != '#' && line[0] != '%')
      use(number, cells_of(line, separator));
  }
}

std::optional<double> cell_number(const std::string &cell) {
  const char *begin = cell.data() + (cell.starts_with("+") ? 1 : 0);
  const char *end = cell.data() + cell.size();
  double value = 0;
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || rest != end)
    return std::nullopt;
  return value;
}

} // namespace vibroimpact::parameters
