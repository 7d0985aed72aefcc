#include "analyses/curves/balance_table.h"

#include "analyses/recorders/extreme_values.h"
#include "analyses/results/fields.h"
#include "continuation/harmonic_series.h"

#include <algorithm>

namespace vibroimpact::analyses {

using continuation::HarmonicMotion;
using continuation::LeftOut;

namespace {

motion::ValueRange range_of(const RowVector &series) {
  const continuation::SeriesRange range = continuation::range_of(series);
  return {.minimum = range.minimum, .maximum = range.maximum};
}

void add_observed(const Observable &observed, const RowVector &series, const RowVector &left,
                  const FieldWriter &row) {
  const std::string &path = observed.path;
  const ExtremeValueLabels labels(observed);
  add_range(row, labels, range_of(series));
  row.array(Label(path + "/harmonic_amplitude", "m",
                  "amplitude of each harmonic of the forcing, from the absolute mean on",
                  {"harmonic"}),
            continuation::harmonic_amplitudes(series));
  row.number(path + "/left_out", range_of(left).peak(), "m",
             "largest displacement that the force above the last harmonic "
             "would cause by itself");
}

} // namespace

BalanceTable::BalanceTable(const SweptParameter &parameter, KeyedBalance &system,
                           continuation::HarmonicBalance &problem)
    : system_(system), problem_(problem), rows_(key_label(parameter)) {}

PointResult BalanceTable::values_of(const continuation::BranchPoint &point) const {
  const double key = point.point.keys[0];
  const HarmonicMotion motion = problem_.motion(point.point.state, key);
  const LeftOut left = problem_.left_out(motion, key);
  PointResult row;
  const FieldWriter fields(row);
  fields.number("balance_residual", point.residual, "1",
                "what the equations of the harmonics leave over, over the size of the motion");
  fields.number("force_left_out", left.force, "1",
                "root mean square of the forces of contacts and cubic springs above the last "
                "harmonic, up to three times its number, over that of all");
  fields.array(
      Label("coefficients", "SI",
            "of each coordinate: mean, cosine and sine of the first harmonic, of the second...",
            {"coordinate", "coefficient"}),
      motion.coordinates);
  add_points(motion, left, row);
  add_contacts(motion, row);
  return row;
}

void BalanceTable::add_points(const HarmonicMotion &motion, const LeftOut &left,
                              const FieldWriter &row) const {
  const ObservedSelection displacements{
      .points = {}, .kinds = {"displacement", "absolute_displacement", "rotation", "elongation"}};
  for (const Observable &observed : point_observables(system_.system().model, displacements)) {
    const model::Projection &projection = std::get<motion::PointForm>(observed.form).projection;
    add_observed(observed, system_.balance().observed(projection, motion.coordinates),
                 projection.row * left.coordinates, row);
  }
}

void BalanceTable::add_contacts(const HarmonicMotion &motion, const FieldWriter &row) const {
  const std::vector<contact::ContactPair> &pairs = system_.system().contacts.pairs();
  for (std::size_t c = 0; c < pairs.size(); ++c) {
    const std::string path = "contact/" + pairs[c].name + "/";
    const motion::ValueRange gap = range_of(motion.elements.row(static_cast<Index>(c)));
    row.number(path + "gap/minimum", pairs[c].clearance + gap.minimum, "m",
               "smallest value in the recorded window, gap, > 0 open");
    row.number(path + "gap/maximum", pairs[c].clearance + gap.maximum, "m",
               "largest value in the recorded window, gap, > 0 open");
    row.number(path + "normal_force/maximum", motion.forces[c].largest, "N",
               "largest normal force in the recorded window");
  }
}

void BalanceTable::add(const continuation::SpecialPoint &special) {
  rows_.add_special(special.at, kind_number(special.kind), values_of(special.at));
}

} // namespace vibroimpact::analyses
