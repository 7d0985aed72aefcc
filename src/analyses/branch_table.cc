#include "analyses/branch_table.h"

#include "analyses/fields.h"
#include "analyses/orbit_fields.h"
#include "analyses/stacked_points.h"
#include "analyses/window_recording.h"
#include "common/error.h"

#include <algorithm>

namespace vibroimpact::analyses {

using continuation::BranchPoint;
using continuation::End;
using continuation::Special;
using continuation::SpecialPoint;
using periodic::Orbit;
using periodic::Section;

namespace {

constexpr const char *kinds = "1 fold, 2 branch point, 3 period doubling, 4 loss of symmetry, 5 "
                              "Neimark-Sacker, 6 graze, 7 grazing fold, 8 change of the contact "
                              "changes";
constexpr const char *reasons = "0 lower end of the key, 1 upper end of the key, 2 the branch "
                                "closes on itself, 3 it falls onto motions of a smaller multiple, "
                                "4 least step, 5 most points, 6 a graze it returns to again and "
                                "again, 7 the motion grows beyond all measure";

int number_of(End end) {
  switch (end) {
  case End::lower_bound:
    return 0;
  case End::upper_bound:
    return 1;
  case End::closed:
    return 2;
  case End::shorter_return:
    return 3;
  case End::least_step:
    return 4;
  case End::most_points:
    return 5;
  case End::graze:
    return 6;
  case End::far:
    return 7;
  }
  return -1;
}

int number_of(Special kind, const Section &section) {
  switch (kind) {
  case Special::fold:
    return 1;
  case Special::branch_point:
    return 2;
  case Special::flip:
    return section.with_symmetry() ? 4 : 3;
  case Special::neimark_sacker:
    return 5;
  case Special::graze:
    return 6;
  case Special::grazing_fold:
    return 7;
  case Special::pattern_change:
    return 8;
  }
  return 0;
}

std::string per(const std::string &unit) { return unit == "1" ? unit : "1/(" + unit + ")"; }

void add_special_values(PointResult &row, const SpecialPoint &special, const Section &section,
                        const std::string &unit) {
  const auto add = [&row](const char *name, double value, const std::string &in, const char *text) {
    row.fields.push_back(scalar_field(name, value, in, text));
  };
  add("kind", number_of(special.kind, section), "1", kinds);
  add("unstable_before", special.unstable_before, "1",
      "multipliers outside the unit circle on the side of smaller arclength");
  add("unstable_after", special.unstable_after, "1",
      "multipliers outside the unit circle on the side of larger arclength");
  add("multiplier_slope", special.slope, per(unit),
      "derivative, by the key, of the multiplier that crosses the unit circle, of the modulus for "
      "a "
      "pair; where it is small the place is sensitive. 0 at other kinds");
}

} // namespace

BranchTable::BranchTable(const SweptParameter &parameter, KeyedMap &maps,
                         const std::vector<RecorderFactory> &recorders)
    : parameter_(parameter), maps_(maps), recorders_(recorders),
      key_(parameter.axis_name(), parameter.unit, parameter.axis().description),
      arclength_("arclength", "1",
                 "from the start of the branch, in unknowns made comparable; negative behind it"),
      branch_("branch", "1",
              "number of the branch: 0 is that of the start, the others begin at "
              "special points") {}

void BranchTable::begin(long number, long halves, double sign) {
  number_ = number;
  halves_ = halves;
  sign_ = sign;
}

PointResult BranchTable::orbit_of(const BranchPoint &point) const {
  const Section section{.phase = point.point.chart, .halves = halves_};
  const periodic::StroboscopicMap &map = maps_.at(point.point.keys[0]);
  Orbit orbit{
      .section = section,
      .point = {.state = point.point.state, .image = map.image(section, point.point.state)}};
  orbit.point.residual =
      map.norm(orbit.point.image.state - orbit.point.state) / map.norm(orbit.point.state);
  PointResult row;
  const Vector state = state_at_zero_phase(map, orbit);
  add_orbit(row, map, orbit, state);
  try {
    record(state, map.period(), section.multiple(), row);
  } catch (const NumericalError &) { // leaves the figures of this motion empty
  }
  return row;
}

void BranchTable::record(const Vector &state, double period, long periods, PointResult &row) const {
  WindowRecording recording(recorders_, maps_.system());
  motion::Trajectory &trajectory = maps_.trajectory();
  trajectory.start({.time = 0, .physical = state});
  recording.run(periods_window(0, period, periods), trajectory);
  recording.add_fields(row);
  add_accuracy(row, trajectory.accuracy(), maps_.system().integration);
}

BranchTable::Row BranchTable::row_of(const BranchPoint &point) const {
  Row row{.arclength = sign_ * point.arclength, .branch = number_};
  row.values.fields = {scalar_field(branch_, static_cast<double>(number_)),
                       scalar_field(arclength_, row.arclength),
                       scalar_field(key_, point.point.keys[0])};
  const PointResult orbit = orbit_of(point);
  row.values.fields.insert(row.values.fields.end(), orbit.fields.begin(), orbit.fields.end());
  return row;
}

void BranchTable::add(const BranchPoint &point) { points_.push_back(row_of(point)); }

void BranchTable::add(const SpecialPoint &special) {
  Row row = row_of(special.at);
  SpecialPoint ordered = special;
  if (sign_ < 0)
    std::swap(ordered.unstable_before, ordered.unstable_after);
  add_special_values(row.values, ordered, {.phase = 0, .halves = halves_}, parameter_.unit);
  special_.push_back(std::move(row));
}

void BranchTable::drop(long number) {
  for (std::vector<Row> *rows : {&points_, &special_, &ends_})
    std::erase_if(*rows, [number](const Row &row) { return row.branch == number; });
}

void BranchTable::end(const continuation::Branch &branch) {
  if (branch.points.empty())
    return;
  const BranchPoint &last = branch.points.back();
  Row row{.arclength = sign_ * last.arclength, .branch = number_};
  row.values.fields = {scalar_field(branch_, static_cast<double>(number_)),
                       scalar_field(key_, last.point.keys[0]),
                       scalar_field("reason", number_of(branch.end), "1", reasons)};
  ends_.push_back(std::move(row));
}

std::vector<PointResult> BranchTable::in_order(std::vector<Row> rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const Row &a, const Row &b) {
    return std::pair(a.branch, a.arclength) < std::pair(b.branch, b.arclength);
  });
  std::vector<PointResult> values;
  values.reserve(rows.size());
  for (Row &row : rows)
    values.push_back(std::move(row.values));
  return values;
}

void BranchTable::add_fields(PointResult &result) const {
  const auto add = [&result](const std::vector<PointResult> &rows, const char *dimension,
                             const char *prefix) {
    for (Field &field : stacked(rows, dimension, prefix))
      result.fields.push_back(std::move(field));
  };
  add(in_order(points_), "branch_point", "");
  const std::vector<PointResult> special = in_order(special_);
  add(special, "special_point", "special/");
  add(in_order(ends_), "branch_end", "end/");
  result.summary.push_back(scalar_line("points", static_cast<double>(points_.size()), "1"));
  for (std::size_t i = 0; i < special.size(); ++i)
    for (const Field &field : special[i].fields)
      if (field.name() == "kind" || field.label == key_ || field.name() == "orbit_residual")
        result.summary.push_back(
            scalar_line("special[" + std::to_string(i + 1) + "]." + field.name(), field.values[0],
                        field.unit()));
}

} // namespace vibroimpact::analyses
