#include "analyses/recorders/observables.h"

#include "analyses/recorders/channels.h"
#include "motion/interval/constraint_force.h"
#include "motion/interval/guard_forms.h"

#include <algorithm>
#include <stdexcept>

namespace vibroimpact::analyses {

using motion::Bernstein;
using motion::ForceForm;
using motion::StateForm;
using motion::StepView;

namespace {

bool contains(const std::vector<std::string> &list, const std::string &name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

void add_channel(const Channel &channel, bool fixed, std::vector<Observable> &list) {
  const auto add = [&](const char *kind, const char *unit, const char *meaning,
                       const model::Projection &projection, int order) {
    list.push_back({"point/" + channel.point + "/" + kind + "_" + channel.axis, kind, unit, meaning,
                    motion::PointForm{projection, order},
                    std::string(channel.rotation ? " about " : " along ") + channel.axis});
  };
  if (channel.rotation) {
    add("rotation", "rad", "rotation", channel.relative, 0);
    add("angular_velocity", "rad/s", "angular velocity", channel.relative, 1);
    add("angular_acceleration", "rad/s^2", "angular acceleration", channel.absolute, 2);
    return;
  }
  add("displacement", "m", "displacement relative to the base", channel.relative, 0);
  if (fixed || channel.carried())
    add("absolute_displacement", "m", "displacement in space", channel.absolute, 0);
  add("velocity", "m/s", "velocity relative to the base", channel.relative, 1);
  add("acceleration", "m/s^2", "absolute acceleration", channel.absolute, 2);
}

void add_connection(const model::Connection &connection, std::vector<Observable> &list) {
  const auto add = [&](const char *kind, const char *unit, const std::string &meaning,
                       const char *of, int order) {
    list.push_back({"connection/" + connection.name + "/" + kind, kind, unit, meaning + of,
                    motion::PointForm{connection.elongation, order}});
  };
  const char *second = " of the second end relative to the first";
  if (connection.rotation) {
    add("elongation", "rad", "rotation", second, 0);
    add("elongation_rate", "rad/s", "angular velocity", second, 1);
    add("elongation_acceleration", "rad/s^2", "angular acceleration", second, 2);
    return;
  }
  add("elongation", "m", "displacement", second, 0);
  add("elongation_rate", "m/s", "velocity", second, 1);
  add("elongation_acceleration", "m/s^2", "acceleration", second, 2);
}

void add_friction(const contact::ContactSet &contacts, std::size_t c,
                  std::vector<Observable> &list) {
  const contact::ContactPair &pair = contacts.pairs()[c];
  const std::string base = "contact/" + pair.name + "/";
  const int directions = static_cast<int>(pair.tangential.size());
  for (int d = 1; d <= directions; ++d) {
    const std::string of = directions > 1 ? "_" + std::to_string(d) : "";
    const std::string which = directions == 1 ? "" : d == 1 ? "first " : "second ";
    const std::string along = directions == 1 ? "" : " along the " + which + "direction";
    if (!pair.circle)
      list.push_back({base + "slip" + of, "slip", "m",
                      "slip of the second side on the first" + along,
                      motion::SlipForm{.contact = c, .direction = d}});
    list.push_back({base + "slip_rate" + of, "slip", "m/s",
                    "slip rate of the second side's surface on the first" + along,
                    motion::SlipForm{.contact = c, .direction = d, .rate = true}});
    list.push_back({base + "friction_force" + of, "friction_force", "N", "friction force",
                    motion::FrictionForm{.contact = c, .direction = d},
                    " on the second side along the " + which + "direction of friction"});
  }
}

void add_place_in_ring(const contact::ContactSet &contacts, std::size_t c,
                       std::vector<Observable> &list) {
  constexpr const char *meanings[] = {
      "place of the first side relative to the second's centre along Direction",
      "place of the first side relative to the second's centre along Axis x Direction"};
  for (int d = 0; d < 2; ++d) {
    list.push_back({"contact/" + contacts.pairs()[c].name + "/place_" + std::to_string(d + 1),
                    "place", "m", meanings[d], [c, d](const StepView &view) {
                      const contact::Direction along =
                          view.equations().contacts().pairs()[c].along(d);
                      Bernstein place = view.displacement(*along.projection);
                      place += along.offset;
                      place *= -1;
                      return place;
                    }});
  }
}

void add_contact(const contact::ContactSet &contacts, std::size_t c,
                 std::vector<Observable> &list) {
  const contact::ContactPair &pair = contacts.pairs()[c];
  const std::string base = "contact/" + pair.name + "/";
  list.push_back(gap_of(contacts, c));
  list.push_back(normal_force(contacts, c));
  if (pair.circle)
    add_place_in_ring(contacts, c, list);
  if (!pair.tangential.empty())
    add_friction(contacts, c, list);
  Index place = pair.internal_offset;
  for (const contact::InternalState &state : pair.law->internal_states()) {
    list.push_back(
        {base + "internal/" + state.name, "stop", state.unit, state.description, StateForm{place}});
    if (state.name == "approach_speed")
      list.back().impact_of = c;
    if (state.name == "stop_deformation")
      list.push_back({base + "stop_position", "stop", "m",
                      "distance of the stop's end from the undeformed other side",
                      StateForm{place, pair.clearance}});
    ++place;
  }
}

void add_rotor(const model::Rotor &rotor, std::vector<Observable> &list) {
  const auto add = [&](const char *name, const char *unit, const char *meaning,
                       motion::CurveForm form) {
    list.push_back({"rotor/" + rotor.name + "/" + name, "rotor", unit, meaning, std::move(form)});
  };
  add("speed", "rad/s", "angular velocity", [angle = rotor.angle](const StepView &view) {
    Bernstein rate = view.coordinate(angle).derivative();
    rate *= 1 / view.length();
    return rate;
  });
  if (!rotor.motor)
    return;
  add("torque", "N m", "torque of the motor",
      [drive = rotor.motor->drive](const StepView &view) { return view.drive(drive); });
  add("current", "A", "current of the motor", [motor = *rotor.motor](const StepView &view) {
    Bernstein current = view.drive(motor.drive);
    current *= 1 / motor.torque_constant;
    return current;
  });
}

std::vector<std::string> connection_names(const model::Model &model) {
  std::vector<std::string> names;
  for (const model::Connection &connection : model.connections())
    names.push_back(connection.name);
  return names;
}

void leave_selected(const ObservedSelection &selection, std::vector<Observable> &list) {
  std::erase_if(list, [&](const Observable &one) { return !selection.has(one.kind); });
}

} // namespace

bool ObservedSelection::has(const std::string &kind) const {
  return kinds.empty() || contains(kinds, kind);
}

std::vector<Observable> point_observables(const model::Model &model,
                                          const ObservedSelection &selection, bool fixed) {
  std::vector<Observable> list;
  for (const Channel &channel : observed_channels(model))
    if (selection.points.empty() || contains(selection.points, channel.point))
      add_channel(channel, fixed, list);
  for (const model::Connection &connection : model.connections())
    if (selection.connections.empty() || contains(selection.connections, connection.name))
      add_connection(connection, list);
  leave_selected(selection, list);
  return list;
}

std::vector<Observable> observables(const ObservedSelection &selection, const System &system) {
  std::vector<Observable> list = point_observables(system.model, selection);
  for (std::size_t c = 0; c < system.contacts.size(); ++c)
    add_contact(system.contacts, c, list);
  for (const model::Rotor &rotor : system.model.rotors().list())
    add_rotor(rotor, list);
  leave_selected(selection, list);
  return list;
}

Observable gap_of(const contact::ContactSet &contacts, std::size_t contact) {
  return {"contact/" + contacts.pairs()[contact].name + "/gap",
          "gap",
          "m",
          "gap",
          motion::GapForm{contact},
          ", > 0 open"};
}

Observable normal_force(const contact::ContactSet &contacts, std::size_t contact) {
  return {"contact/" + contacts.pairs()[contact].name + "/normal_force",
          "normal_force",
          "N",
          "normal force",
          ForceForm{contact},
          ", > 0 pushes apart"};
}

void put_forces_last(std::vector<Observable> &list) {
  std::stable_partition(list.begin(), list.end(),
                        [](const Observable &one) { return !one.is_force(); });
}

bool in_contact(const StepView &view, std::size_t contact) {
  return view.equations().mode(contact).in_contact;
}

bool is_seen(const Observable &observable, const motion::Equations &equations) {
  if (const auto *force = std::get_if<ForceForm>(&observable.form))
    return equations.mode(force->contact).in_contact;
  return !observable.impact_of || equations.mode(*observable.impact_of).in_contact;
}

namespace {

// Gap and slip rate of a contact in a circular gap, which are no polynomials.
StepFunction along_circle(const Observable &observable, const StepView &view) {
  const auto circular = [&](std::size_t c) {
    return view.equations().contacts().pairs()[c].circle != nullptr;
  };
  if (const auto *gap = std::get_if<motion::GapForm>(&observable.form);
      gap && circular(gap->contact))
    return motion::local_function(view, gap->contact,
                                  [](const contact::LocalState &state) { return state.gap; });
  if (const auto *slip = std::get_if<motion::SlipForm>(&observable.form);
      slip && slip->rate && circular(slip->contact))
    return motion::local_function(view, slip->contact, [](const contact::LocalState &state) {
      return state.tangential[0].slip_rate;
    });
  return {};
}

} // namespace

StepFunction along(const Observable &observable, const StepView &view) {
  if (StepFunction circular = along_circle(observable, view))
    return circular;
  if (!is_seen(observable, view.equations()) && observable.is_force())
    return [](double) { return 0.0; };
  if (const auto *force = std::get_if<ForceForm>(&observable.form))
    return [view, c = force->contact, curves = view.contact_curves(force->contact)](double tau) {
      return view.force(c, curves, tau);
    };
  return curve(observable.form, view);
}

namespace {

const std::vector<std::string> quantity_kinds = {"displacement",
                                                 "absolute_displacement",
                                                 "velocity",
                                                 "acceleration",
                                                 "rotation",
                                                 "angular_velocity",
                                                 "angular_acceleration",
                                                 "elongation",
                                                 "elongation_rate",
                                                 "elongation_acceleration",
                                                 "gap",
                                                 "place",
                                                 "normal_force",
                                                 "slip",
                                                 "friction_force",
                                                 "stop",
                                                 "rotor"};

// An empty list means all.
std::vector<std::string> without_all(std::vector<std::string> names) {
  if (names == std::vector<std::string>{"all"})
    names.clear();
  return names;
}

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

} // namespace

namespace {

std::vector<std::string> with_quantities(std::vector<std::string> more) {
  more.insert(more.begin(), quantity_kinds.begin(), quantity_kinds.end());
  return more;
}

} // namespace

void declare_selection_of_quantities(parameters::Section &section,
                                     const std::vector<std::string> &more) {
  std::string list;
  for (const std::string &kind : with_quantities(more))
    list += ", " + kind;
  section.names("Points", "all", "Points that are observed: all, or their names as BODY.POINT.")
      .names("Connections", "all", "Connections whose elongation is observed: all, or their names.")
      .names(
          "Quantities", "all",
          "What is observed: all, or some of" + list.substr(1) +
              ". rotation: of masses of lumped bodies; elongation: displacement of the two ends of "
              "a connection relative to each other, with its rate and acceleration; place: the two "
              "coordinates in a circular "
              "gap; stop: internal states of contact "
              "laws, such as the deformation of a stop; "
              "rotor: speed, torque and current.");
}

ObservedSelection read_selection_of_quantities(const parameters::Values &section,
                                               const std::vector<std::string> &more) {
  ObservedSelection selection{.points = without_all(section.names("Points")),
                              .kinds = without_all(section.names("Quantities")),
                              .connections = without_all(section.names("Connections"))};
  for (const std::string &kind : selection.kinds)
    section.require_known("Quantities", kind, with_quantities(more));
  return selection;
}

void check_points(const ObservedSelection &selection, const System &system,
                  const parameters::Values &section) {
  for (const std::string &point : selection.points)
    section.require_known("Points", point, system.model.point_names());
  for (const std::string &connection : selection.connections)
    section.require_known("Connections", connection, connection_names(system.model));
}

void declare_points(parameters::Section &section) {
  section.names("Points", "all", "Points that are observed: all, none, or their names BODY.POINT.")
      .names("Connections", "none",
             "Connections whose elongation is observed, the displacement of their ends relative to "
             "each other: all, none, or their names.");
}

void declare_signals(parameters::Section &section) {
  declare_points(section);
  section
      .choice("Quantity", "displacement", {"displacement", "velocity", "acceleration"},
              "What is observed at the points: displacement or velocity relative to the base, or "
              "absolute acceleration, or the rotation of masses that turn and its derivatives; of "
              "connections the elongation or its derivatives.")
      .names("Contacts", "none",
             "Contacts whose normal force is observed: all, none, or their names.");
}

std::vector<Observable> chosen_points(const parameters::Values &values, const System &system,
                                      std::initializer_list<int> orders) {
  const std::vector<std::string> points = chosen(values, "Points", system.model.point_names());
  const std::vector<std::string> connections =
      chosen(values, "Connections", connection_names(system.model));
  std::vector<Observable> list;
  for (const Channel &channel : observed_channels(system.model))
    if (contains(points, channel.point))
      add_channel(channel, false, list);
  for (const model::Connection &connection : system.model.connections())
    if (contains(connections, connection.name))
      add_connection(connection, list);
  std::erase_if(list, [&](const Observable &one) {
    const int order = std::get<motion::PointForm>(one.form).order;
    return one.kind == "absolute_displacement" ||
           std::find(orders.begin(), orders.end(), order) == orders.end();
  });
  return list;
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

std::vector<Observable> chosen_signals(const parameters::Values &values, const System &system) {
  const std::string quantity = values.choice("Quantity");
  std::vector<Observable> signals = chosen_points(values, system,
                                                  {quantity == "displacement" ? 0
                                                   : quantity == "velocity"   ? 1
                                                                              : 2});
  for (const std::size_t c : chosen_contacts(values, "Contacts", system)) {
    signals.push_back(normal_force(system.contacts, c));
    signals.back().supplement.clear();
  }
  if (signals.empty())
    values.reject("Points",
                  "must name at least one point, or Connections or Contacts at least one");
  return signals;
}

} // namespace vibroimpact::analyses
