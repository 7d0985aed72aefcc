#include "analyses/identification/identify_results.h"

#include "analyses/results/fields.h"
#include "parameters/dimension.h"

#include <algorithm>

namespace vibroimpact::analyses {

namespace {

std::string stiffness_unit(double n) {
  return parameters::si_unit({.length = 1 - n, .mass = 1, .time = -2});
}
std::string damping_factor_unit(double n) {
  return parameters::si_unit({.length = -n, .mass = 1, .time = -1});
}

// The results of one contact.
FieldWriter sheet_of(const FieldWriter &result, const std::string &contact) {
  return result.below("contact/" + contact + "/identification/").listed();
}

// One value per impact, the first `listed` of them in the summary.
void add_per_impact(const FieldWriter &sheet, const IdentificationInput &input,
                    const std::string &name, const std::vector<double> &values,
                    const std::string &unit, const std::string &description) {
  sheet.series(name, "impact_" + input.contact, values, unit, description);
  for (std::size_t i = 0; i < std::min(input.listed_impacts, values.size()); ++i)
    sheet.line("impact[" + std::to_string(i + 1) + "]." + name, values[i], unit);
}

// The dimension whose coordinate is the field `name`.
std::string dimension(const FieldWriter &sheet, std::string name) {
  name = sheet.path() + name;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

template <class Items, class Pick> std::vector<double> picked(const Items &items, Pick pick) {
  std::vector<double> values;
  std::transform(items.begin(), items.end(), std::back_inserter(values), pick);
  return values;
}

void add_constants(const FieldWriter &sheet, const IdentificationInput &input) {
  const ContactConstants &contact = input.constants;
  sheet.number("compliance", contact.compliance, "1/kg",
               "lambda, one over the mass that meets at the contact");
  sheet.number("dimensionless_compliance", input.scales.dimensionless(contact.compliance), "1",
               "lambda in the units of the printed formulas");
  sheet.number("stiffness", contact.stiffness, stiffness_unit(contact.exponent), "k");
  sheet.number("exponent", contact.exponent, "1", "n");
  sheet.number("speed_unit", input.scales.length / input.scales.time, "m/s",
               "unit of v_c in the fitted power laws");
  if (input.dissipation)
    sheet.number("damping_factor", contact.stiffness * *input.dissipation,
                 damping_factor_unit(contact.exponent), "mu of the contact law");
}

void add_fits(const FieldWriter &sheet, const std::string &set, const IdentificationInput &input,
              std::vector<Identified> impacts) {
  std::erase_if(impacts, [&](const Identified &impact) {
    return !(impact.approach_speed >= input.slowest_fitted);
  });
  const PowerFit fit = fit_power(impacts, input.scales.length / input.scales.time);
  sheet.number(set + "/constant_damping_factor", constant_damping_factor(impacts),
               damping_factor_unit(input.constants.exponent),
               "least-squares damping factor of all impacts");
  sheet.number(set + "/fit_coefficient", fit.coefficient, "1", "a of e = a (v_c / speed_unit)^b");
  sheet.number(set + "/fit_exponent", fit.exponent, "1", "b of e = a (v_c / speed_unit)^b");
  const auto bounds = [&](const std::string &name, const Interval &interval,
                          const std::string &symbol) {
    sheet.number(set + "/" + name + "_low", interval.low, "1",
                 "lower end of the interval of 95 % of " + symbol +
                     ", from the scatter of the impacts; NaN with less than three");
    sheet.number(set + "/" + name + "_high", interval.high, "1",
                 "upper end of the interval of 95 % of " + symbol);
  };
  bounds("fit_coefficient", fit.coefficient_interval, "a");
  bounds("fit_exponent", fit.exponent_interval, "b");
  sheet.number(set + "/fitted_impacts", static_cast<double>(fit.impacts), "1",
               "impacts with e > 0 that are not too slow, which the fit rests on");
}

void add_set(const FieldWriter &sheet, const FormulaSet &set, const IdentificationInput &input) {
  std::vector<Identified> impacts;
  std::vector<Interval> intervals;
  for (const PulseFigures &pulse : input.pulses) {
    impacts.push_back(identify(set, pulse, input.constants, input.scales));
    intervals.push_back(
        restitution_interval(set, pulse, input.constants, input.scales, input.uncertainties));
  }
  const std::string name = std::string(set.name) + "/";
  const auto column = [&](const char *field, const std::vector<double> &values,
                          const std::string &unit, const char *description) {
    add_per_impact(sheet, input, name + field, values, unit, description);
  };
  column("restitution_coefficient",
         picked(impacts, [](const Identified &i) { return i.restitution; }), "1",
         "e; NaN without a solution");
  column("restitution_low", picked(intervals, [](const Interval &i) { return i.low; }), "1",
         "lowest e within the uncertainties; NaN when none of them has a solution");
  column("restitution_high", picked(intervals, [](const Interval &i) { return i.high; }), "1",
         "highest e within the uncertainties; NaN when none of them has a solution");
  column("approach_speed", picked(impacts, [](const Identified &i) { return i.approach_speed; }),
         "m/s", "v_c");
  column("damping_factor", picked(impacts, [](const Identified &i) { return i.damping_factor; }),
         damping_factor_unit(input.constants.exponent), "mu");
  sheet.number(name + "ill_posed_impacts",
               static_cast<double>(std::count_if(intervals.begin(), intervals.end(),
                                                 [](const Interval &i) { return i.high >= 1; })),
               "1", "impacts whose interval reaches e = 1: only its lower end says something");
  add_fits(sheet, set.name, input, impacts);
}

std::vector<double> equally_spaced(double first, double last, std::size_t points) {
  std::vector<double> values;
  for (std::size_t i = 0; i < points; ++i)
    values.push_back(first +
                     (last - first) * static_cast<double>(i) / static_cast<double>(points - 1));
  return values;
}

// e over impulse (rows) and peak force (columns).
std::vector<double> restitution_map(const FormulaSet &set, const IdentificationInput &input,
                                    const std::vector<double> &impulses,
                                    const std::vector<double> &forces) {
  std::vector<double> values;
  for (const double impulse : impulses)
    for (const double force : forces)
      values.push_back(
          identify(set, {.impulse = impulse, .peak_force = force}, input.constants, input.scales)
              .restitution);
  return values;
}

} // namespace

void add_identification(const FieldWriter &result, const IdentificationInput &input) {
  const FieldWriter sheet = sheet_of(result, input.contact);
  add_constants(sheet, input);
  add_per_impact(sheet, input, "impulse",
                 picked(input.pulses, [](const PulseFigures &p) { return p.impulse; }), "N s",
                 "impulse J as measured");
  add_per_impact(sheet, input, "peak_force",
                 picked(input.pulses, [](const PulseFigures &p) { return p.peak_force; }), "N",
                 "largest force f_m as measured");
  add_per_impact(
      sheet, input, "pulse_ratio",
      picked(input.pulses,
             [&input](const PulseFigures &p) { return pulse_ratio(p, input.constants); }),
      "1", "gamma = 8 k (f_m/k)^((n+1)/n) / ((n+1) J^2 lambda)");
  for (const FormulaSet &set : formula_sets())
    add_set(sheet, set, input);
}

void add_restitution_maps(const FieldWriter &result, const IdentificationInput &input,
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
  const FieldWriter sheet = sheet_of(result, input.contact);
  sheet.series("impulse_axis", dimension(sheet, "impulse_axis"), impulses, "N s",
               "impulse of the maps");
  sheet.series("peak_force_axis", dimension(sheet, "peak_force_axis"), forces, "N",
               "peak force of the maps");
  sheet.series("pulse_ratio_axis", dimension(sheet, "pulse_ratio_axis"), ratios, "1",
               "gamma of the curves");
  const double compliance = input.scales.dimensionless(input.constants.compliance);
  for (const FormulaSet &set : formula_sets()) {
    const std::string name = std::string(set.name) + "/";
    sheet.array({name + "restitution_map",
                 "1",
                 "e; NaN without a solution",
                 {dimension(sheet, "impulse_axis"), dimension(sheet, "peak_force_axis")}},
                {points, points}, restitution_map(set, input, impulses, forces));
    sheet.series(name + "restitution_curve", dimension(sheet, "pulse_ratio_axis"),
                 picked(ratios,
                        [&](double ratio) {
                          return set.restitution(ratio, compliance, input.constants.exponent);
                        }),
                 "1", "e over gamma; NaN without a solution");
  }
}

void add_force_record(const FieldWriter &result, const std::string &contact,
                      const std::vector<double> &time, const std::vector<double> &force) {
  const FieldWriter sheet = sheet_of(result, contact);
  sheet.series("record/time", dimension(sheet, "record/time"), time, "s",
               "instants of the samples");
  sheet.series("record/force", dimension(sheet, "record/time"), force, "N", "sampled normal force");
}

void add_measured_pulses(const FieldWriter &result, const std::string &contact,
                         const std::vector<MeasuredPulse> &pulses) {
  const FieldWriter sheet = sheet_of(result, contact);
  const auto add = [&](const std::string &name, auto pick, const std::string &unit,
                       const std::string &description) {
    sheet.series("pulse/" + name, "impact_" + contact, picked(pulses, pick), unit, description);
  };
  add(
      "start", [](const MeasuredPulse &pulse) { return pulse.start; }, "s",
      "first sample above the threshold");
  add(
      "duration", [](const MeasuredPulse &pulse) { return pulse.duration; }, "s",
      "from there to the last one");
  add(
      "samples", [](const MeasuredPulse &pulse) { return static_cast<double>(pulse.samples); }, "1",
      "above the threshold");
}

} // namespace vibroimpact::analyses
