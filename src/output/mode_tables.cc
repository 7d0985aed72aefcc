#include "output/mode_tables.h"

#include "common/durable_file.h"
#include "reduction/known_flexibility.h"

#include <array>
#include <numbers>
#include <sstream>

namespace vibroimpact::output {

namespace {

using reduction::BodyPoint;
using reduction::ReducedBody;

struct ModeColumn {
  std::string head;
  Vector values; ///< for each mode
};

void add_points(const ReducedBody &body, std::vector<ModeColumn> &columns) {
  constexpr std::array components = {"x", "y", "z", "rx", "ry", "rz"};
  for (const BodyPoint &point : body.points)
    for (std::size_t i = 0; i < components.size(); ++i) {
      const Vector values = point.rows.row(static_cast<Index>(i)).transpose();
      // A point that nothing moves is there all the same.
      if (!values.isZero(0) || (i == 0 && point.rows.isZero(0)))
        columns.push_back({point.name + "." + components[i], values});
    }
}

std::vector<ModeColumn> columns_of(const ReducedBody &body, double unit) {
  std::vector<ModeColumn> columns = {
      {"mode", Vector::LinSpaced(body.size(), 1, static_cast<double>(body.size()))},
      {"frequency", body.omega() / unit},
      {"damping ratio", body.damping_ratio()},
      {"modal mass", body.mass}};
  if (body.base_participation.allFinite())
    for (Index axis = 0; axis < 3; ++axis)
      columns.push_back({std::string("participation.") + static_cast<char>('x' + axis),
                         body.base_participation.col(axis)});
  add_points(body, columns);
  return columns;
}

} // namespace

std::string mode_table(const ReducedBody &body, bool dimensionless) {
  const auto columns = columns_of(body, dimensionless ? 1 : 2 * std::numbers::pi);
  std::ostringstream text;
  text.precision(17);
  text << "# Modes of the body " << body.name << ": "
       << (dimensionless ? "angular frequencies" : "frequencies in Hz, masses in kg")
       << ", mode shapes per unit coordinate (Normalisation = modal mass)\n";
  for (std::size_t i = 0; i < columns.size(); ++i)
    text << (i == 0 ? "" : ",") << columns[i].head;
  text << "\n";
  for (Index j = 0; j < body.size(); ++j) {
    for (std::size_t i = 0; i < columns.size(); ++i)
      text << (i == 0 ? "" : ",") << columns[i].values[j];
    text << "\n";
  }
  return text.str();
}

void write_mode_tables(RunFolder &folder, const std::vector<ReducedBody> &bodies,
                       bool dimensionless) {
  for (const ReducedBody &body : bodies)
    if (reduction::has_modes(body))
      replace_file(folder.claim("modes/" + body.name + ".csv"), mode_table(body, dimensionless));
}

} // namespace vibroimpact::output
