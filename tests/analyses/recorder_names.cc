// All recorders together: no two of them give a result the same name, and none gives a result the
// name of a group of others, which no HDF5 file could hold.
#include "analyses/recorders/observables.h"
#include "analyses/recorders/recorders.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "support/recorded_windows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <set>
#include <tuple>

namespace vibroimpact::analyses {
namespace recorder_names_tests {

using namespace contact;

// A block on a shaken base between a Kelvin-Voigt bumper and one that remembers its approach speed,
// with a connection to the base.
System busy_system() {
  model::Model model = testing::linked_block();
  ContactPair right = testing::contact_along_x(model, "block.head", "", 0.005,
                                               std::make_shared<KelvinVoigtBumper>(50, 3));
  right.name = "right";
  ContactPair left = testing::contact_along_x(
      model, "block.head", "", 0.005,
      HuntCrossley::with_dimensionless_damping({.stiffness = 1e4, .exponent = 1.5}, 0.3, 1e-3));
  left.name = "left";
  left.gap.row *= -1;
  return testing::system_of(std::move(model), ContactSet({right, left}));
}

PointResult all_recorded() {
  auto root = std::make_shared<parameters::Section>("file", "A file.");
  declare_recorders(*root);
  const std::string names = "extreme values, statistics, impacts, energy, forces, quasi static, "
                            "history, section, regime, lyapunov, spectrum";
  const auto set =
      parameters::ParameterSet::parse(root, "set Record = " + names + "\n", "test.prm", false);
  const System system = busy_system();
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  WindowRecording recording(read_recorders(set->root(), {}), system);
  recording.run(periods_window(0, 2 * std::numbers::pi / 8, 40), trajectory);
  PointResult result;
  recording.add_fields(result);
  return result;
}

// Accelerations are measured in space, the others from the base.
TEST(RecorderNamesTest, SignalsOfPointsSayWhatTheyAre) {
  const System system = busy_system();
  for (const auto &[quantity, unit, description] :
       {std::tuple{"displacement", "m", "displacement relative to the base along x"},
        std::tuple{"velocity", "m/s", "velocity relative to the base along x"},
        std::tuple{"acceleration", "m/s^2", "absolute acceleration along x"}}) {
    auto root = std::make_shared<parameters::Section>("file", "A file.");
    declare_signals(*root);
    const auto set = parameters::ParameterSet::parse(
        root, "set Quantity = " + std::string(quantity) + "\n", "test.prm", false);
    const Observable signal = chosen_signals(set->root(), system).at(0);
    EXPECT_EQ(signal.path, "point/block.head/" + std::string(quantity) + "_x");
    EXPECT_EQ(signal.unit, unit);
    EXPECT_EQ(signal.description(), description);
  }
}

TEST(RecorderNamesTest, ForcesOfChosenContactsAreSignals) {
  const System system = busy_system();
  for (const auto &[chosen, count] : {std::pair{"none", 0}, std::pair{"left", 1}, {"all", 2}}) {
    auto root = std::make_shared<parameters::Section>("file", "A file.");
    declare_signals(*root);
    const auto set = parameters::ParameterSet::parse(
        root, "set Contacts = " + std::string(chosen) + "\n", "test.prm", false);
    const std::vector<Observable> signals = chosen_signals(set->root(), system);
    EXPECT_EQ(std::count_if(signals.begin(), signals.end(),
                            [](const auto &signal) { return signal.unit == "N"; }),
              count)
        << chosen;
    if (count > 0) {
      EXPECT_EQ(signals.back().path, "contact/left/normal_force");
    }
  }
}

TEST(RecorderNamesTest, EveryResultHasANameOfItsOwn) {
  const PointResult result = all_recorded();
  std::set<std::string> datasets, groups;
  for (const Field &field : result.fields) {
    EXPECT_TRUE(datasets.insert(field.name()).second) << field.name();
    for (std::size_t at = field.name().find('/'); at != std::string::npos;
         at = field.name().find('/', at + 1))
      groups.insert(field.name().substr(0, at));
  }
  EXPECT_GT(datasets.size(), 100u);
  for (const std::string &name : datasets)
    EXPECT_EQ(groups.count(name), 0u) << name << " is a result and a group";
}

} // namespace recorder_names_tests
} // namespace vibroimpact::analyses
