#include "analyses/balance_table.h"

#include "analyses/channels.h"
#include "analyses/fields.h"
#include "analyses/recorders/extreme_values.h"
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

Field array(const std::string &name, const Matrix &values, const std::string &unit,
            const std::string &text, std::vector<std::string> dimensions) {
  Field field{.label = Label(name, unit, text, std::move(dimensions))};
  if (field.dimensions().size() == 2)
    field.shape.push_back(static_cast<std::size_t>(values.rows()));
  field.shape.push_back(static_cast<std::size_t>(values.cols()));
  const Matrix transposed = values.transpose(); // last dimension fastest
  field.values.assign(transposed.data(), transposed.data() + transposed.size());
  return field;
}

Field amplitudes(const std::string &path, const RowVector &series) {
  return array(path + "/harmonic_amplitude", continuation::harmonic_amplitudes(series).transpose(),
               "m", "amplitude of each harmonic of the forcing, from the absolute mean on",
               {"harmonic"});
}

void add_channel(const std::string &path, const std::string &meaning, const RowVector &series,
                 const RowVector &left, PointResult &row) {
  const ExtremeValueLabels labels(
      {.path = path, .kind = "displacement", .unit = "m", .meaning = meaning, .curve = {}});
  add_range(row, labels, range_of(series));
  row.fields.push_back(amplitudes(path, series));
  row.fields.push_back(scalar_field(path + "/left_out", range_of(left).peak(), "m",
                                    "largest displacement that the force above the last harmonic "
                                    "would cause by itself"));
}

} // namespace

BalanceTable::BalanceTable(const SweptParameter &parameter, KeyedBalance &system,
                           continuation::HarmonicBalance &problem, StepRecord *steps)
    : system_(system), problem_(problem), kept_(steps), rows_(parameter) {}

PointResult BalanceTable::values_of(const continuation::BranchPoint &point) const {
  const double key = point.point.keys[0];
  const HarmonicMotion motion = problem_.motion(point.point.state, key);
  const LeftOut left = problem_.left_out(motion, key);
  PointResult row;
  row.fields = {
      scalar_field("balance_residual", point.residual, "1",
                   "what the equations of the harmonics leave over, over the size of the motion"),
      scalar_field("force_left_out", left.force, "1",
                   "root mean square of the forces of contacts and cubic springs above the last "
                   "harmonic, up to three times its number, over that of all"),
      array("coefficients", motion.coordinates, "SI",
            "of each coordinate: mean, cosine and sine of the first harmonic, of the second...",
            {"coordinate", "coefficient"})};
  add_points(motion, left, row);
  add_contacts(motion, row);
  return row;
}

void BalanceTable::add_points(const HarmonicMotion &motion, const LeftOut &left,
                              PointResult &row) const {
  const periodic::HarmonicModel &balance = system_.balance();
  for (const Channel &channel : observed_channels(system_.system().model)) {
    const std::string path = "point/" + channel.point + "/";
    const std::string axis = std::string("_") + channel.axis;
    const std::string along = std::string(" along ") + channel.axis;
    const RowVector beyond = channel.relative.row * left.coordinates;
    add_channel(path + "displacement" + axis, "displacement relative to the base" + along,
                balance.observed(channel.relative, motion.coordinates), beyond, row);
    if (channel.carried())
      add_channel(path + "absolute_displacement" + axis, "displacement in space" + along,
                  balance.observed(channel.absolute, motion.coordinates), beyond, row);
  }
}

void BalanceTable::add_contacts(const HarmonicMotion &motion, PointResult &row) const {
  const std::vector<contact::ContactPair> &pairs = system_.system().contacts.pairs();
  for (std::size_t c = 0; c < pairs.size(); ++c) {
    const std::string path = "contact/" + pairs[c].name + "/";
    const motion::ValueRange gap = range_of(motion.elements.row(static_cast<Index>(c)));
    row.fields.push_back(scalar_field(path + "gap/minimum", pairs[c].clearance + gap.minimum, "m",
                                      "smallest value in the recorded window, gap, > 0 open"));
    row.fields.push_back(scalar_field(path + "gap/maximum", pairs[c].clearance + gap.maximum, "m",
                                      "largest value in the recorded window, gap, > 0 open"));
    row.fields.push_back(scalar_field(path + "normal_force/maximum", motion.forces[c].largest, "N",
                                      "largest normal force in the recorded window"));
  }
}

void BalanceTable::add(const continuation::SpecialPoint &special) {
  const int kind =
      special.kind == continuation::Special::fold ? SpecialKind::fold : SpecialKind::branch_point;
  rows_.add_special(special.at, kind, row_of(special.at));
}

} // namespace vibroimpact::analyses
