#include "parameters/table_text.h"
#include "parameters/text.h"
#include "reduction/modal_data.h"
#include "structure/beam_definition.h"

#include <cmath>
#include <numbers>
#include <set>

namespace vibroimpact::reduction {

namespace {

using parameters::Cells;

[[noreturn]] void fail(const std::string &problem) {
  throw structure::DefinitionError("Modal data", "", "File", problem);
}

/// Where the numbers of a column go.
struct Column {
  enum class Kind { none, frequency, damping_ratio, mass, participation, shape };
  Kind kind = Kind::none;
  std::size_t point = 0;
  int component = 0; ///< 0 to 5: x, y, z, rx, ry, rz; of the participation 0 to 2
};

const std::vector<std::string> component_names = {"x", "y", "z", "rx", "ry", "rz"};

/// Number of the component that a head ends with, -1 without any.
int component_of(const std::string &head) {
  const std::size_t dot = head.rfind('.');
  for (std::size_t i = 0; i < component_names.size() && dot != std::string::npos && dot > 0; ++i)
    if (head.substr(dot + 1) == component_names[i])
      return static_cast<int>(i);
  return -1;
}

class Table {
public:
  explicit Table(bool dimensionless) : unit_(dimensionless ? 1 : 2 * std::numbers::pi) {}

  void read_line(long line, const Cells &cells) {
    if (columns_.empty())
      read_heads(line, cells);
    else
      read_mode(line, cells);
  }

  ModalData result() const {
    const auto n = static_cast<Index>(modes_.size());
    if (n == 0)
      fail("must hold at least one mode below the line that names the columns");
    ModalData data{.frequency = unit_ * values(Column::Kind::frequency).col(0)};
    if (has(Column::Kind::damping_ratio))
      data.damping_ratio = values(Column::Kind::damping_ratio).col(0);
    if (has(Column::Kind::mass))
      data.mass = values(Column::Kind::mass).col(0);
    if (has(Column::Kind::participation))
      data.base_participation = values(Column::Kind::participation).leftCols(3);
    for (std::size_t p = 0; p < points_.size(); ++p)
      data.points.push_back({.name = points_[p],
                             .rows = values(Column::Kind::shape, p).transpose(),
                             .interface = interface_of(points_[p])});
    return data;
  }

private:
  void read_heads(long line, const Cells &heads) {
    std::set<std::string> known;
    for (const std::string &head : heads) {
      if (!known.insert(head).second)
        fail("must name each column once, but line " + std::to_string(line) + " has '" + head +
             "' twice");
      columns_.push_back(column(line, head));
    }
    if (!has(Column::Kind::frequency))
      fail("must have a column frequency; line " + std::to_string(line) + " names the columns: " +
           parameters::join(heads, ", ") + (heads.size() == 1 ? "; is the separator right?" : ""));
    if (points_.empty())
      fail("must have a column POINT.x, POINT.y... for the mode shapes at each point; line " +
           std::to_string(line) + " names the columns: " + parameters::join(heads, ", "));
  }

  Column column(long line, const std::string &head) {
    using Kind = Column::Kind;
    if (head == "mode")
      return {};
    if (head == "frequency")
      return {.kind = Kind::frequency};
    if (head == "damping ratio")
      return {.kind = Kind::damping_ratio};
    if (head == "modal mass")
      return {.kind = Kind::mass};
    const int component = component_of(head);
    if (head.starts_with("participation.") && component >= 0 && component < 3)
      return {.kind = Kind::participation, .component = component};
    if (component < 0 || head.starts_with("participation."))
      fail("must have columns mode, frequency, damping ratio, modal mass, participation.x (y, z) "
           "and POINT.x (y, z, rx, ry, rz), but line " +
           std::to_string(line) + " names a column '" + head + "'" +
           (head.find_first_of(",;\t ") != std::string::npos
                ? "; is the separator right?"
                : parameters::suggestion(head,
                                         {"mode", "frequency", "damping ratio", "modal mass"})));
    return {.kind = Kind::shape,
            .point = point(head.substr(0, head.rfind('.'))),
            .component = component};
  }

  std::size_t point(const std::string &name) {
    std::size_t p = 0;
    while (p < points_.size() && points_[p] != name)
      ++p;
    if (p == points_.size())
      points_.push_back(name);
    return p;
  }

  void read_mode(long line, const Cells &cells) {
    const std::string where = "line " + std::to_string(line);
    if (cells.size() != columns_.size())
      fail("must have as many cells in each line as columns, " + std::to_string(columns_.size()) +
           ", but " + where + " has " + std::to_string(cells.size()));
    std::vector<double> mode;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::optional<double> value = parameters::cell_number(cells[i]);
      if (columns_[i].kind != Column::Kind::none && !(value && std::isfinite(*value)))
        fail("must hold finite numbers, but column " + std::to_string(i + 1) + " of " + where +
             " has '" + cells[i] + "'");
      mode.push_back(value.value_or(0));
    }
    modes_.push_back(std::move(mode));
  }

  bool has(Column::Kind kind) const {
    for (const Column &column : columns_)
      if (column.kind == kind)
        return true;
    return false;
  }

  /// n x 6: the columns of a kind, and of a point, by their components.
  Matrix values(Column::Kind kind, std::size_t point = 0) const {
    Matrix all = Matrix::Zero(static_cast<Index>(modes_.size()), 6);
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (columns_[i].kind == kind && columns_[i].point == point)
        for (Index j = 0; j < all.rows(); ++j)
          all(j, columns_[i].component) = modes_[static_cast<std::size_t>(j)][i];
    return all;
  }

  double unit_; ///< of frequencies [rad/s]
  std::vector<Column> columns_;
  std::vector<std::string> points_;
  std::vector<std::vector<double>> modes_; ///< by the columns
};

} // namespace

ModalData read_modal_text(const std::string &content, const ModalDefinition &definition) {
  if (content.find('\0') != std::string::npos)
    fail("must be plain text or an HDF5 file whose name ends in .h5 or .hdf5; this file holds NUL "
         "bytes, as binary files do and texts in UTF-16");
  Table table(definition.dimensionless);
  parameters::for_each_table_line(
      content, definition.separator,
      [&](long line, const Cells &cells) { table.read_line(line, cells); });
  return table.result();
}

std::string interface_of(const std::string &point) {
  const std::size_t dot = point.rfind('.');
  const bool numbered = dot != std::string::npos && dot > 0 && dot + 1 < point.size() &&
                        point.find_first_not_of("0123456789", dot + 1) == std::string::npos;
  return numbered ? point.substr(0, dot) : "";
}

} // namespace vibroimpact::reduction
