#include "analyses/curves/locus_table.h"

#include "analyses/results/coded.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace vibroimpact::analyses {

using continuation::End;
using continuation::Locus;
using continuation::LocusKind;
using continuation::LocusPoint;
using continuation::LocusSpecial;
using continuation::SpecialLocusPoint;
using periodic::Orbit;

namespace {

constexpr Coded<LocusKind> locus_kinds[] = {{LocusKind::fold, 1, "fold"},
                                            {LocusKind::flip, 3, "period doubling"},
                                            {LocusKind::flip, 4, "loss of symmetry"},
                                            {LocusKind::neimark_sacker, 5, "Neimark-Sacker"},
                                            {LocusKind::graze, 6, "graze"}};

constexpr Coded<LocusSpecial> special_kinds_of_loci[] = {
    {LocusSpecial::cusp, 1, "cusp"}, {LocusSpecial::ends_at_graze, 2, "end on a grazing curve"}};

// Loci that could not be entered have none of the ends.
constexpr std::optional<End> not_entered;
constexpr Coded<std::optional<End>> locus_ends[] = {
    {End::bounds, 0, "end of a key"},
    {End::closed, 1, "the locus closes on itself"},
    {End::graze, 2, "it meets a grazing curve"},
    {End::real_pair, 3, "the pair of multipliers becomes real"},
    {End::least_step, 4, "least step"},
    {End::most_points, 5, "most points"},
    {End::far, 6, "the motion grows beyond all measure"},
    {not_entered, 7, "the locus could not be entered"}};

// Behind flips stand those of symmetric motions.
int locus_kind_number(LocusKind kind, long halves) {
  return code_of(locus_kinds, kind) + (kind == LocusKind::flip && halves % 2 != 0 ? 1 : 0);
}

// Of the whole motion, whose multipliers are the squares of those of half a symmetric one.
double angle_of(const LocusPoint &point, LocusKind kind, const periodic::Section &section) {
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
                       const std::vector<RecorderFactory> &recorders)
    : maps_(maps), orbits_(maps, recorders),
      rows_("locus", "number of the locus, from 0",
            {key_label(keys[0], "first"), key_label(keys[1], "second")}),
      kind_("kind", "1", "of the locus: " + meaning_of(locus_kinds)) {}

void LocusTable::begin(long number, LocusKind kind, long halves, double sign) {
  rows_.begin(number, sign);
  kind_number_ = kind;
  halves_ = halves;
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

PointResult LocusTable::values_of(const LocusPoint &point) const {
  PointResult values;
  const FieldWriter row(values);
  const Orbit orbit = orbit_of(point);
  const double changes = (static_cast<double>(point.pattern.size()) -
                          static_cast<double>(maps_.system().contacts.size())) /
                         4 * (orbit.symmetric() ? 2 : 1);
  row.number(
      "locus_residual", point.residual, "1",
      "length of the residual of the motion and of the condition of the locus, made comparable");
  row.number("multiplier_angle", angle_of(point, kind_number_, orbit.section), "rad",
             "argument of the pair of multipliers of modulus 1; Neimark-Sacker only");
  row.number("side", point.side, "1",
             "1 or -1: the side, by the first key, with two additional motions (fold), the "
             "multiplier is outside the unit circle, or contact occurs (grazing)");
  row.number("contact_changes", changes, "1",
             "contact changes of the motion, grazing contacts included");
  const PointResult motion = orbits_.of(point.point.keys, orbit);
  values.fields.insert(values.fields.end(), motion.fields.begin(), motion.fields.end());
  return values;
}

void LocusTable::add(const LocusPoint &point) {
  PointResult values = values_of(point);
  FieldWriter(values).number(kind_, locus_kind_number(kind_number_, halves_));
  rows_.add(CurveTable::Part::point, point.point.keys, point.arclength, std::move(values));
}

void LocusTable::end(const Locus &locus) {
  for (const SpecialLocusPoint &special : locus.special) {
    PointResult values = values_of(special.at);
    FieldWriter(values).number("kind", code_of(special_kinds_of_loci, special.kind), "1",
                               meaning_of(special_kinds_of_loci));
    rows_.add(CurveTable::Part::special, special.at.point.keys, special.at.arclength,
              std::move(values));
  }
  const LocusPoint &last = locus.points.back();
  add_end(last.point.keys, last.arclength, locus.end);
  if (locus.end == End::least_step || locus.end == End::most_points)
    rows_.remark("a locus ends at " + rows_.at(last.point.keys) + ": " + locus.reason);
}

void LocusTable::end_at_start(const Vector &keys) { add_end(keys, 0, not_entered); }

void LocusTable::add_end(const Vector &keys, double arclength, std::optional<End> end) {
  PointResult values;
  FieldWriter(values).number("reason", code_of(locus_ends, end), "1", meaning_of(locus_ends));
  rows_.add(CurveTable::Part::end, keys, arclength, std::move(values));
}

void LocusTable::add_fields(PointResult &result) const {
  rows_.add_fields(
      result, {"kind", "locus", rows_.keys()[0].name(), rows_.keys()[1].name(), "locus_residual"});
  result.reason = rows_.remarks();
}

} // namespace vibroimpact::analyses
