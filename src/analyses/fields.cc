#include "analyses/fields.h"

#include <algorithm>
#include <array>

namespace vibroimpact::analyses {

using motion::Impact;
using motion::ImpactLog;

namespace {

struct PatternColumn {
  const char *name;
  const char *unit;
  const char *description;
  double (*value)(const Impact &impact);
};

struct AccuracyLabels {
  Label energy_residual{"energy_residual", "1",
                        "unaccounted energy over initial energy plus absolute input"};
  Label unbalanced{"unbalanced", "1",
                   "1 when the energy balance does not close: energy_residual above 1e-10 where "
                   "all steps were exact, above 1000 relative tolerances elsewhere"};
  Label event_residual{"event_residual", "s",
                       "largest uncertainty of the instant of a contact change"};
  Label relative_tolerance{"relative_tolerance", "1", "of one time step"};
  Label steps{"steps", "1", "accepted time steps"};
  Label rejected_steps{"rejected_steps", "1", "rejected time steps"};
  Label events{"events", "1", "contact changes"};
  Label undecided_events{"undecided_events", "1",
                         "touches within the rounding of the gap, taken for none"};
  Label chatters{"chatters", "1",
                 "infinite sequences of rigid impacts that were completed at once"};
  Label whole_contacts{"whole_contacts", "1",
                       "contacts with a nonlinear law that were solved as a whole"};
  Label stepped_contacts{"stepped_contacts", "1",
                         "contacts with a nonlinear law that were integrated in steps"};
  std::array<Label, motion::n_step_reasons> reasons{
      stepped("method", "the method of integration has steps only"),
      stepped("system", "the phase before was not linear"),
      stepped("undecided", "a step had to find out what happens in the linear phase before"),
      stepped("law", "the law does not say how its force begins and ends, or a gap was held"),
      stepped("interrupted", "a window, a break of a source or Maximum step ended within it"),
      stepped("fast", "a mode turned too far within it"),
      stepped("shape", "the force was no single hump, or too coarse with the most nodes"),
      stepped("neighbour", "another contact might have changed within it"),
      stepped("shallow", "its two instants, or its release, could not be told apart"),
      stepped("pause", "one shortly before was left for its shape or a fast mode")};

private:
  static Label stepped(const std::string &reason, const std::string &why) {
    return {"stepped_contacts_" + reason, "1", "of the stepped contacts: " + why};
  }
};

const AccuracyLabels &accuracy_labels() {
  static const AccuracyLabels labels;
  return labels;
}

struct SettledLabels {
  Label steady{"steady", "1", "1 when the motion was judged steady before recording"};
  Label multiple{"period_multiple", "1", "forcing periods after which it repeats, 0 unknown"};
  Label cycles{"settling_cycles", "1", "forcing periods before recording"};
};

const SettledLabels &settled_labels() {
  static const SettledLabels labels;
  return labels;
}

// Of a scalar; `otherwise` when the point does not have it.
double scalar_of(const PointResult &result, const Label &label, double otherwise) {
  const auto first = [&result](auto is_wanted) {
    const auto found = std::find_if(result.fields.begin(), result.fields.end(), is_wanted);
    return found == result.fields.end() ? nullptr : &*found;
  };
  const Field *found = first([&](const Field &field) { return field.label == label; });
  if (found == nullptr) // an earlier version of the program may have described it otherwise
    found = first([&](const Field &field) { return field.name() == label.name(); });
  return found == nullptr || found->values.empty() ? otherwise : found->values[0];
}

constexpr PatternColumn columns[] = {
    {"time", "s", "instant at which the sides meet", [](const Impact &i) { return i.start_time; }},
    {"duration", "s", "time in contact", [](const Impact &i) { return i.duration; }},
    {"approach_speed", "m/s", "closing speed just before contact",
     [](const Impact &i) { return i.approach_speed; }},
    {"separation_speed", "m/s", "opening speed just after contact",
     [](const Impact &i) { return i.separation_speed; }},
    {"restitution_coefficient", "1", "separation speed over approach speed",
     [](const Impact &i) { return i.restitution_coefficient(); }},
    {"peak_force", "N", "largest normal force", [](const Impact &i) { return i.peak_force; }},
    {"peak_time", "s", "instant of the largest normal force",
     [](const Impact &i) { return i.peak_time; }},
    {"impulse", "N s", "time integral of the normal force",
     [](const Impact &i) { return i.impulse; }},
    {"maximum_penetration", "m", "largest overlap",
     [](const Impact &i) { return i.maximum_penetration; }},
    {"dissipated_energy", "J", "energy lost in the contact law",
     [](const Impact &i) { return i.dissipated_energy; }},
    {"chatter_duration", "s", "time in which further impacts, left out, come to rest",
     [](const Impact &i) { return i.chatter_duration; }},
    {"finished", "1",
     "1 when the sides parted before the end; 0: the values are those up to the end",
     [](const Impact &i) { return i.finished ? 1.0 : 0.0; }},
};

} // namespace

Field scalar_field(const Label &label, double value) {
  return {.label = label, .shape = {}, .values = {value}};
}

Field scalar_field(const std::string &name, double value, const std::string &unit,
                   const std::string &description) {
  return scalar_field(Label(name, unit, description), value);
}

Field series_field(const std::string &name, const std::string &dimension,
                   std::vector<double> values, const std::string &unit,
                   const std::string &description) {
  const std::size_t length = values.size();
  return {.label = Label(name, unit, description, {dimension}),
          .shape = {length},
          .values = std::move(values)};
}

SummaryLine scalar_line(const std::string &name, double value, const std::string &unit) {
  return {.label = Label(name, unit, ""), .value = value};
}

void add_settled(PointResult &result, bool steady, long multiple, long cycles) {
  const SettledLabels &labels = settled_labels();
  result.fields.push_back(scalar_field(labels.steady, steady ? 1 : 0));
  result.fields.push_back(scalar_field(labels.multiple, static_cast<double>(multiple)));
  result.fields.push_back(scalar_field(labels.cycles, static_cast<double>(cycles)));
}

void add_accuracy(PointResult &result, const motion::Accuracy &accuracy,
                  const motion::Settings &settings) {
  const auto add = [&result](const Label &label, double value) {
    result.fields.push_back(scalar_field(label, value));
    result.summary.push_back({.label = label, .value = value});
  };
  const AccuracyLabels &labels = accuracy_labels();
  add(labels.energy_residual, accuracy.energy_residual);
  add(labels.unbalanced, accuracy.balanced() ? 0 : 1);
  add(labels.event_residual, accuracy.event_residual);
  add(labels.relative_tolerance, settings.relative_tolerance);
  add(labels.steps, static_cast<double>(accuracy.steps));
  add(labels.rejected_steps, static_cast<double>(accuracy.rejected_steps));
  add(labels.events, static_cast<double>(accuracy.events));
  add(labels.undecided_events, static_cast<double>(accuracy.undecided_events));
  add(labels.chatters, static_cast<double>(accuracy.chatters));
  add(labels.whole_contacts, static_cast<double>(accuracy.whole_contacts));
  add(labels.stepped_contacts, static_cast<double>(accuracy.stepped_contacts()));
  for (std::size_t i = 0; i < motion::n_step_reasons; ++i) {
    const auto count = static_cast<double>(accuracy.step_reasons[i]);
    result.fields.push_back(scalar_field(labels.reasons[i], count));
    if (count > 0)
      result.summary.push_back({.label = labels.reasons[i], .value = count});
  }
}

bool unbalanced(const PointResult &result) {
  return scalar_of(result, accuracy_labels().unbalanced, 0) > 0;
}

bool recorded_unsettled(const PointResult &result) {
  return scalar_of(result, settled_labels().steady, 1) == 0;
}

double undecided_events(const PointResult &result) {
  return scalar_of(result, accuracy_labels().undecided_events, 0);
}

namespace {

// Of all contacts of a group, in the summary and as scalars.
void add_group(PointResult &result, const contact::ContactGroup &group, const ImpactLog &log) {
  double impacts = 0;
  double touched = 0;
  double peak = 0;
  double impulse = 0;
  double dissipated = 0;
  for (std::size_t c = group.first; c < group.first + group.count; ++c) {
    impacts += static_cast<double>(log.impacts(c).size());
    touched += log.begun(c) > 0 ? 1 : 0;
    for (const Impact &impact : log.impacts(c)) {
      peak = std::max(peak, impact.peak_force);
      impulse += impact.impulse;
      dissipated += impact.dissipated_energy;
    }
  }
  const auto add = [&](const std::string &name, double value, const std::string &unit,
                       const std::string &description) {
    result.fields.push_back(
        scalar_field("group/" + group.name + "/" + name, value, unit, description));
    result.summary.push_back(scalar_line("group." + group.name + "." + name, value, unit));
  };
  add("contacts", static_cast<double>(group.count), "1", "contacts of the group");
  add("touched", touched, "1", "contacts with an impact");
  add("impacts", impacts, "1", "impacts of all its contacts");
  add("peak_force", peak, "N", "largest normal force of a single contact");
  add("impulse", impulse, "N s", "sum over all impacts");
  add("dissipated_energy", dissipated, "J", "lost in the contact laws, sum over all impacts");
}

} // namespace

void add_impacts(PointResult &result, const contact::ContactSet &contacts, const ImpactLog &log,
                 std::size_t summary_lines) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const std::string &name = contacts.pairs()[c].name;
    const std::vector<Impact> &impacts = log.impacts(c);
    for (const PatternColumn &column : columns) {
      std::vector<double> values;
      std::transform(impacts.begin(), impacts.end(), std::back_inserter(values), column.value);
      result.fields.push_back(series_field("contact/" + name + "/impact/" + column.name,
                                           "impact_" + name, std::move(values), column.unit,
                                           column.description));
    }
    result.summary.push_back(
        scalar_line("contact." + name + ".impacts", static_cast<double>(impacts.size()), "1"));
    for (std::size_t i = 0; i < std::min(summary_lines, impacts.size()); ++i)
      for (const PatternColumn &column : columns)
        result.summary.push_back(
            scalar_line("contact." + name + ".impact[" + std::to_string(i + 1) + "]." + column.name,
                        column.value(impacts[i]), column.unit));
  }
  for (const contact::ContactGroup &group : contacts.groups())
    add_group(result, group, log);
}

void add_pulses(PointResult &result, const contact::ContactSet &contacts, const ImpactLog &log) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const std::string base = "contact/" + contacts.pairs()[c].name + "/pulse/";
    const std::string dimension = "pulse_" + contacts.pairs()[c].name;
    const motion::Pulses &pulses = log.pulses(c);
    result.fields.push_back(
        series_field(base + "time", dimension, pulses.time, "s", "time; NaN separates impacts"));
    result.fields.push_back(
        series_field(base + "normal_force", dimension, pulses.force, "N", "normal force"));
    result.fields.push_back(series_field(base + "gap", dimension, pulses.gap, "m", "gap"));
  }
}

} // namespace vibroimpact::analyses
