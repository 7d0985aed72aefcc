#include "model/spin.h"

#include "model/model.h"

#include <algorithm>

namespace vibroimpact::model {

namespace {

constexpr const char *run_up_section = "Run-up";

SpinSpeed read_speed(const parameters::Values &section) {
  section.require("Speed");
  const double speed = section.quantity("Speed");
  if (!section.subsection_given(run_up_section))
    return SpinSpeed(speed);
  const parameters::Values run_up = section.subsection(run_up_section);
  run_up.require("Last speed");
  run_up.require("Duration");
  return {speed, run_up.quantity("Last speed"), run_up.quantity("Start"),
          run_up.quantity("Duration")};
}

/// Names of the bodies with a Spin axis.
std::vector<std::string> turning_bodies(const Model &model) {
  std::vector<std::string> names;
  for (const auto &body : model.bodies())
    if (!body->spin.empty())
      names.push_back(body->name);
  return names;
}

Spin spin_of(const parameters::Values &section, const std::string &name, const Model &model) {
  const std::vector<std::string> known = turning_bodies(model);
  std::vector<std::string> names = section.names("Bodies");
  if (names.empty())
    names = known;
  if (names.empty())
    section.reject_section("no body has a subsection Spin axis, so that nothing turns");
  Spin spin{.name = name, .speed = read_speed(section), .bodies = {}};
  const bool runs_up = section.subsection_given(run_up_section);
  for (const std::string &body : names) {
    if (const std::size_t b = model.find_body(body);
        b < model.bodies().size() && model.bodies()[b]->spin.empty())
      section.reject("Bodies",
                     "must name bodies with a subsection Spin axis; " + body + " has none");
    section.require_known("Bodies", body, known);
    spin.bodies.push_back(model.find_body(body));
    if (runs_up && model.bodies()[spin.bodies.back()]->spin.rotating_frame)
      section.subsection(run_up_section)
          .reject_section("must not be given for bodies with Frame = rotating, such as " + body);
  }
  return spin;
}

} // namespace

void declare_spins(parameters::Section &root) {
  using namespace parameters;
  Section &spin = root.named_subsection(
      "Spin", "The speed at which bodies turn about their Spin axis: constant, or a ramp.");
  spin.names("Bodies", "", "Bodies that turn; empty: all with a Spin axis.")
      .quantity("Speed", "", dimension::frequency, range::any, "\\Omega",
                "Constant, or before the run-up; negative against the Direction of the axis.")
      .required();
  spin.subsection(run_up_section, "From Speed to another one, linearly in time.")
      .quantity("Last speed", "", dimension::frequency, range::any, "\\Omega_1",
                "From the end of the run-up on; it may be the lower one.")
      .required("there is a Run-up")
      .quantity("Duration", "", dimension::time, range::positive, "T", "Of the run-up.")
      .required("there is a Run-up")
      .quantity("Start", "0 s", dimension::time, range::non_negative, "t_0",
                "When the run-up begins.");
}

void add_spins(const parameters::Values &root, Model &model) {
  std::vector<std::string> of(model.bodies().size());
  for (const std::string &name : root.instances("Spin")) {
    const parameters::Values section = root.instance("Spin", name);
    const Spin spin = spin_of(section, name, model);
    for (const std::size_t b : spin.bodies) {
      if (!of[b].empty())
        section.reject("Bodies", "must not name " + model.bodies()[b]->name +
                                     ", which turns with Spin " + of[b]);
      of[b] = name;
    }
    model.add_spin(spin);
  }
}

Spin read_spin(const parameters::Values &root, const parameters::Values &section,
               const std::string &key, const Model &model) {
  section.require(key);
  const std::string name = section.text(key);
  section.require_known(key, name, root.instances("Spin"));
  return spin_of(root.instance("Spin", name), name, model);
}

} // namespace vibroimpact::model
