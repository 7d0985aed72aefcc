#include "structure/dof_table.h"

#include "structure/beam_definition.h"
#include "structure/text_lines.h"

#include <algorithm>
#include <array>

namespace vibroimpact::structure {

namespace {

constexpr std::array<std::string_view, 6> names = {"x", "y", "z", "rx", "ry", "rz"};

std::optional<int> component_of(std::string_view part) {
  if (const auto named = std::find(names.begin(), names.end(), part); named != names.end())
    return static_cast<int>(named - names.begin());
  const std::optional<int> number = number_of<int>(part);
  if (!number || *number < 1 || *number > 6)
    return std::nullopt;
  return *number - 1;
}

/// "5.1" is two parts.
void split_first(std::vector<std::string_view> &parts) {
  const std::size_t dot = parts[0].find('.');
  if (dot == std::string_view::npos)
    return;
  parts.insert(parts.begin() + 1, parts[0].substr(dot + 1));
  parts[0] = parts[0].substr(0, dot);
}

std::optional<TableRow> row_of(std::vector<std::string_view> parts) {
  split_first(parts);
  if (parts.size() != 2 && parts.size() != 5)
    return std::nullopt;
  const std::optional<int> node = number_of<int>(parts[0]);
  const std::optional<int> component = component_of(parts[1]);
  if (!node || *node < 1 || !component)
    return std::nullopt;
  TableRow row{.node = *node, .component = *component};
  if (parts.size() == 2)
    return row;
  row.position = Vector3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<double> value = number_of<double>(parts[2 + axis]);
    if (!value || !std::isfinite(*value))
      return std::nullopt;
    (*row.position)[axis] = *value;
  }
  return row;
}

} // namespace

std::vector<TableRow> read_dof_table(const std::string &content, const std::string &file) {
  std::vector<TableRow> rows;
  std::size_t number = 0;
  for (std::size_t position = 0; position < content.size();) {
    const std::string_view line = take_line(content, position);
    ++number;
    const std::vector<std::string_view> parts = parts_of(line, ",");
    if (parts.empty() || parts[0].front() == '#')
      continue;
    const std::optional<TableRow> row = row_of(parts);
    if (!row)
      throw DefinitionError("Matrices", "", "Table",
                            "must have lines NODE.DIRECTION or NODE DIRECTION, with or without "
                            "three coordinates, and directions 1 to 6, but " +
                                quoted_line(number, file, line));
    rows.push_back(*row);
  }
  if (rows.empty())
    throw DefinitionError("Matrices", "", "Table",
                          "must have a line for each row of the matrices, but " + file +
                              " has none");
  return rows;
}

} // namespace vibroimpact::structure
