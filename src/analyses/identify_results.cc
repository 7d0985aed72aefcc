#include "analyses/identify_results.h"

#include "analyses/fields.h"
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

std::string with_replaced(std::string text, char from, char to) {
  std::replace(text.begin(), text.end(), from, to);
  return text;
}

// Puts the results of one contact below contact/NAME/identification/.
class Sheet {
public:
  Sheet(PointResult &result, const std::string &contact)
      : result_(result), base_("contact/" + contact + "/identification/"),
        impacts_("impact_" + contact) {}

  void scalar(const std::string &name, double value, const std::string &unit,
              const std::string &description) {
    result_.fields.push_back(scalar_field(base_ + name, value, unit, description));
    result_.summary.push_back(scalar_line(with_replaced(base_ + name, '/', '.'), value, unit));
  }

  // One value per impact, the first `listed` of them in the summary.
  void impacts(const std::string &name, const std::vector<double> &values, const std::string &unit,
               const std::string &description, std::size_t listed) {
    result_.fields.push_back(series_field(base_ + name, impacts_, values, unit, description));
    const std::string base = with_replaced(base_, '/', '.') + "impact[";
    for (std::size_t i = 0; i < std::min(listed, values.size()); ++i)
      result_.summary.push_back(scalar_line(
          base + std::to_string(i + 1) + "]." + with_replaced(name, '/', '.'), values[i], unit));
  }

  // The dimension whose coordinate is the field `name`.
  std::string dimension(const std::string &name) const {
    return with_replaced(base_ + name, '/', '_');
  }

  void series(const std::string &name, const std::string &along, const std::vector<double> &values,
              const std::string &unit, const std::string &description) {
    result_.fields.push_back(
        series_field(base_ + name, dimension(along), values, unit, description));
  }

  void map(const std::string &name, const std::string &rows, const std::string &columns,
           const std::vector<std::size_t> &shape, std::vector<double> values,
           const std::string &description) {
    result_.fields.push_back(
        {.label = Label(base_ + name, "1", description, {dimension(rows), dimension(columns)}),
         .shape = shape,
         .values = std::move(values)});
  }

private:
  PointResult &result_;
  std::string base_;
  std::string impacts_;
};

template <class Items, class Pick> std::vector<double> picked(const Items &items, Pick pick) {
  std::vector<double> values;
  std::transform(items.begin(), items.end(), std::back_inserter(values), pick);
  return values;
}

void add_constants(Sheet &sheet, const IdentificationInput &input) {
  const ContactConstants &contact = input.constants;
  sheet.scalar("compliance", contact.compliance, "1/kg",
               "lambda, one over the mass that meets at the contact");
  sheet.scalar("dimensionless_compliance", input.scales.dimensionless(contact.compliance), "1",
               "lambda in the units of the printed formulas");
  sheet.scalar("stiffness", contact.stiffness, stiffness_unit(contact.exponent), "k");
  sheet.scalar("exponent", contact.exponent, "1", "n");
  sheet.scalar("speed_unit", input.scales.length / input.scales.time, "m/s",
               "unit of v_c in the fitted power laws");
  if (input.dissipation)
    sheet.scalar("damping_factor", contact.stiffness * *input.dissipation,
                 damping_factor_unit(contact.exponent), "mu of the contact law");
}

void add_fits(Sheet &sheet, const std::string &set, const IdentificationInput &input,
              std::vector<Identified> impacts) {
  std::erase_if(impacts, [&](const Identified &impact) {
    return !(impact.approach_speed >= input.slowest_fitted);
  });
  const PowerFit fit = fit_power(impacts, input.scales.length / input.scales.time);
  sheet.scalar(set + "/constant_damping_factor", constant_damping_factor(impacts),
               damping_factor_unit(input.constants.exponent),
               "least-squares damping factor of all impacts");
  sheet.scalar(set + "/fit_coefficient", fit.coefficient, "1", "a of e = a (v_c / speed_unit)^b");
  sheet.scalar(set + "/fit_exponent", fit.exponent, "1", "b of e = a (v_c / speed_unit)^b");
  const auto bounds = [&](const std::string &name, const Interval &interval,
                          const std::string &symbol) {
    sheet.scalar(set + "/" + name + "_low", interval.low, "1",
                 "lower end of the interval of 95 % of " + symbol +
                     ", from the scatter of the impacts; NaN with less than three");
    sheet.scalar(set + "/" + name + "_high", interval.high, "1",
                 "upper end of the interval of 95 % of " + symbol);
  };
  bounds("fit_coefficient", fit.coefficient_interval, "a");
  bounds("fit_exponent", fit.exponent_interval, "b");
  sheet.scalar(set + "/fitted_impacts", static_cast<double>(fit.impacts), "1",
               "impacts with e > 0 that are not too slow, which the fit rests on");
}

void add_set(Sheet &sheet, const FormulaSet &set, const IdentificationInput &input) {
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
    sheet.impacts(name + field, values, unit, description, input.listed_impacts);
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
  sheet.scalar(name + "ill_posed_impacts",
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

void add_identification(PointResult &result, const IdentificationInput &input) {
  Sheet sheet(result, input.contact);
  add_constants(sheet, input);
  sheet.impacts("impulse", picked(input.pulses, [](const PulseFigures &p) { return p.impulse; }),
                "N s", "impulse J as measured", input.listed_impacts);
  sheet.impacts("peak_force",
                picked(input.pulses, [](const PulseFigures &p) { return p.peak_force; }), "N",
                "largest force f_m as measured", input.listed_impacts);
  sheet.impacts("pulse_ratio",
                picked(input.pulses,
                       [&input](const PulseFigures &p) { return pulse_ratio(p, input.constants); }),
                "1", "gamma = 8 k (f_m/k)^((n+1)/n) / ((n+1) J^2 lambda)", input.listed_impacts);
  for (const FormulaSet &set : formula_sets())
    add_set(sheet, set, input);
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
  Sheet sheet(result, input.contact);
  sheet.series("impulse_axis", "impulse_axis", impulses, "N s", "impulse of the maps");
  sheet.series("peak_force_axis", "peak_force_axis", forces, "N", "peak force of the maps");
  sheet.series("pulse_ratio_axis", "pulse_ratio_axis", ratios, "1", "gamma of the curves");
  const double compliance = input.scales.dimensionless(input.constants.compliance);
  for (const FormulaSet &set : formula_sets()) {
    const std::string name = std::string(set.name) + "/";
    sheet.map(name + "restitution_map", "impulse_axis", "peak_force_axis", {points, points},
              restitution_map(set, input, impulses, forces), "e; NaN without a solution");
    sheet.series(name + "restitution_curve", "pulse_ratio_axis",
                 picked(ratios,
                        [&](double ratio) {
                          return set.restitution(ratio, compliance, input.constants.exponent);
                        }),
                 "1", "e over gamma; NaN without a solution");
  }
}

void add_force_record(PointResult &result, const std::string &contact,
                      const std::vector<double> &time, const std::vector<double> &force) {
  Sheet sheet(result, contact);
  sheet.series("record/time", "record/time", time, "s", "instants of the samples");
  sheet.series("record/force", "record/time", force, "N", "sampled normal force");
}

void add_measured_pulses(PointResult &result, const std::string &contact,
                         const std::vector<MeasuredPulse> &pulses) {
  Sheet sheet(result, contact);
  const auto add = [&](const std::string &name, auto pick, const std::string &unit,
                       const std::string &description) {
    sheet.impacts("pulse/" + name, picked(pulses, pick), unit, description, 0);
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
