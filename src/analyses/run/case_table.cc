#include "analyses/run/case_table.h"

#include "parameters/text.h"
#include "reduction/body_file.h"

#include <boost/algorithm/string.hpp>

#include <charconv>
#include <filesystem>
#include <optional>
#include <sstream>

namespace vibroimpact::analyses {

using parameters::Values;

namespace {

constexpr const char *cases_key = "Cases";

struct CaseColumn {
  std::string path;
  std::string unit; ///< may be empty
};

/// "Variables/beta [rad/s]"
CaseColumn read_column(const Values &grid, const std::string &head) {
  const std::size_t bracket = head.find('[');
  if (bracket == std::string::npos)
    return {.path = head, .unit = ""};
  if (!head.ends_with(']'))
    grid.reject(cases_key,
                "the head of a column must be PATH or PATH [UNIT], but is '" + head + "'.");
  return {.path = parameters::normalised(head.substr(0, bracket)),
          .unit = parameters::normalised(head.substr(bracket + 1, head.size() - bracket - 2))};
}

bool is_number(const std::string &text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

std::string with_unit(const std::string &value, const std::string &unit) {
  if (unit.empty())
    return value;
  return is_number(value) ? value + " " + unit : "(" + value + ") * (1 " + unit + ")";
}

std::vector<std::string> rows_of(const Values &grid) {
  std::vector<std::string> rows;
  boost::split(rows, grid.text(cases_key), boost::is_any_of(";"));
  if (rows.size() > 1 && parameters::normalised(rows.back()).empty())
    rows.pop_back();
  if (rows.size() < 2)
    grid.reject(cases_key, "Cases must have a row of keys and at least one row of values, "
                           "separated by ';', or be the name of a .csv file.");
  return rows;
}

GridKey key_of(const Values &grid, const std::string &head) {
  const CaseColumn column = read_column(grid, head);
  GridKey key{.path = column.path, .values = {}, .origin = grid.place(cases_key) + ":"};
  try {
    key.target = grid.parameters().key_path(column.path);
  } catch (const InputError &error) {
    grid.reject(cases_key, error.what());
  }
  return key;
}

std::string count_of(std::size_t count, const std::string &what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

void add_row(const Values &grid, const std::vector<std::string> &heads, const std::string &row,
             std::size_t number, std::vector<GridKey> &keys) {
  const std::vector<std::string> cells = parameters::split_list(row);
  if (cells.size() != heads.size())
    grid.reject(cases_key, "row " + std::to_string(number) + " must have " +
                               count_of(heads.size(), "value") + ", one for each key, but has " +
                               count_of(cells.size(), "value") + ".");
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].empty())
      grid.reject(cases_key, "row " + std::to_string(number) + " must have a value for " +
                                 keys[c].path + ", but has none.");
    keys[c].values.push_back(with_unit(cells[c], read_column(grid, heads[c]).unit));
  }
}

/// The rows of a CSV file without comments and empty lines, as in the key.
std::string inline_table(const Values &grid, const std::string &file) {
  const std::optional<std::string> content = reduction::read_file(file);
  if (!content)
    grid.reject(cases_key, "the file '" + file + "' cannot be read.");
  if (content->find(';') != std::string::npos || !parameters::is_plain_text(*content))
    grid.reject(cases_key,
                "the file '" + file + "' must be text whose columns are separated by commas.");
  std::istringstream stream(*content);
  std::string table;
  for (std::string line; std::getline(stream, line);)
    if (line = parameters::normalised(line.substr(0, line.find('#'))); !line.empty())
      table += line + "; ";
  return table;
}

} // namespace

void declare_case_table(parameters::Section &grid) {
  grid.text(cases_key, "",
            "The cases as a table instead of sections Key: the keys as PATH or PATH [UNIT], "
            "separated by commas; then each case behind a ';', its values separated by commas. Or "
            "the name of a .csv file with the same in its lines. The first column is the axis.");
}

GridKey read_case_table(const Values &grid) {
  const std::vector<std::string> rows = rows_of(grid);
  const std::vector<std::string> heads = parameters::split_list(rows.front());
  std::vector<GridKey> keys;
  for (const std::string &head : heads)
    keys.push_back(key_of(grid, head));
  for (std::size_t r = 1; r < rows.size(); ++r)
    add_row(grid, heads, rows[r], r, keys);
  GridKey leader = keys.front();
  leader.followers.assign(keys.begin() + 1, keys.end());
  return leader;
}

std::vector<parameters::Override> tables_from_files(const Values &root, const std::string &folder) {
  std::vector<parameters::Override> tables;
  for (const std::string &name : root.instances("Analysis")) {
    const Values grid = root.instance("Analysis", name).subsection("Parameter grid");
    const std::string file = grid.text(cases_key);
    if (file.ends_with(".csv"))
      tables.push_back(
          {.path = "Analysis/" + name + "/Parameter grid/" + cases_key,
           .value = inline_table(grid, (std::filesystem::path(folder) / file).string()),
           .origin = "table of " + file + ":"});
  }
  return tables;
}

} // namespace vibroimpact::analyses
