#include "analyses/recorders/impacts.h"

#include "analyses/fields.h"
#include "analyses/recorders/watched_quantities.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace vibroimpact {

namespace {

void add_summary_of(PointResult &result, const std::string &path, const std::vector<double> &values,
                    const std::string &unit, const std::string &meaning) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(values.size(), 1));
  const bool none = values.empty();
  result.fields.push_back(
      scalar_field(path + "/mean", none ? nan : mean, unit, meaning + ", mean of the impacts"));
  result.fields.push_back(
      scalar_field(path + "/minimum", none ? nan : *lowest, unit, meaning + ", smallest"));
  result.fields.push_back(
      scalar_field(path + "/maximum", none ? nan : *highest, unit, meaning + ", largest"));
}

std::vector<double> values_of(const std::vector<Impact> &impacts, double Impact::*member) {
  std::vector<double> values;
  for (const Impact &impact : impacts)
    values.push_back(impact.*member);
  return values;
}

} // namespace

Impacts::Impacts(const System &system)
    : contacts_(system.contacts), log_(system.contacts, 0),
      time_in_contact_(system.contacts.size(), 0), chatters_(system.contacts.size(), 0),
      approach_speeds_(system.contacts.size()) {}

void Impacts::declare(parameters::Section & /*analysis*/) {}

RecorderFactory Impacts::create(const parameters::Values & /*analysis*/) {
  return [](const System &system) { return std::make_unique<Impacts>(system); };
}

void Impacts::begin(const Window &window, const Trajectory & /*trajectory*/) { window_ = window; }

void Impacts::step(const StepView &view) {
  log_.step(view);
  for (std::size_t c = 0; c < contacts_.size(); ++c)
    if (in_contact(view, c))
      time_in_contact_[c] += view.length();
}

void Impacts::watch(const Equations &equations, std::vector<WatchedForm> &forms) {
  log_.flight_watcher()->watch(equations, forms);
}

void Impacts::flown(const Equations &equations, double start, double end) {
  log_.flight_watcher()->flown(equations, start, end);
  for (std::size_t c = 0; c < contacts_.size(); ++c)
    if (equations.mode(c).in_contact)
      time_in_contact_[c] += end - start;
}

void Impacts::event(const ContactEvent &event) {
  log_.event(event);
  if (event.onset)
    approach_speeds_[event.contact].push_back(-event.gap_rate);
  if (event.chatter_duration > 0)
    ++chatters_[event.contact];
}

void Impacts::add_fields(PointResult &result) const {
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const std::string base = "contact/" + contacts_.pairs()[c].name + "/";
    const auto begun = static_cast<double>(log_.begun(c));
    const std::vector<Impact> &whole = log_.impacts(c);
    result.fields.push_back(
        scalar_field(base + "impacts", begun, "1", "impacts begun in the recorded window"));
    if (window_.cycles > 0)
      result.fields.push_back(scalar_field(base + "impacts_per_period",
                                           begun / static_cast<double>(window_.cycles), "1",
                                           "impacts begun per forcing period"));
    result.fields.push_back(scalar_field(base + "contact_fraction",
                                         time_in_contact_[c] / window_.length(), "1",
                                         "share of the recorded window in contact"));
    result.fields.push_back(scalar_field(
        base + "chatters", static_cast<double>(chatters_[c]), "1",
        "infinite sequences of rigid impacts that were completed in the recorded window"));
    add_summary_of(result, base + "approach_speed", approach_speeds_[c], "m/s",
                   "closing speed just before contact");
    add_summary_of(result, base + "impulse", values_of(whole, &Impact::impulse), "N s",
                   "time integral of the normal force");
    add_summary_of(result, base + "peak_force", values_of(whole, &Impact::peak_force), "N",
                   "largest normal force");
    add_summary_of(result, base + "contact_duration", values_of(whole, &Impact::duration), "s",
                   "time in contact");
    add_summary_of(result, base + "penetration", values_of(whole, &Impact::maximum_penetration),
                   "m", "largest overlap");
  }
}

} // namespace vibroimpact
