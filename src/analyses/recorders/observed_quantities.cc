#include "analyses/recorders/observed_quantities.h"

#include "analyses/channels.h"

#include <algorithm>

namespace vibroimpact::analyses {

using motion::Bernstein;
using motion::Equations;
using motion::StepView;
using motion::ValueRange;

namespace {

const std::vector<std::string> quantity_kinds = {
    "displacement", "absolute_displacement", "velocity", "acceleration",
    "gap",          "normal_force",          "stop",     "rotor"};

bool contains(const std::vector<std::string> &list, const std::string &name) {
  return list.empty() || std::find(list.begin(), list.end(), name) != list.end();
}

// An empty list means all.
std::vector<std::string> without_all(std::vector<std::string> names) {
  if (names == std::vector<std::string>{"all"})
    names.clear();
  return names;
}

Bernstein rate_of(Bernstein curve, double length) {
  curve = curve.derivative();
  curve *= 1 / length;
  return curve;
}

void add_channel(const Channel &channel, std::vector<ObservedQuantity> &list) {
  const std::string base = "point/" + channel.point + "/";
  const std::string along = std::string(" along ") + channel.axis;
  const std::string axis = std::string("_") + channel.axis;
  const model::Projection &relative = channel.relative;
  const model::Projection &absolute = channel.absolute;
  list.push_back({base + "displacement" + axis, "displacement", "m",
                  "displacement relative to the base" + along,
                  [relative](const StepView &v) { return v.displacement(relative); },
                  [relative](const Equations &e, ValueRange &x) {
                    return motion::monitored_displacement(e, relative, x);
                  }});
  if (channel.carried())
    list.push_back({base + "absolute_displacement" + axis, "absolute_displacement", "m",
                    "displacement in space" + along,
                    [absolute](const StepView &v) { return v.displacement(absolute); },
                    [absolute](const Equations &e, ValueRange &x) {
                      return motion::monitored_displacement(e, absolute, x);
                    }});
  list.push_back({base + "velocity" + axis, "velocity", "m/s",
                  "velocity relative to the base" + along,
                  [relative](const StepView &v) { return v.velocity(relative); },
                  [relative](const Equations &e, ValueRange &x) {
                    return motion::monitored_velocity(e, relative, x);
                  }});
  list.push_back({base + "acceleration" + axis, "acceleration", "m/s^2",
                  "absolute acceleration" + along,
                  [absolute](const StepView &v) { return v.acceleration(absolute); },
                  [absolute](const Equations &e, ValueRange &x) {
                    return motion::monitored_acceleration(e, absolute, x);
                  }});
}

void add_internal(const std::string &path, const contact::InternalState &state, Index place,
                  double offset, std::vector<ObservedQuantity> &list) {
  list.push_back({path, "stop", state.unit, state.description,
                  [place, offset](const StepView &v) {
                    Bernstein curve = v.internal(place);
                    curve += offset;
                    return curve;
                  },
                  [place, offset](const Equations &e, ValueRange &x) {
                    return motion::monitored_state(e, e.layout().internal() + place, offset, x);
                  }});
}

void add_contact(const contact::ContactPair &pair, std::size_t contact,
                 std::vector<ObservedQuantity> &list) {
  const std::string base = "contact/" + pair.name + "/";
  list.push_back({base + "gap", "gap", "m", "gap, > 0 open",
                  [contact](const StepView &v) { return v.gap(contact); },
                  [contact](const Equations &e, ValueRange &x) {
                    return motion::monitored_contact(e, contact, {.gap = 1}, x);
                  }});
  const std::vector<contact::InternalState> states = pair.law->internal_states();
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Index place = pair.internal_offset + static_cast<Index>(i);
    add_internal(base + "internal/" + states[i].name, states[i], place, 0, list);
    if (states[i].name == "stop_deformation")
      add_internal(base + "stop_position",
                   {.name = "",
                    .unit = "m",
                    .description = "distance of the stop's end from the undeformed other side"},
                   place, pair.clearance, list);
  }
}

void add_rotor(const model::Rotor &rotor, std::vector<ObservedQuantity> &list) {
  const std::string base = "rotor/" + rotor.name + "/";
  list.push_back({base + "speed", "rotor", "rad/s", "angular velocity",
                  [angle = rotor.angle](const StepView &v) {
                    return rate_of(v.coordinate(angle), v.length());
                  }});
  if (!rotor.motor)
    return;
  const model::Motor motor = *rotor.motor;
  list.push_back({base + "torque", "rotor", "N m", "torque of the motor",
                  [motor](const StepView &v) { return v.drive(motor.drive); }});
  list.push_back(
      {base + "current", "rotor", "A", "current of the motor", [motor](const StepView &v) {
         Bernstein current = v.drive(motor.drive);
         current *= 1 / motor.torque_constant;
         return current;
       }});
}

} // namespace

bool ObservedSelection::has(const std::string &kind) const { return contains(this->kinds, kind); }

void declare_selection_of_quantities(parameters::Section &section) {
  std::string list;
  for (const std::string &kind : quantity_kinds)
    list += ", " + kind;
  section.names("Points", "all", "Points that are observed: all, or their names as BODY.POINT.")
      .names("Quantities", "all",
             "What is observed: all, or some of" + list.substr(1) +
                 ". stop: internal states of contact laws, such as the deformation of a stop; "
                 "rotor: speed, torque and current; connection_force: in histories only.");
}

ObservedSelection read_selection_of_quantities(const parameters::Values &section) {
  ObservedSelection selection{.points = without_all(section.names("Points")),
                              .kinds = without_all(section.names("Quantities"))};
  for (const std::string &kind : selection.kinds)
    section.require_known("Quantities", kind, quantity_kinds);
  return selection;
}

void check_points(const ObservedSelection &selection, const System &system,
                  const parameters::Values &section) {
  for (const std::string &point : selection.points)
    section.require_known("Points", point, system.model.point_names());
}

std::vector<ObservedQuantity> observed_quantities(const ObservedSelection &selection,
                                                  const System &system) {
  std::vector<ObservedQuantity> list;
  for (const Channel &channel : observed_channels(system.model))
    if (contains(selection.points, channel.point))
      add_channel(channel, list);
  for (std::size_t c = 0; c < system.contacts.size(); ++c)
    add_contact(system.contacts.pairs()[c], c, list);
  for (const model::Rotor &rotor : system.model.rotors().list())
    add_rotor(rotor, list);
  list.erase(std::remove_if(list.begin(), list.end(),
                            [&](const ObservedQuantity &q) { return !selection.has(q.kind); }),
             list.end());
  return list;
}

bool in_contact(const StepView &view, std::size_t contact) {
  const auto mode = static_cast<std::size_t>(view.equations().modes()[contact]);
  return view.equations().contacts().pairs()[contact].law->modes()[mode].in_contact;
}

} // namespace vibroimpact::analyses
