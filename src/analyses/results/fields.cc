#include "analyses/results/fields.h"

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
  Label contact_episodes{"contact_episodes", "1",
                         "contacts with a nonlinear law that were solved as a whole"};
  Label moment_steps{"moment_steps", "1",
                     "steps over contact changes of any number, by the moments of the forces"};
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
      stepped("shallow", "its two instants, or its release, could not be distinguished"),
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

constexpr PatternColumn angle_column{"angle", "rad",
                                     "where the sides meet, from Direction on about Axis",
                                     [](const Impact &i) { return i.angle; }};

std::vector<PatternColumn> columns_of(const contact::ContactPair &pair) {
  std::vector<PatternColumn> list(std::begin(columns), std::end(columns));
  if (pair.circle)
    list.push_back(angle_column);
  return list;
}

} // namespace

void add_settled(const FieldWriter &result, bool steady, long multiple, long cycles) {
  const SettledLabels &labels = settled_labels();
  result.number(labels.steady, steady ? 1 : 0);
  result.number(labels.multiple, static_cast<double>(multiple));
  result.number(labels.cycles, static_cast<double>(cycles));
}

void add_accuracy(const FieldWriter &result, const motion::Accuracy &accuracy,
                  const motion::Settings &settings) {
  const FieldWriter listed = result.listed();
  const AccuracyLabels &labels = accuracy_labels();
  listed.number(labels.energy_residual, accuracy.energy_residual);
  listed.number(labels.unbalanced, accuracy.balanced() ? 0 : 1);
  listed.number(labels.event_residual, accuracy.event_residual);
  listed.number(labels.relative_tolerance, settings.relative_tolerance);
  listed.number(labels.steps, static_cast<double>(accuracy.steps));
  listed.number(labels.rejected_steps, static_cast<double>(accuracy.rejected_steps));
  listed.number(labels.events, static_cast<double>(accuracy.events));
  listed.number(labels.undecided_events, static_cast<double>(accuracy.undecided_events));
  listed.number(labels.chatters, static_cast<double>(accuracy.chatters));
  listed.number(labels.contact_episodes, static_cast<double>(accuracy.contact_episodes));
  listed.number(labels.stepped_contacts, static_cast<double>(accuracy.stepped_contacts()));
  const auto by_moments = static_cast<double>(accuracy.moment_steps);
  (by_moments > 0 ? listed : result).number(labels.moment_steps, by_moments);
  for (std::size_t i = 0; i < motion::n_step_reasons; ++i) {
    const auto count = static_cast<double>(accuracy.step_reasons[i]);
    (count > 0 ? listed : result).number(labels.reasons[i], count);
  }
}

bool unbalanced(const PointResult &result) {
  return number_of(result, accuracy_labels().unbalanced.name(), 0) > 0;
}

bool recorded_unsettled(const PointResult &result) {
  return number_of(result, settled_labels().steady.name(), 1) == 0;
}

double undecided_events(const PointResult &result) {
  return number_of(result, accuracy_labels().undecided_events.name(), 0);
}

namespace {

struct ImpactTotals {
  double impacts = 0, touched = 0, peak_force = 0, impulse = 0, dissipated_energy = 0;
};

ImpactTotals totals_of(const ImpactLog &log, std::size_t first, std::size_t count) {
  ImpactTotals totals;
  for (std::size_t c = first; c < first + count; ++c) {
    totals.impacts += static_cast<double>(log.impacts(c).size());
    totals.touched += log.begun(c) > 0 ? 1 : 0;
    for (const Impact &impact : log.impacts(c)) {
      totals.peak_force = std::max(totals.peak_force, impact.peak_force);
      totals.impulse += impact.impulse;
      totals.dissipated_energy += impact.dissipated_energy;
    }
  }
  return totals;
}

// Of all contacts of a group, in the summary and as scalars.
void add_group(const FieldWriter &result, const contact::ContactGroup &group,
               const ImpactLog &log) {
  const ImpactTotals totals = totals_of(log, group.first, group.count);
  const FieldWriter of = result.below("group/" + group.name + "/").listed();
  of.number("contacts", static_cast<double>(group.count), "1", "contacts of the group");
  of.number("touched", totals.touched, "1", "contacts with an impact");
  of.number("impacts", totals.impacts, "1", "impacts of all its contacts");
  of.number("peak_force", totals.peak_force, "N", "largest normal force of a single contact");
  of.number("impulse", totals.impulse, "N s", "sum over all impacts");
  of.number("dissipated_energy", totals.dissipated_energy, "J",
            "lost in the contact laws, sum over all impacts");
}

// Of one contact, in the summary alone.
void list_totals(const FieldWriter &of, const ImpactTotals &totals) {
  of.line("impacts", totals.impacts, "1");
  if (totals.impacts == 0)
    return;
  of.line("peak_force", totals.peak_force, "N");
  of.line("impulse", totals.impulse, "N s");
  of.line("dissipated_energy", totals.dissipated_energy, "J");
}

} // namespace

void add_impacts(const FieldWriter &result, const contact::ContactSet &contacts,
                 const ImpactLog &log, std::size_t summary_lines) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const std::string &name = contacts.pairs()[c].name;
    const FieldWriter of = result.below("contact/" + name + "/");
    const std::vector<Impact> &impacts = log.impacts(c);
    const std::vector<PatternColumn> listed = columns_of(contacts.pairs()[c]);
    for (const PatternColumn &column : listed) {
      std::vector<double> values;
      std::transform(impacts.begin(), impacts.end(), std::back_inserter(values), column.value);
      of.series(std::string("impact/") + column.name, "impact_" + name, std::move(values),
                column.unit, column.description);
    }
    list_totals(of, totals_of(log, c, 1));
    for (std::size_t i = 0; i < std::min(summary_lines, impacts.size()); ++i)
      for (const PatternColumn &column : listed)
        of.line("impact[" + std::to_string(i + 1) + "]." + column.name, column.value(impacts[i]),
                column.unit);
  }
  for (const contact::ContactGroup &group : contacts.groups())
    add_group(result, group, log);
}

void add_pulses(const FieldWriter &result, const contact::ContactSet &contacts,
                const ImpactLog &log) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const std::string &name = contacts.pairs()[c].name;
    const FieldWriter of = result.below("contact/" + name + "/pulse/");
    const motion::Pulses &pulses = log.pulses(c);
    of.series("time", "pulse_" + name, pulses.time, "s", "time; NaN separates impacts");
    of.series("normal_force", "pulse_" + name, pulses.force, "N", "normal force");
    of.series("gap", "pulse_" + name, pulses.gap, "m", "gap");
  }
}

} // namespace vibroimpact::analyses
