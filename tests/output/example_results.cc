#include "output/example_results.h"

#include <cmath>
#include <string>

namespace vibroimpact::testing {

namespace {

using reduction::Recovery;
using reduction::ReducedBody;

constexpr double pi = 3.14159265358979323846;

/// Bending shape of a clamped-free beam, 1 at the end, at s in 0..1, and its slope.
std::pair<double, double> cantilever_shape(double root, double s) {
  const double ratio = (std::cosh(root) + std::cos(root)) / (std::sinh(root) + std::sin(root));
  const double x = root * s;
  const double value = std::cosh(x) - std::cos(x) - ratio * (std::sinh(x) - std::sin(x));
  const double slope = root * (std::sinh(x) + std::sin(x) - ratio * (std::cosh(x) - std::cos(x)));
  const double end = std::cosh(root) - std::cos(root) - ratio * (std::sinh(root) - std::sin(root));
  return {value / end, slope / end};
}

Recovery cantilever_recovery(double x) {
  constexpr Index nodes = 13;
  constexpr double length = 0.3;
  const std::array roots = {1.8751040687, 4.6940911330, 7.8547574382};
  Recovery recovery;
  recovery.nodes = Matrix::Zero(3, nodes);
  recovery.shapes = Matrix::Zero(6 * nodes, static_cast<Index>(roots.size()));
  for (Index i = 0; i < nodes; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(nodes - 1);
    recovery.nodes.col(i) = Vector3(x, 0, s * length);
    for (std::size_t mode = 0; mode < roots.size(); ++mode) {
      const auto [value, slope] = cantilever_shape(roots[mode], s);
      recovery.shapes(6 * i, static_cast<Index>(mode)) = 4 * value;
      recovery.shapes(6 * i + 4, static_cast<Index>(mode)) = 4 * slope / length;
    }
    if (i > 0)
      recovery.lines.push_back({static_cast<int>(i) - 1, static_cast<int>(i)});
  }
  return recovery;
}

ReducedBody cantilever(const std::string &name, double x, double frequency) {
  ReducedBody body;
  body.name = name;
  body.type = "beam";
  body.mass = Vector::Ones(3);
  body.stiffness = Vector3(1, 39.3, 308).eval() * std::pow(2 * pi * frequency, 2);
  body.damping = Vector(0.02 * body.stiffness.cwiseSqrt()).asDiagonal();
  body.base_participation = Matrix::Zero(3, 3);
  body.base_participation.col(0) = Vector3(0.24, 0.12, 0.06);
  body.recovery = cantilever_recovery(x);
  body.points = {{"head", body.recovery.nodes.col(12), body.recovery.shapes.bottomRows(6)}};
  body.total_mass = Vector3::Constant(0.08);
  body.eigen_residual = Vector::Constant(3, 1e-12);
  body.orthogonality_residual = 1e-13;
  return body;
}

ReducedBody damper() {
  ReducedBody body;
  body.name = "damper";
  body.type = "lumped";
  body.mass = Vector::Constant(1, 0.5);
  body.stiffness = Vector::Constant(1, 200);
  body.damping = Matrix::Constant(1, 1, 0.4);
  body.base_participation = Matrix::Zero(1, 3);
  body.base_participation(0, 0) = 0.5;
  Matrix rows = Matrix::Zero(6, 1);
  rows(0, 0) = 1;
  body.points = {{"mass", Vector3(0.05, 0, 0.1), rows}};
  body.total_mass = Vector3(0.5, 0, 0);
  return body;
}

Field history(const std::string &name, const std::string &unit, const std::string &dimension,
              std::vector<double> values) {
  const std::size_t size = values.size();
  return {Label(name, unit, name, {dimension}), {size}, std::move(values)};
}

Field scalar(const std::string &name, const std::string &unit, double value) {
  return {Label(name, unit, name), {}, {value}};
}

struct Impact {
  double start = 0, duration = 0, approach_speed = 0, peak_force = 0, impulse = 0, penetration = 0,
         separation_speed = 0, peak_time = 0;
};

struct Collision {
  std::vector<double> time, force, gap, left, right, left_velocity, right_velocity;
  std::vector<Impact> impacts;

  void keep(double t, double contact_force, const std::array<double, 4> &state, double open_gap) {
    time.push_back(t);
    force.push_back(contact_force);
    gap.push_back(open_gap);
    left.push_back(state[0]);
    right.push_back(state[1]);
    left_velocity.push_back(state[2]);
    right_velocity.push_back(state[3]);
  }
};

/// One time step of a contact, for the table of impacts.
void follow_impact(double t, double step, double gap, double rate, double force, bool &touching,
                   std::vector<Impact> &impacts) {
  if (gap < 0 && !touching)
    impacts.push_back({t, 0, rate});
  touching = gap < 0;
  if (!touching)
    return;
  Impact &impact = impacts.back();
  impact.duration = t - impact.start;
  if (force > impact.peak_force)
    impact.peak_time = t;
  impact.peak_force = std::max(impact.peak_force, force);
  impact.impulse += step * force;
  impact.penetration = std::max(impact.penetration, -gap);
  impact.separation_speed = -rate;
}

/// Two masses of 58 g on springs, 5 mm apart, the left one let go at 20 mm, with a Hertz contact
/// with damping: semi-implicit Euler, fine enough for a picture.
Collision collide(double end, double step, double from, double kept_interval) {
  constexpr double clearance = 5e-3, mass = 0.0577, stiffness = 1e9, damping_factor = 8e8;
  const double square_frequency = std::pow(2 * pi * 2.95, 2);
  std::array<double, 4> state = {-0.02, 0, 0, 0};
  Collision result;
  double next = from;
  bool touching = false;
  for (double t = 0; t <= end; t += step) {
    const double gap = clearance + state[1] - state[0];
    const double penetration = std::max(0.0, -gap);
    const double rate = state[2] - state[3];
    const double force =
        std::max(0.0, std::pow(penetration, 1.5) * (stiffness + damping_factor * rate));
    follow_impact(t, step, gap, rate, force, touching, result.impacts);
    if (t >= next) {
      result.keep(t, force, state, gap);
      next += kept_interval;
    }
    state[2] -= step * (square_frequency * state[0] + 0.2 * state[2] + force / mass);
    state[3] -= step * (square_frequency * 1.1 * state[1] + 0.2 * state[3] - force / mass);
    state[0] += step * state[2];
    state[1] += step * state[3];
  }
  return result;
}

void add_histories(const Collision &collision, PointResult &point) {
  point.fields.push_back(history("time", "s", "time", collision.time));
  const auto add = [&](const std::string &name, const std::string &unit,
                       const std::vector<double> &values) {
    point.fields.push_back(history(name, unit, "time", values));
  };
  add("contact/heads/normal_force", "N", collision.force);
  add("contact/heads/gap", "m", collision.gap);
  add("point/left.head/displacement_x", "m", collision.left);
  add("point/left.head/velocity_x", "m/s", collision.left_velocity);
  add("point/right.head/displacement_x", "m", collision.right);
  add("point/right.head/velocity_x", "m/s", collision.right_velocity);
}

void add_impacts(const std::vector<Impact> &impacts, PointResult &point) {
  const auto add = [&](const std::string &name, const std::string &unit, const auto &value) {
    std::vector<double> values;
    for (const Impact &impact : impacts)
      values.push_back(value(impact));
    point.fields.push_back(
        history("contact/heads/impact/" + name, unit, "impact_heads", std::move(values)));
  };
  add("time", "s", [](const Impact &impact) { return impact.start; });
  add("duration", "s", [](const Impact &impact) { return impact.duration; });
  add("approach_speed", "m/s", [](const Impact &impact) { return impact.approach_speed; });
  add("peak_force", "N", [](const Impact &impact) { return impact.peak_force; });
  add("peak_time", "s", [](const Impact &impact) { return impact.peak_time; });
  add("impulse", "N s", [](const Impact &impact) { return impact.impulse; });
  add("maximum_penetration", "m", [](const Impact &impact) { return impact.penetration; });
  add("separation_speed", "m/s", [](const Impact &impact) { return impact.separation_speed; });
  add("restitution_coefficient", "1",
      [](const Impact &impact) { return impact.separation_speed / impact.approach_speed; });
}

/// Force and gap of every impact at times of its own; NaN separates impacts.
void add_pulses(const std::vector<Impact> &impacts, PointResult &point) {
  constexpr int samples = 50;
  std::vector<double> time, force, gap;
  for (const Impact &impact : impacts) {
    for (int i = 0; i <= samples; ++i) {
      const double part = std::sin(pi * i / samples);
      time.push_back(impact.start + impact.duration * i / samples);
      force.push_back(impact.peak_force * std::pow(part, 1.5));
      gap.push_back(-impact.penetration * part);
    }
    for (std::vector<double> *values : {&time, &force, &gap})
      values->push_back(std::nan(""));
  }
  point.fields.push_back(history("contact/heads/pulse/time", "s", "pulse_heads", time));
  point.fields.push_back(history("contact/heads/pulse/normal_force", "N", "pulse_heads", force));
  point.fields.push_back(history("contact/heads/pulse/gap", "m", "pulse_heads", gap));
}

/// A field with a coordinate in its own group.
void add_fit(PointResult &point) {
  point.fields.push_back(history("fit/ratio_axis", "1", "ratio_axis", {1, 2, 3}));
  point.fields.push_back(history("fit/exact/restitution", "1", "ratio_axis", {0.9, 0.8, 0.7}));
}

Motion example_motion() {
  Motion motion;
  motion.time = {0, 0.01, 0.02};
  for (const ReducedBody &body : example_bodies()) {
    motion.coordinates.push_back(Matrix::Zero(3, body.size()));
    motion.coordinates.back().col(0) = 1e-3 * Vector3(0, 1, 2);
    motion.base_displacement.push_back(Matrix::Zero(3, 3));
    motion.base_displacement.back().col(1) = Vector3(0, 0.5, 1);
  }
  return motion;
}

/// Largest amplitude branch of a hardening resonance, or the smallest on the way up beyond the
/// fold.
double resonance(double frequency, bool forward, double clearance) {
  const double backbone = 2.95 + 1.2 * std::exp(-clearance / 6e-3);
  const double fold = forward ? backbone : 2.95 + 0.4 * (backbone - 2.95);
  const double off = (frequency - 2.95) / (frequency < fold ? 3.2 : 0.9);
  return 0.5 * clearance + 4e-3 / std::sqrt(std::pow(off, 2) + 0.05);
}

PointResult sweep_point(double frequency, bool forward, double clearance,
                        std::vector<std::size_t> index) {
  const double amplitude = resonance(frequency, forward, clearance);
  const double penetration = std::max(0.0, amplitude - 1.6 * clearance);
  PointResult point;
  point.index = std::move(index);
  const double omega = 2 * pi * frequency;
  for (const auto &[body, factor] : {std::pair("left.head", 1.0), std::pair("right.head", 0.7)}) {
    const std::string name = std::string("point/") + body + "/";
    point.fields.push_back(
        scalar(name + "displacement_x/peak_to_peak", "m", 2 * factor * amplitude));
    point.fields.push_back(scalar(name + "displacement_x/largest", "m", factor * amplitude));
    point.fields.push_back(scalar(name + "acceleration_x/peak_to_peak", "m/s^2",
                                  2 * factor * amplitude * omega * omega + 3e4 * penetration));
  }
  point.fields.push_back(
      scalar("contact/heads/normal_force/maximum", "N", 1e6 * std::pow(penetration, 1.5)));
  point.fields.push_back(scalar("contact/heads/gap/minimum", "m", -penetration));
  point.fields.push_back(
      scalar("contact/heads/impacts_per_period", "1", penetration > 0 ? 1.0 : 0.0));
  point.fields.push_back(scalar("steady", "1", frequency > 3.3 && frequency < 3.4 ? 0 : 1));
  point.fields.push_back(
      {Label("state", "1", "state at the end", {"state"}), {2}, {amplitude, omega}});
  point.summary = {{Label("left.head.displacement_x.peak_to_peak", "m", ""), 2 * amplitude}};
  return point;
}

AnalysisHeader sweep_header(const std::string &name, std::size_t steps) {
  Axis frequency{"frequency", {}, {}, "Hz", "forcing frequency"};
  for (std::size_t i = 0; i < steps; ++i)
    frequency.values.push_back(1 + 5 * static_cast<double>(i) / static_cast<double>(steps - 1));
  return {name,
          "stepped sweep",
          {frequency, {"direction", {}, {"forward", "backward"}, "1", "direction of the sweep"}}};
}

} // namespace

std::vector<ReducedBody> example_bodies() {
  return {cantilever("left", 0, 2.95), cantilever("right", 0.02, 3.1), damper()};
}

Example modal_example() { return {{"modes", "modal", {}}, {PointResult{}}}; }

Example transient_example() {
  PointResult point;
  const Collision collision = collide(0.8, 2e-6, 0, 2e-4);
  add_histories(collision, point);
  add_impacts(collision.impacts, point);
  add_pulses(collision.impacts, point);
  add_fit(point);
  point.fields.push_back(scalar("energy_residual", "1", 1e-9));
  point.fields.push_back(scalar("steps", "1", 17));
  point.summary = {
      {Label("contact.heads.impacts", "1", ""), static_cast<double>(collision.impacts.size())},
      {Label("/release.peak_force", "N", ""), 45.25}};
  point.motion = {example_motion()};
  return {{"release", "transient", {}}, {point}};
}

Example sweep_example() {
  Example example{sweep_header("response", 61), {}};
  for (std::size_t i = 0; i < 61; ++i)
    for (std::size_t direction = 0; direction < 2; ++direction)
      example.points.push_back(
          sweep_point(example.header.axes[0].values[i], direction == 0, 5e-3, {i, direction}));
  PointResult &failed = example.points[1];
  failed = {failed.index, Status::failed, "more than 1000 impacts in one period", {}, {}, {}};
  return example;
}

Example grid_example() {
  const std::vector<double> clearances = {3e-3, 5e-3, 9e-3};
  Example example{sweep_header("map", 31), {}};
  example.header.grid = {"Contact/heads/Clearance"};
  example.header.axes.insert(example.header.axes.begin(),
                             {"Contact/heads/Clearance", clearances, {}, "m", "clearance"});
  for (std::size_t c = 0; c < clearances.size(); ++c)
    for (std::size_t i = 0; i < 31; ++i)
      for (std::size_t direction = 0; direction < 2; ++direction)
        example.points.push_back(sweep_point(example.header.axes[1].values[i], direction == 0,
                                             clearances[c], {c, i, direction}));
  return example;
}

std::vector<Example> all_examples() {
  return {modal_example(), transient_example(), sweep_example(), grid_example()};
}

output::RunInformation example_information() {
  return {"0.1.0",
          "abc1234",
          "set Title = example\n",
          "vibroimpact example.prm",
          {"deal.II 9.4.1", "HDF5 1.10.8"},
          1,
          "a processor"};
}

} // namespace vibroimpact::testing
