#include "analyses/observed_signal.h"

#include <algorithm>

namespace vibroimpact::analyses {

using motion::StepView;

namespace {

// all, none, or some of the known names, without repetition and in the order of the known ones.
std::vector<std::string> chosen(const parameters::Values &values, const std::string &key,
                                const std::vector<std::string> &known) {
  const std::vector<std::string> names = values.names(key);
  if (names.empty() || (names.size() == 1 && names[0] == "none"))
    return {};
  if (names.size() == 1 && names[0] == "all")
    return known;
  for (const std::string &name : names)
    values.require_known(key, name, known);
  return names;
}

bool contains(const std::vector<std::string> &names, const std::string &name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::function<StepFunction(const StepView &)> along(const Channel &channel,
                                                    const std::string &quantity) {
  if (quantity == "displacement")
    return [projection = channel.relative](const StepView &view) -> StepFunction {
      return view.displacement(projection);
    };
  if (quantity == "velocity")
    return [projection = channel.relative](const StepView &view) -> StepFunction {
      motion::Bernstein rate = view.displacement(projection).derivative();
      rate *= 1 / view.length();
      return rate;
    };
  return [projection = channel.absolute](const StepView &view) -> StepFunction {
    return view.acceleration(projection);
  };
}

ObservedSignal point_signal(const Channel &channel, const std::string &quantity) {
  const bool absolute = quantity == "acceleration";
  return {.name = "point/" + channel.point + "/" + quantity + "_" + channel.axis,
          .unit = quantity == "displacement" ? "m" : (absolute ? "m/s^2" : "m/s"),
          .description = (absolute ? "absolute " + quantity : quantity + " relative to the base") +
                         " along " + channel.axis,
          .along = along(channel, quantity)};
}

ObservedSignal force_signal(const std::string &contact, std::size_t index) {
  return {.name = "contact/" + contact + "/normal_force",
          .unit = "N",
          .description = "normal force",
          .along = [index](const StepView &view) -> StepFunction {
            return [view, index, curves = view.contact_curves(index)](double tau) {
              return view.force(index, curves, tau);
            };
          }};
}

} // namespace

void declare_points(parameters::Section &section) {
  section.names("Points", "all", "Points that are observed: all, none, or their names BODY.POINT.");
}

void declare_signals(parameters::Section &section) {
  declare_points(section);
  section
      .choice("Quantity", "displacement", {"displacement", "velocity", "acceleration"},
              "What is observed at the points: displacement or velocity relative to the base, or "
              "absolute acceleration.")
      .names("Contacts", "none",
             "Contacts whose normal force is observed: all, none, or their names.");
}

std::vector<Channel> chosen_channels(const parameters::Values &values, const System &system) {
  const std::vector<std::string> points = chosen(values, "Points", system.model.point_names());
  std::vector<Channel> channels = observed_channels(system.model);
  std::erase_if(channels, [&](const Channel &channel) { return !contains(points, channel.point); });
  return channels;
}

std::vector<std::size_t> chosen_contacts(const parameters::Values &values, const std::string &key,
                                         const System &system) {
  std::vector<std::string> known;
  for (const contact::ContactPair &pair : system.contacts.pairs())
    known.push_back(pair.name);
  const std::vector<std::string> names = chosen(values, key, known);
  std::vector<std::size_t> contacts;
  for (std::size_t c = 0; c < known.size(); ++c)
    if (contains(names, known[c]))
      contacts.push_back(c);
  return contacts;
}

std::vector<ObservedSignal> chosen_signals(const parameters::Values &values, const System &system) {
  std::vector<ObservedSignal> signals;
  const std::string quantity = values.choice("Quantity");
  for (const Channel &channel : chosen_channels(values, system))
    signals.push_back(point_signal(channel, quantity));
  for (const std::size_t c : chosen_contacts(values, "Contacts", system))
    signals.push_back(force_signal(system.contacts.pairs()[c].name, c));
  if (signals.empty())
    values.reject("Points", "must name at least one point, or Contacts at least one contact");
  return signals;
}

} // namespace vibroimpact::analyses
