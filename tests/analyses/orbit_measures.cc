// Derivatives of what is recorded of periodic motions, against differences of periodic motions that
// are found anew in tight tolerance: for every law, for impacts and rest without overlap, for a
// stop that a moving base carries, and where neighbouring motions have other contact changes.
#include "analyses/curves/periodic_orbit.h"
#include "analyses/derivatives/orbit_derivatives.h"
#include "analyses/derivatives/tangent_motion.h"
#include "analyses/keys/keyed_system.h"

#include "contact/laws/bilinear_stop.h"
#include "contact/laws/hertz.h"
#include "contact/laws/hunt_crossley.h"
#include "contact/laws/kelvin_voigt.h"
#include "contact/laws/kelvin_voigt_bumper.h"
#include "contact/laws/kuwabara_kono.h"
#include "contact/laws/linear_penalty.h"
#include "contact/laws/tsuji.h"
#include "support/points.h"
#include "support/recorded_windows.h"
#include "support/rigid_contacts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vibroimpact::analyses {
namespace orbit_measures_tests {

using testing::field_of;
using testing::value_of;

using Law = std::shared_ptr<const contact::ContactLaw>;

/// A mass against one stop, pushed by a force or shaken by its base.
struct Case {
  const char *name;
  std::function<Law(double)> law; ///< by its first constant
  double constant = 0;
  bool shaken = false;
  double stiffness = 40, clearance = 0.1, omega = 5;
  bool steep = false; ///< the slope of the force is infinite where contact begins
};

void PrintTo(const Case &shown, std::ostream *out) { *out << shown.name; }

using Keys = std::map<std::string, double>;

Keys keys_of(const Case &of) {
  return {{"mass", 1},
          {"stiffness", of.stiffness},
          {"damping", 0.8},
          {"amplitude", of.shaken ? 0.15 : 3},
          {"clearance", of.clearance},
          {"constant", of.constant},
          {"omega", of.omega}};
}

System system_of(const Case &of, const Keys &keys) {
  model::Model model(
      {testing::single_mass("block", keys.at("mass"), keys.at("stiffness"), keys.at("damping"))});
  const auto motion = std::make_shared<model::Harmonic>(model::Given::displacement,
                                                        keys.at("amplitude"), keys.at("omega"), 0);
  if (of.shaken)
    model.add_base_motion("shaker", motion, {0}, Vector3::UnitX());
  else
    model.add_force("shaker", motion, {}, Vector3::UnitX());
  contact::ContactPair pair = testing::contact_along_x(
      model, "block.head", "", keys.at("clearance"), of.law(keys.at("constant")));
  System system = testing::system_of(std::move(model), contact::ContactSet({pair}));
  system.integration.relative_tolerance = 1e-12;
  system.integration.event_tolerance = 1e-14;
  return system;
}

PointResult orbit(const Case &of, const Keys &keys, const OrbitStart &start,
                  const std::vector<std::string> &by = {}) {
  std::vector<OrbitKey> list;
  for (const std::string &key : by)
    list.push_back({key, key == "omega"
                             ? SweptParameter{}
                             : SweptParameter{.path = key, .unit = "1", .values = {keys.at(key)}}});
  testing::Points points([&](const std::vector<parameters::Override> &overrides) {
    Keys changed = keys;
    changed[overrides[0].path] = std::stod(overrides[0].value);
    return system_of(of, changed);
  });
  System system = system_of(of, keys);
  PeriodicOrbit({.start = start, .excitation = {}, .keys = list}).run_line(0, system, points);
  return points.all().at({});
}

const OrbitStart settled{.settling = {.minimum = 40, .maximum = 400, .tolerance = 1e-6}};

/// What the usual recorders see of one period.
PointResult measures_of(const Case &of, const Keys &keys, const periodic::Orbit &orbit) {
  const System system = system_of(of, keys);
  periodic::ForcedSystem forced(system.model, system.contacts, system.integration, 0);
  const double start = orbit.section.phase * forced.period();
  WindowRecording recording(default_recorders(), system);
  forced.trajectory().start({.time = start, .physical = orbit.point.state});
  recording.run(periods_window(start, forced.period(), orbit.multiple()), forced.trajectory());
  PointResult result;
  recording.add_fields(result);
  return result;
}

PointResult neighbour(const Case &of, Keys keys, const std::string &key, double step,
                      const std::vector<double> &state) {
  keys[key] += step;
  const PointResult found = orbit(of, keys, {.state = state});
  EXPECT_EQ(found.status, Status::finished) << found.reason;
  return found;
}

class OrbitMeasuresTable : public ::testing::TestWithParam<Case> {};

// A difference of fourth order with steps h and h/2 errs by h^4; motions of a relative error of
// 1e-12 leave 1e-12/h of it, of what a key of its own size would change.
TEST_P(OrbitMeasuresTable, agree_with_differences) {
  const Case &of = GetParam();
  const Keys keys = keys_of(of);
  std::vector<std::string> names;
  for (const auto &[key, value] : keys)
    names.push_back(key);
  const PointResult found = orbit(of, keys, settled, names);
  ASSERT_EQ(found.status, Status::finished) << found.reason;
  EXPECT_EQ(found.reason, "");
  ASSERT_GT(value_of(found, "contact/heads/impacts"), 0);
  const std::vector<double> &state = field_of(found, "state").values;
  for (const auto &[key, value] : keys) {
    const double h = 5e-4 * value;
    const PointResult far = neighbour(of, keys, key, h, state),
                      behind = neighbour(of, keys, key, -h, state),
                      near = neighbour(of, keys, key, h / 2, state),
                      before = neighbour(of, keys, key, -h / 2, state);
    for (const Field &field : found.fields) {
      const std::string prefix = "derivative/" + key + "/";
      if (!field.name().starts_with(prefix) || !field.shape.empty())
        continue;
      const std::string name = field.name().substr(prefix.size());
      if (name == "smooth" || name == "value")
        continue;
      if (of.steep && name.starts_with("point/block.head/acceleration"))
        continue; // steps do not resolve it, and differences less so
      const double coarse = (value_of(far, name) - value_of(behind, name)) / (2 * h);
      const double fine = (value_of(near, name) - value_of(before, name)) / h;
      // Derivatives by the frequency, differences by omega.
      const double unit = key == "omega" ? 2 * std::numbers::pi : 1;
      const double exact = (4 * fine - coarse) / 3 * unit;
      const double size = std::abs(exact) + 0.01 * std::abs(value_of(found, name) / value);
      const double noise = 1e-11 / h * unit;
      EXPECT_NEAR(field.values[0], exact, 1e-6 * size + noise) << field.name();
    }
  }
}

// None of them is left to differences of motions.
TEST(OrbitMeasuresTest, all_extreme_values_and_impacts_are_known_in_closed_form) {
  const Case of{.name = "bilinear stop",
                .law = [](double k) { return std::make_shared<contact::BilinearStop>(k, 20); },
                .constant = 4000};
  const Keys keys = keys_of(of);
  const System system = system_of(of, keys);
  const SweptParameter clearance{.path = "clearance", .unit = "1", .values = {of.clearance}};
  const auto neighbours = [&] {
    return key_neighbours(clearance, of.clearance,
                          [&](const std::vector<parameters::Override> &overrides) {
                            Keys changed = keys;
                            changed["clearance"] = std::stod(overrides[0].value);
                            return system_of(of, changed);
                          });
  };
  OrbitSearch search(system, 0, settled);
  const periodic::Orbit orbit = search.run();
  periodic::ForcedKey key = periodic::forced_key("clearance", search.forced(), neighbours());
  const std::vector<RecorderFactory> recorders = default_recorders();
  const auto tangents = measure_tangents(
      {.system = system, .map = search.map(), .orbit = orbit, .recorders = recorders}, key,
      neighbours(), Vector::Zero(search.map().size()));
  const PointResult found = measures_of(of, keys, orbit);
  for (const Field &field : found.fields)
    EXPECT_TRUE(field.unit() == "1" || find(tangents, field.name()) != nullptr) << field.name();
}

// Tsuji's force begins and ends with an infinite rate, of which no more than the force is recorded.
TEST(OrbitMeasuresTest, AccelerationsBesideASteepForce) {
  const Case of{.name = "Tsuji",
                .law = [](double k) { return std::make_shared<contact::Tsuji>(k, 40); },
                .constant = 4e4};
  const PointResult found = orbit(of, keys_of(of), settled, {"amplitude"});
  const double force = value_of(found, "contact/heads/peak_force/maximum"); // of a mass of 1 kg
  const double others = 40 * 0.3 + 0.8 * 1.5 + 3; // spring, dashpot, excitation at most
  const std::string name = "point/block.head/acceleration_x/";
  EXPECT_LT(value_of(found, name + "maximum"), force + others);
  EXPECT_GT(value_of(found, name + "minimum"), -force - others);
  EXPECT_TRUE(std::isfinite(value_of(found, "derivative/amplitude/contact/heads/impulse/mean")));
}

// A constant: Kelvin-Voigt pulls before the overlap ends; a large one has its largest force at
// once.
INSTANTIATE_TEST_SUITE_P(
    EveryLaw, OrbitMeasuresTable,
    ::testing::Values(
        Case{"linear penalty", [](double k) { return std::make_shared<contact::LinearPenalty>(k); },
             4000},
        Case{"Kelvin-Voigt", [](double k) { return std::make_shared<contact::KelvinVoigt>(k, 20); },
             4000},
        Case{"Kelvin-Voigt, largest force at first touch",
             [](double k) { return std::make_shared<contact::KelvinVoigt>(k, 150); }, 4000},
        Case{"Kelvin-Voigt bumper",
             [](double k) { return std::make_shared<contact::KelvinVoigtBumper>(k, 60); }, 4000},
        Case{"bilinear stop",
             [](double k) { return std::make_shared<contact::BilinearStop>(k, 20); }, 4000},
        Case{"bilinear stop, shaken",
             [](double k) { return std::make_shared<contact::BilinearStop>(k, 20); }, 4000, true},
        Case{"Hertz",
             [](double k) {
               return std::make_shared<contact::Hertz>(contact::HertzConstants{.stiffness = k});
             },
             4e4},
        Case{"Hertz, shaken",
             [](double k) {
               return std::make_shared<contact::Hertz>(contact::HertzConstants{.stiffness = k});
             },
             4e4, true},
        Case{"Hunt-Crossley",
             [](double k) {
               return contact::HuntCrossley::with_dimensionless_damping(
                   {.stiffness = k, .exponent = 1.5}, 0.4, 1e-9);
             },
             4e4},
        Case{"Kuwabara-Kono",
             [](double k) { return std::make_shared<contact::KuwabaraKono>(k, 1e-3); }, 4e4, false,
             40, 0.1, 5, true},
        Case{"Tsuji", [](double k) { return std::make_shared<contact::Tsuji>(k, 40); }, 4e4, false,
             40, 0.1, 5, true},
        Case{"Newton's restitution", [](double e) { return testing::newton(e); }, 0.7},
        Case{"Newton's restitution, shaken", [](double e) { return testing::newton(e); }, 0.7,
             true},
        Case{"rest after chatter", [](double e) { return testing::newton(e); }, 0.3, false, 40,
             0.01, 1.5}));

} // namespace orbit_measures_tests
} // namespace vibroimpact::analyses
