#include "analyses/locus_table.h"

#include "analyses/fields.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace vibroimpact::analyses {

using continuation::Locus;
using continuation::LocusEnd;
using continuation::LocusKind;
using continuation::LocusPoint;
using continuation::LocusSpecial;
using continuation::SpecialLocusPoint;
using periodic::Orbit;
using periodic::Section;

namespace {

constexpr const char *locus_kinds =
    "of the locus: 1 fold, 3 period doubling, 4 loss of symmetry, 5 Neimark-Sacker, 6 graze";
constexpr const char *special_kinds = "1 cusp, 2 end on a grazing curve";
constexpr const char *locus_ends =
    "0 end of a key, 1 the locus closes on itself, 2 it meets a grazing "
    "curve, 3 the pair of multipliers becomes real, 4 least step, 5 "
    "most points, 6 the motion grows beyond all measure, 7 the locus "
    "could not be entered";
constexpr int not_entered = 7;

int number_of(LocusKind kind, const Section &section) {
  switch (kind) {
  case LocusKind::fold:
    return 1;
  case LocusKind::flip:
    return section.with_symmetry() ? 4 : 3;
  case LocusKind::neimark_sacker:
    return 5;
  case LocusKind::graze:
    return 6;
  }
  return 0;
}

int number_of(LocusEnd end) {
  switch (end) {
  case LocusEnd::bounds:
    return 0;
  case LocusEnd::closed:
    return 1;
  case LocusEnd::graze:
    return 2;
  case LocusEnd::real_pair:
    return 3;
  case LocusEnd::least_step:
    return 4;
  case LocusEnd::most_points:
    return 5;
  case LocusEnd::far:
    return 6;
  }
  return -1;
}

// Of the whole motion, whose multipliers are the squares of those of half a symmetric one.
double angle_of(const LocusPoint &point, LocusKind kind, const Section &section) {
  if (kind != LocusKind::neimark_sacker)
    return std::numeric_limits<double>::quiet_NaN();
  const double angle = section.with_symmetry() ? 2 * point.angle : point.angle;
  return std::min(angle, 2 * std::numbers::pi - angle);
}

Label key_label(const SweptParameter &key, const std::string &which) {
  return {key.axis_name(), key.unit, which + " key: " + key.axis().description};
}

} // namespace

LocusTable::LocusTable(const std::vector<SweptParameter> &keys, KeyedMap &maps,
                       const std::vector<RecorderFactory> &recorders, StepRecord *steps)
    : maps_(maps), orbits_(maps, recorders),
      kept_(steps), keys_{key_label(keys[0], "first"), key_label(keys[1], "second")},
      arclength_("arclength", "1",
                 "from the start of the locus, in unknowns made comparable; negative behind it"),
      locus_("locus", "1", "number of the locus, from 0"), kind_("kind", "1", locus_kinds) {}

void LocusTable::begin(long number, LocusKind kind, long halves, double sign) {
  number_ = number;
  kind_number_ = kind;
  halves_ = halves;
  sign_ = sign;
}

void LocusTable::add_keys(PointResult &row, const Vector &keys) const {
  row.fields.push_back(scalar_field(locus_, static_cast<double>(number_)));
  for (std::size_t k = 0; k < keys_.size(); ++k)
    row.fields.push_back(scalar_field(keys_[k], keys[static_cast<Index>(k)]));
}

// With the image that the locus has found: at a graze the map itself has no derivative.
Orbit LocusTable::orbit_of(const LocusPoint &point) const {
  const Index n = point.defect.size();
  Orbit orbit{.section = {.phase = point.point.chart, .halves = halves_},
              .point = {.state = point.point.state, .image = {}}};
  orbit.point.image.state = point.point.state + point.defect;
  orbit.point.image.by_state = point.by_state + Matrix::Identity(n, n);
  const periodic::StroboscopicMap &map = maps_.at(point.point.keys);
  orbit.point.residual = map.norm(point.defect) / map.norm(point.point.state);
  return orbit;
}

CurveRow LocusTable::row_of(const LocusPoint &point) {
  return {.arclength = sign_ * point.arclength, .curve = number_, .values = kept_([&] {
                                                                    return values_of(point);
                                                                  })};
}

PointResult LocusTable::values_of(const LocusPoint &point) const {
  PointResult row;
  add_keys(row, point.point.keys);
  const Orbit orbit = orbit_of(point);
  const double changes = (static_cast<double>(point.pattern.size()) -
                          static_cast<double>(maps_.system().contacts.size())) /
                         4 * (orbit.symmetric() ? 2 : 1);
  const auto add = [&row](const char *name, double value, const char *text, const char *unit) {
    row.fields.push_back(scalar_field(name, value, unit, text));
  };
  row.fields.push_back(scalar_field(arclength_, sign_ * point.arclength));
  add("locus_residual", point.residual,
      "length of the residual of the motion and of the condition of the locus, made comparable",
      "1");
  add("multiplier_angle", angle_of(point, kind_number_, orbit.section),
      "argument of the pair of multipliers of modulus 1; Neimark-Sacker only", "rad");
  add("side", point.side,
      "1 or -1: the side, by the first key, on which there are two motions more (fold), the "
      "multiplier is outside the unit circle, or the contact touches (graze)",
      "1");
  add("contact_changes", changes, "contact changes of the motion, a graze among them", "1");
  const PointResult motion = orbits_.of(point.point.keys, orbit);
  row.fields.insert(row.fields.end(), motion.fields.begin(), motion.fields.end());
  return row;
}

void LocusTable::add(const LocusPoint &point) {
  CurveRow row = row_of(point);
  row.values.fields.push_back(
      scalar_field(kind_, number_of(kind_number_, {.phase = 0, .halves = halves_})));
  points_.push_back(std::move(row));
}

void LocusTable::end(const Locus &locus) {
  for (const SpecialLocusPoint &special : locus.special) {
    CurveRow row = row_of(special.at);
    row.values.fields.push_back(
        scalar_field("kind", special.kind == LocusSpecial::cusp ? 1 : 2, "1", special_kinds));
    special_.push_back(std::move(row));
  }
  const LocusPoint &last = locus.points.back();
  add_end(last.point.keys, last.arclength, number_of(locus.end));
}

void LocusTable::end_at_start(const Vector &keys) { add_end(keys, 0, not_entered); }

void LocusTable::add_end(const Vector &keys, double arclength, int reason) {
  CurveRow row{.arclength = sign_ * arclength, .curve = number_};
  add_keys(row.values, keys);
  row.values.fields.push_back(scalar_field("reason", reason, "1", locus_ends));
  ends_.push_back(std::move(row));
}

void LocusTable::add_fields(PointResult &result) const {
  const std::vector<PointResult> special = in_order(special_);
  add_rows(result, in_order(points_), "locus_point", "");
  add_rows(result, special, "special_point", "special/");
  add_rows(result, in_order(ends_), "locus_end", "end/");
  result.summary.push_back(scalar_line("points", static_cast<double>(points_.size()), "1"));
  summarise_special(result, special,
                    {"kind", "locus", keys_[0].name(), keys_[1].name(), "locus_residual"});
}

} // namespace vibroimpact::analyses
