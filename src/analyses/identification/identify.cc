#include "analyses/identification/identify.h"

#include "analyses/recorders/motion_progress.h"
#include "analyses/recorders/sampler.h"
#include "analyses/results/fields.h"
#include "common/error.h"

#include <numbers>
#include <optional>

namespace vibroimpact::analyses {

namespace {

constexpr const char *identify_section = "Identify";

void declare_uncertainties(parameters::Section &section) {
  using namespace parameters;
  const auto declare = [&section](const char *quantity, const char *value, const char *symbol) {
    section.quantity("Uncertainty of " + std::string(quantity), value, dimension::none,
                     Range{.lower = 0, .upper = 1, .upper_open = true}, symbol,
                     "Relative half-width of the interval that holds the " + std::string(quantity) +
                         "; the intervals of the restitution coefficient follow from it.");
  };
  declare("impulse", "0.01", "\\delta J");
  declare("peak force", "0.01", "\\delta f_m");
  declare("compliance", "0.02", "\\delta\\lambda");
  declare("stiffness", "0.02", "\\delta k");
}

void declare_scales(parameters::Section &section) {
  using namespace parameters;
  const std::string sentence = " in which the printed formulas are evaluated, which depend on the "
                               "units; the other sets do not.";
  section
      .quantity("Length scale", "1 m", dimension::length, range::positive, "L",
                "Unit of length" + sentence)
      .quantity("Time scale", "1 s", dimension::time, range::positive, "1/\\omega",
                "Unit of time" + sentence)
      .quantity("Force scale", "1 N", dimension::force, range::positive, "EI/L^2",
                "Unit of force" + sentence);
}

std::size_t count(const parameters::Values &values, const std::string &key) {
  return static_cast<std::size_t>(values.integer(key));
}

void refuse_keys_of_motions(const parameters::Values &values) {
  for (const char *key : {"Duration", "Sampling frequency", "Recorded pulses"})
    if (values.given(key))
      values.reject(key, "must not be set when File is set");
}

void refuse_keys_of_records(const parameters::Values &values) {
  for (const char *key :
       {"Time column", "Value column", "Separator", "Time unit", "Value unit", "Threshold"})
    if (values.given(key))
      values.reject(key, "must not be set when File is not set");
}

double read_sampling_frequency(const parameters::Values &values) {
  if (!values.has("Sampling frequency"))
    return 0;
  const double frequency = values.quantity("Sampling frequency") / (2 * std::numbers::pi);
  if (frequency * values.quantity("Duration") > 1e8)
    values.reject("Sampling frequency", "must give at most 1e8 samples in Duration");
  return frequency;
}

} // namespace

void Identify::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      identify_section,
      "Restitution, approach speed and damping factor of impacts from the history of "
      "the contact force, by three sets of formulas.");
  section
      .quantity("Duration", "", dimension::time, range::positive, "T",
                "Length of the motion; not given beside a File.")
      .required("File is not given")
      .text("Contact", "", "Contact whose force is recorded; empty when there is only one.")
      .quantity("Sampling frequency", "", dimension::frequency, range::positive, "f_s",
                "Of the force record, from which impulse and peak are taken; empty means a perfect "
                "record.")
      .integer("Map points", "41", Range{.lower = 2, .upper = 1000}, "",
               "Points per axis of the map of the restitution coefficient over impulse and peak "
               "force.")
      .integer("Recorded pulses", "10", Range{.lower = 0, .upper = 1e6}, "",
               "Impacts whose force is recorded at every time step.")
      .integer("Listed impacts", "5", Range{.lower = 0, .upper = 1e6}, "",
               "Impacts that the summary lists; the result file holds all.")
      .quantity("Slowest fitted impact", "0 m/s", dimension::velocity, range::non_negative, "",
                "Approach speed below which an impact takes no part in the fitted laws.");
  declare_measured_force(section);
  declare_uncertainties(section);
  declare_scales(section);
}

std::shared_ptr<const Analysis> Identify::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(identify_section);
  std::optional<MeasuredForce> measured;
  if (has_measured_force(values)) {
    refuse_keys_of_motions(values);
    measured = read_measured_force(values);
  } else {
    values.require("Duration");
    refuse_keys_of_records(values);
  }
  return std::make_shared<Identify>(
      Settings{.duration = measured ? 0 : values.quantity("Duration"),
               .sampling_frequency = read_sampling_frequency(values),
               .contact = values.text("Contact"),
               .uncertainties = {.impulse = values.quantity("Uncertainty of impulse"),
                                 .peak_force = values.quantity("Uncertainty of peak force"),
                                 .compliance = values.quantity("Uncertainty of compliance"),
                                 .stiffness = values.quantity("Uncertainty of stiffness")},
               .scales = {.length = values.quantity("Length scale"),
                          .time = values.quantity("Time scale"),
                          .force = values.quantity("Force scale")},
               .map_points = count(values, "Map points"),
               .recorded_pulses = count(values, "Recorded pulses"),
               .listed_impacts = count(values, "Listed impacts"),
               .slowest_fitted = values.quantity("Slowest fitted impact"),
               .measured = std::move(measured)});
}

std::size_t Identify::contact_index(const contact::ContactSet &contacts) const {
  if (settings_.contact.empty() && contacts.size() == 1)
    return 0;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (contacts.pairs()[c].name == settings_.contact)
      return c;
  throw InputError(settings_.contact.empty()
                       ? "Identify / Contact must be set when not exactly one contact is active."
                       : "Identify / Contact must name an active contact, but is '" +
                             settings_.contact + "'.");
}

ContactConstants Identify::constants(const System &system) const {
  const std::size_t contact = contact_index(system.contacts);
  const contact::ContactPair &pair = system.contacts.pairs()[contact];
  const std::optional<contact::PowerLaw> law = pair.law->power_law();
  if (!law)
    throw InputError("Identify / Contact: the law of contact " + pair.name +
                     " must be hertz or hunt-crossley, F = k u^n (1 + d u'), but is " +
                     pair.law->name() + ".");
  return {.compliance = 1 / system.contacts.effective_mass(contact, system.model),
          .stiffness = law->stiffness,
          .exponent = law->exponent};
}

void Identify::check(const System &system) const {
  constants(system);
  if (settings_.measured)
    return;
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
}

IdentificationInput Identify::input(const System &system) const {
  const contact::ContactPair &pair = system.contacts.pairs()[contact_index(system.contacts)];
  return {.contact = pair.name,
          .constants = constants(system),
          .dissipation = pair.law->power_law()->dissipation,
          .scales = settings_.scales,
          .uncertainties = settings_.uncertainties,
          .pulses = {},
          .listed_impacts = settings_.listed_impacts,
          .slowest_fitted = settings_.slowest_fitted};
}

PointResult Identify::of_motion(const System &system, LineContext &context) const {
  const std::size_t contact = contact_index(system.contacts);
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  motion::ImpactLog log(system.contacts, settings_.recorded_pulses, true);
  MotionProgress progress(context, 0, settings_.duration);
  const double interval = 1 / settings_.sampling_frequency;
  std::optional<Sampler> record;
  PointResult result;
  try {
    std::vector<motion::Observer *> observing = {&log, &progress};
    if (settings_.sampling_frequency > 0) {
      const auto samples = static_cast<std::size_t>(settings_.duration / interval) + 2;
      observing.push_back(&record.emplace(std::vector{normal_force(system.contacts, contact)}, 0,
                                          interval, samples));
    }
    motion::Observers observers(std::move(observing));
    trajectory.start(0, system.initial.displacement, system.initial.velocity);
    trajectory.advance(settings_.duration, observers);
  } catch (const NumericalError &error) {
    result.status = Status::failed;
    result.reason = error.what();
  }
  IdentificationInput found = input(system);
  for (const motion::Impact &impact : log.impacts(contact))
    found.pulses.push_back(
        record ? figures_of(record->times(), record->values(0), interval, impact)
               : PulseFigures{.impulse = impact.impulse, .peak_force = impact.peak_force});
  add_impacts(result, system.contacts, log, settings_.listed_impacts);
  add_identification(result, found);
  add_restitution_maps(result, found, settings_.map_points);
  add_pulses(result, system.contacts, log);
  if (record)
    add_force_record(result, found.contact, record->times(), record->values(0));
  add_accuracy(result, trajectory.accuracy(), system.integration);
  return result;
}

PointResult Identify::of_record(const System &system) const {
  PointResult result;
  IdentificationInput found = input(system);
  const std::vector<MeasuredPulse> pulses = pulses_of(*settings_.measured);
  for (const MeasuredPulse &pulse : pulses)
    found.pulses.push_back(pulse.figures);
  add_identification(result, found);
  add_measured_pulses(result, found.contact, pulses);
  add_restitution_maps(result, found, settings_.map_points);
  add_force_record(result, found.contact, settings_.measured->samples.time,
                   settings_.measured->samples.value);
  return result;
}

void Identify::run_line(std::size_t /*line*/, System &system, LineContext &context) const {
  if (context.find({})) {
    context.skip();
    return;
  }
  context.store(settings_.measured ? of_record(system) : of_motion(system, context));
}

} // namespace vibroimpact::analyses
