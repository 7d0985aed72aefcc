#include "analyses/recorders/section.h"

#include "analyses/results/fields.h"
#include "analyses/signals/zeros.h"

#include <boost/algorithm/string/replace.hpp>
#include <cmath>

namespace vibroimpact::analyses {

using motion::StepView;

namespace {

constexpr const char *poincare_section_keys = "Section";
constexpr std::size_t period_section = 0;

} // namespace

SectionRecorder::SectionRecorder(const System &system, SectionSettings settings)
    : model_(system.model), settings_(std::move(settings)),
      observables_(
          settings_.observed.empty()
              ? point_observables(system.model, {.points = {},
                                                 .kinds = {"displacement", "velocity", "rotation",
                                                           "angular_velocity"}})
              : settings_.observed) {
  new_section("period", "sample_period", "at the end of a forcing period");
  for (const std::size_t c : settings_.onsets) {
    const std::string &name = system.contacts.pairs()[c].name;
    new_section("onset/" + name, "sample_onset_" + name, "where contact " + name + " begins");
  }
  for (const std::size_t c : settings_.gap_extrema) {
    const std::string &name = system.contacts.pairs()[c].name;
    gap_rates_.push_back({.samples = new_section("gap_extremum/" + name, "sample_gap_" + name,
                                                 "at an extremum of the gap of " + name)});
  }
  for (std::size_t k = 0; settings_.extrema && k < observables_.size(); ++k) {
    if (std::get<motion::PointForm>(observables_[k].form).order > 0)
      continue;
    const std::string &path = observables_[k].path;
    const std::string name = path.substr(path.find('/') + 1);
    const std::string flat =
        boost::replace_last_copy(boost::replace_last_copy(name, "/displacement_", "_"), "/", "_");
    displacement_rates_.push_back(
        {.samples = new_section("extremum/" + name, "sample_extremum_" + flat,
                                "at an extremum of " + name),
         .displacement = k});
  }
}

void SectionRecorder::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      poincare_section_keys,
      "Sections of the motion: displacements and velocities relative to the base at "
      "the end of each forcing period, and where a surface is passed.");
  declare_points(section);
  section
      .names("Contact onsets", "none",
             "Contacts whose onset is a further section: all, none, or their names.")
      .names("Gap extrema", "none",
             "Contacts whose extrema of the gap are a further section: all, none, or their names.")
      .boolean("Extrema", "false",
               "Makes the extrema of each observed displacement a further section.")
      .integer("Maximum samples", "10000", Range{.lower = 1, .upper = 1e8}, "",
               "Samples kept of each section, the first ones.");
}

RecorderFactory SectionRecorder::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(poincare_section_keys);
  return [values](const System &system) -> std::unique_ptr<Recorder> {
    SectionSettings settings{.observed = chosen_points(values, system, {0, 1}),
                             .onsets = chosen_contacts(values, "Contact onsets", system),
                             .gap_extrema = chosen_contacts(values, "Gap extrema", system),
                             .extrema = values.boolean("Extrema"),
                             .maximum_samples =
                                 static_cast<std::size_t>(values.integer("Maximum samples"))};
    if (settings.observed.empty())
      values.reject("Points", "must name at least one point, or Connections at least one");
    return std::make_unique<SectionRecorder>(system, std::move(settings));
  };
}

std::size_t SectionRecorder::new_section(const std::string &name, const std::string &dimension,
                                         const std::string &description) {
  sections_.push_back({.name = name,
                       .dimension = dimension,
                       .description = description,
                       .time = {},
                       .values = std::vector<std::vector<double>>(observables_.size())});
  return sections_.size() - 1;
}

void SectionRecorder::Samples::clear() {
  time.clear();
  for (std::vector<double> &series : values)
    series.clear();
  left_out = 0;
}

bool SectionRecorder::full(Samples &samples) const {
  const bool full = samples.time.size() >= settings_.maximum_samples;
  samples.left_out += full ? 1 : 0;
  return full;
}

void SectionRecorder::add_state(Samples &samples, double time, const Vector &state) const {
  if (full(samples))
    return;
  samples.time.push_back(time);
  for (std::size_t k = 0; k < observables_.size(); ++k) {
    const auto &[projection, order] = std::get<motion::PointForm>(observables_[k].form);
    const Index first = order == 0 ? 0 : layout_.velocity();
    double value = projection.row.dot(state.segment(first, layout_.n));
    for (std::size_t i = 0; i < projection.base_coefficients.size(); ++i) {
      const model::TimeFunction &base = *model_.sources()[i].function;
      if (const double factor = projection.base_coefficients[i]; factor != 0)
        value += factor * (order == 0 ? base.value(time) : base.rate(time));
    }
    samples.values[k].push_back(value);
  }
}

void SectionRecorder::add_point(Samples &samples, const StepView &view, double tau) const {
  if (full(samples))
    return;
  samples.time.push_back(view.start() + tau * view.length());
  for (std::size_t k = 0; k < observables_.size(); ++k)
    samples.values[k].push_back(curve(observables_[k].form, view)(tau));
}

void SectionRecorder::begin(const Window &window, const motion::Trajectory &trajectory) {
  start_ = window.start;
  period_ = window.period;
  layout_ = trajectory.layout();
  for (Samples &samples : sections_)
    samples.clear();
  for (auto *rates : {&gap_rates_, &displacement_rates_})
    for (RateSection &section : *rates)
      section.last_rate = 0;
}

// A rate that jumps through zero at a contact change makes an extremum at the start of the step.
void SectionRecorder::add_zeros(RateSection &section, const StepView &view,
                                const motion::Bernstein &rate) {
  if (rate.start() * section.last_rate < 0)
    add_point(sections_[section.samples], view, 0);
  for (const double tau : sign_changes(rate))
    add_point(sections_[section.samples], view, tau);
  section.last_rate = rate.end();
}

void SectionRecorder::step(const StepView &view) {
  for (std::size_t i = 0; i < gap_rates_.size(); ++i)
    add_zeros(gap_rates_[i], view, view.gap_rate(settings_.gap_extrema[i]));
  for (RateSection &section : displacement_rates_)
    add_zeros(section, view, curve(observables_[section.displacement].form, view).derivative());
}

void SectionRecorder::event(const motion::ContactEvent &event) {
  for (std::size_t i = 0; i < settings_.onsets.size(); ++i)
    if (event.onset && settings_.onsets[i] == event.contact)
      add_state(sections_[period_section + 1 + i], event.time, *event.before);
}

void SectionRecorder::period_end(long /*cycle*/, const motion::Trajectory &trajectory) {
  add_state(sections_[period_section], trajectory.time(), trajectory.state());
}

void SectionRecorder::add_samples(const FieldWriter &result, const Samples &samples) const {
  const FieldWriter of = result.below("section/" + samples.name + "/");
  const auto add = [&](const std::string &name, const std::vector<double> &values,
                       const std::string &unit, const std::string &what) {
    of.series(name, samples.dimension, values, unit, what + " " + samples.description);
  };
  add("time", samples.time, "s", "time");
  if (period_ > 0) {
    std::vector<double> phase;
    for (const double time : samples.time)
      phase.push_back((time - start_) / period_ - std::floor((time - start_) / period_));
    add("phase", phase, "1", "part of the forcing period since the last forcing phase zero");
  }
  for (std::size_t k = 0; k < observables_.size(); ++k)
    add(observables_[k].path, samples.values[k], observables_[k].unit, observables_[k].kind);
  of.number("left_out", static_cast<double>(samples.left_out), "1",
            "samples beyond the maximum number");
}

void SectionRecorder::add_fields(const FieldWriter &result) const {
  for (const Samples &samples : sections_)
    if (period_ > 0 || &samples != &sections_[period_section])
      add_samples(result, samples);
}

} // namespace vibroimpact::analyses
