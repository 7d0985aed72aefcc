#include "analyses/identify_results.h"

#include "analyses/fields.h"
#include "parameters/dimension.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact {

namespace {

const std::string base = "identification/";
const std::string summary_base = "identification.";

void add_scalar(PointResult &result, const std::string &name, double value, const std::string &unit,
                const std::string &description) {
  result.fields.push_back(scalar_field(base + name, value, unit, description));
  std::string line = summary_base + name;
  std::replace(line.begin(), line.end(), '/', '.');
  result.summary.push_back({.name = line, .value = value, .unit = unit});
}

std::string stiffness_unit(double n) {
  return parameters::si_unit({.length = 1 - n, .mass = 1, .time = -2});
}
std::string damping_factor_unit(double n) {
  return parameters::si_unit({.length = -n, .mass = 1, .time = -1});
}

// The field "identification/NAME_axis" is the coordinate of this dimension.
std::string axis_dimension(const std::string &name) { return "identification_" + name + "_axis"; }

void add_axis(PointResult &result, const std::string &name, const std::vector<double> &values,
              const std::string &unit, const std::string &description) {
  result.fields.push_back(
      series_field(base + name + "_axis", axis_dimension(name), values, unit, description));
}

template <class Items, class Pick> std::vector<double> picked(const Items &items, Pick pick) {
  std::vector<double> values;
  std::transform(items.begin(), items.end(), std::back_inserter(values), pick);
  return values;
}

// Adds per-impact columns of the same length, and the first of each to the summary.
class ImpactTable {
public:
  ImpactTable(PointResult &result, const IdentificationInput &input)
      : result_(result), input_(input) {}

  void add(const std::string &name, const std::vector<double> &values, const std::string &unit,
           const std::string &description) {
    result_.fields.push_back(
        series_field(base + name, "impact_" + input_.contact, values, unit, description));
    std::string column = name;
    std::replace(column.begin(), column.end(), '/', '.');
    for (std::size_t i = 0; i < std::min(input_.listed_impacts, values.size()); ++i)
      result_.summary.push_back(
          {.name = summary_base + "impact[" + std::to_string(i + 1) + "]." + column,
           .value = values[i],
           .unit = unit});
  }

private:
  PointResult &result_;
  const IdentificationInput &input_;
};

void add_constants(PointResult &result, const IdentificationInput &input) {
  const ContactConstants &contact = input.constants;
  add_scalar(result, "compliance", contact.compliance, "1/kg",
             "lambda, one over the mass that meets at the contact");
  add_scalar(result, "dimensionless_compliance", input.scales.dimensionless(contact.compliance),
             "1", "lambda in the units of the printed formulas");
  add_scalar(result, "stiffness", contact.stiffness, stiffness_unit(contact.exponent), "k");
  add_scalar(result, "exponent", contact.exponent, "1", "n");
  add_scalar(result, "speed_unit", input.scales.length / input.scales.time, "m/s",
             "unit of v_c in the fitted power laws");
  if (input.dissipation)
    add_scalar(result, "damping_factor", contact.stiffness * *input.dissipation,
               damping_factor_unit(contact.exponent), "mu of the contact law");
}

void add_fits(PointResult &result, const std::string &set, const IdentificationInput &input,
              const std::vector<Identified> &impacts) {
  const double speed_unit = input.scales.length / input.scales.time;
  const PowerFit fit = fit_power(impacts, speed_unit);
  add_scalar(result, set + "/constant_damping_factor", constant_damping_factor(impacts),
             damping_factor_unit(input.constants.exponent),
             "least-squares damping factor of all impacts");
  add_scalar(result, set + "/fit_coefficient", fit.coefficient, "1",
             "a of e = a v_c^b, v_c in units of length scale over time scale");
  add_scalar(result, set + "/fit_exponent", fit.exponent, "1", "b of e = a v_c^b");
  add_scalar(result, set + "/fitted_impacts", static_cast<double>(fit.impacts), "1",
             "impacts with e > 0, which the fit rests on");
}

void add_set(PointResult &result, const FormulaSet &set, const IdentificationInput &input) {
  std::vector<Identified> impacts;
  std::vector<Interval> intervals;
  for (const PulseFigures &pulse : input.pulses) {
    impacts.push_back(identify(set, pulse, input.constants, input.scales));
    intervals.push_back(
        restitution_interval(set, pulse, input.constants, input.scales, input.uncertainties));
  }
  const std::string name = std::string(set.name) + "/";
  ImpactTable table(result, input);
  table.add(name + "restitution_coefficient",
            picked(impacts, [](const Identified &i) { return i.restitution; }), "1",
            "e; NaN without a solution");
  table.add(name + "restitution_low", picked(intervals, [](const Interval &i) { return i.low; }),
            "1", "lowest e within the uncertainties");
  table.add(name + "restitution_high", picked(intervals, [](const Interval &i) { return i.high; }),
            "1", "highest e within the uncertainties");
  table.add(name + "approach_speed",
            picked(impacts, [](const Identified &i) { return i.approach_speed; }), "m/s", "v_c");
  table.add(name + "damping_factor",
            picked(impacts, [](const Identified &i) { return i.damping_factor; }),
            damping_factor_unit(input.constants.exponent), "mu");
  add_scalar(result, name + "ill_posed_impacts",
             static_cast<double>(std::count_if(intervals.begin(), intervals.end(),
                                               [](const Interval &i) { return i.high >= 1; })),
             "1", "impacts whose interval reaches e = 1: only its lower end says something");
  add_fits(result, set.name, input, impacts);
}

std::vector<double> equally_spaced(double first, double last, std::size_t points) {
  std::vector<double> values;
  for (std::size_t i = 0; i < points; ++i)
    values.push_back(first +
                     (last - first) * static_cast<double>(i) / static_cast<double>(points - 1));
  return values;
}

// e over impulse (rows) and peak force (columns).
Field restitution_map(const FormulaSet &set, const IdentificationInput &input,
                      const std::vector<double> &impulses, const std::vector<double> &forces) {
  Field field{.name = base + set.name + "/restitution_map",
              .unit = "1",
              .description = "e; NaN without a solution",
              .dimensions = {axis_dimension("impulse"), axis_dimension("peak_force")},
              .shape = {impulses.size(), forces.size()},
              .values = {}};
  for (const double impulse : impulses)
    for (const double force : forces)
      field.values.push_back(
          identify(set, {.impulse = impulse, .peak_force = force}, input.constants, input.scales)
              .restitution);
  return field;
}

} // namespace

void add_identification(PointResult &result, const IdentificationInput &input) {
  add_constants(result, input);
  ImpactTable table(result, input);
  table.add("impulse", picked(input.pulses, [](const PulseFigures &p) { return p.impulse; }), "N s",
            "impulse J as measured");
  table.add("peak_force", picked(input.pulses, [](const PulseFigures &p) { return p.peak_force; }),
            "N", "largest force f_m as measured");
  table.add("pulse_ratio",
            picked(input.pulses,
                   [&input](const PulseFigures &p) { return pulse_ratio(p, input.constants); }),
            "1", "gamma = 8 k (f_m/k)^((n+1)/n) / ((n+1) J^2 lambda)");
  for (const FormulaSet &set : formula_sets())
    add_set(result, set, input);
}

void add_restitution_maps(PointResult &result, const IdentificationInput &input,
                          std::size_t points) {
  constexpr double reach = 1.2;
  constexpr double largest_ratio = 4; // e = 0.17 by the exact set, n = 3/2
  PulseFigures largest;
  for (const PulseFigures &pulse : input.pulses) {
    largest.impulse = std::max(largest.impulse, pulse.impulse);
    largest.peak_force = std::max(largest.peak_force, pulse.peak_force);
  }
  const std::vector<double> impulses = equally_spaced(0, reach * largest.impulse, points);
  const std::vector<double> forces = equally_spaced(0, reach * largest.peak_force, points);
  const std::vector<double> ratios = equally_spaced(1, largest_ratio, points);
  add_axis(result, "impulse", impulses, "N s", "impulse of the maps");
  add_axis(result, "peak_force", forces, "N", "peak force of the maps");
  add_axis(result, "pulse_ratio", ratios, "1", "gamma of the curves");
  const double compliance = input.scales.dimensionless(input.constants.compliance);
  for (const FormulaSet &set : formula_sets()) {
    result.fields.push_back(restitution_map(set, input, impulses, forces));
    result.fields.push_back(
        series_field(base + set.name + "/restitution_curve", axis_dimension("pulse_ratio"),
                     picked(ratios,
                            [&](double ratio) {
                              return set.restitution(ratio, compliance, input.constants.exponent);
                            }),
                     "1", "e over gamma; NaN without a solution"));
  }
}

void add_force_record(PointResult &result, const ForceRecord &record) {
  result.fields.push_back(series_field(base + "record/time", "identification_record_time",
                                       record.time(), "s", "instants of the samples"));
  result.fields.push_back(series_field(base + "record/force", "identification_record_time",
                                       record.force(), "N", "sampled normal force"));
}

} // namespace vibroimpact
