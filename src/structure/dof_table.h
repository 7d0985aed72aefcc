// Which displacement or rotation of which node each row of given matrices belongs to.
#pragma once

#include "common/linear_algebra.h"

#include <optional>
#include <string>
#include <vector>

namespace vibroimpact::structure {

struct TableRow {
  int node = 0;                      ///< its number, at least 1
  int component = 0;                 ///< 0..5: x, y, z, rx, ry, rz
  std::optional<Vector3> position{}; ///< in the unit of the file
};

/// One row for each line NODE.DIRECTION, as CalculiX writes them, or NODE DIRECTION, each with or
/// without three coordinates behind it. Directions are 1 to 6 or x, y, z, rx, ry, rz; empty lines
/// and those that begin with # do not count. `file` is its name for messages. Throws the
/// DefinitionError of Matrices/Table with the line.
std::vector<TableRow> read_dof_table(const std::string &content, const std::string &file);

} // namespace vibroimpact::structure
