// Cost of many contacts at once: a plate of 40 modes that is shaken on 250 to 2000 stops, with the
// impacts recorded or not, beside Runge-Kutta steps. A plate that rubs has spring-sliders along one
// edge, its surface moving by half the thickness times the slope.
//
//   benchmark_many_contacts [pairs [linear | Hertz | rubs [moments | rk]]]
//
// Times are those of the processor. Memory is the most that the process has used so far, so that
// sizes ascend and Runge-Kutta steps come last. Exit code 1 when an energy balance does not close.
#include "contact/friction/frictional_law.h"
#include "contact/friction/spring_slider.h"
#include "contact/laws/hertz.h"
#include "contact/laws/linear_penalty.h"
#include "motion/event/impact_log.h"
#include "motion/path/trajectory.h"
#include "petsc_session.h"
#include "vibroimpact_side.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <map>
#include <numbers>
#include <optional>
#include <string>

namespace vibroimpact::benchmarks {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int modes_along = 8, modes_across = 5;
constexpr double lowest = 2 * pi * 12;                          // [rad/s]
constexpr double forcing = 2 * pi * 16, force = 40;             // [rad/s], [N]
constexpr double clearance = 1e-4, differences = 1e-4;          // [m]
constexpr double linear_stiffness = 4e6, hertz_stiffness = 4e8; // of all stops
constexpr double half_thickness = 2e-3, length = 0.6;           // [m]
constexpr double sliding_stiffness = 2e6, friction = 0.3;       // of all stops
constexpr double tolerance = 1e-8, most_residual = 1e-6;
constexpr long settling = 2, periods = 2;

double shape(int i, int j, double x, double y) {
  const auto along = [](int k, double z) {
    return k == 0 ? 1 : std::sqrt(2.0) * std::cos(k * pi * z);
  };
  return along(i, x) * along(j, y);
}

// By the place along the edge [1/m].
double slope(int i, int j, double x, double y) {
  return i == 0 ? 0 : -i * pi / length * std::sqrt(2.0) * std::sin(i * pi * x) * shape(0, j, x, y);
}

enum class Law { linear, hertz, rubs };
constexpr Law laws[] = {Law::linear, Law::hertz, Law::rubs};
const char *name_of(Law law) {
  return law == Law::linear ? "linear" : law == Law::hertz ? "Hertz" : "rubs";
}

std::shared_ptr<const contact::ContactLaw> law_of(Law law, int stops) {
  if (law == Law::hertz)
    return std::make_shared<contact::Hertz>(
        contact::HertzConstants{.stiffness = hertz_stiffness / stops});
  auto linear = std::make_shared<contact::LinearPenalty>(linear_stiffness / stops);
  if (law == Law::linear)
    return linear;
  return std::make_shared<contact::FrictionalLaw>(
      linear, std::make_shared<contact::SpringSlider>(sliding_stiffness / stops, friction, 0.0));
}

// Cosines in both directions with guided edges; the plate moves on soft springs.
Problem plate_on_stops(int stops, Law kind) {
  const Index n = modes_along * modes_across;
  Vector squares(n), damping(n), load(n);
  const auto each = [](auto &&visit) {
    for (int i = 0; i < modes_along; ++i)
      for (int j = 0; j < modes_across; ++j)
        visit(modes_across * i + j, i, j);
  };
  each([&](Index k, int i, int j) {
    const double omega = lowest * (1 + i * i + j * j);
    squares[k] = omega * omega;
    damping[k] = 2 * 0.02 * omega;
    load[k] = shape(i, j, 0.37, 0.41);
  });
  Problem problem{
      .model = model::Model({body_along_x("plate", Vector::Ones(n), squares, damping, load)}),
      .contacts = {},
      .recorded = {}};
  problem.model.add_force(
      "shaker", std::make_shared<model::Harmonic>(model::Given::displacement, force, forcing, 0),
      {.body = 0, .point = 0}, Vector3::UnitX());
  const std::shared_ptr<const contact::ContactLaw> law = law_of(kind, stops);
  std::vector<contact::ContactPair> pairs;
  for (int c = 0; c < stops; ++c) {
    // Points that fill the plate evenly (a lattice of Korobov's), clearances likewise.
    const double x = (c + 0.5) / stops, y = std::fmod(0.618033988749895 * c, 1);
    pairs.push_back(contact_of_heads(problem.model, "plate", "", 1,
                                     clearance + differences * std::fmod(0.7548776662466927 * c, 1),
                                     law));
    pairs.back().name += " " + std::to_string(c);
    each([&](Index k, int i, int j) { pairs.back().gap.row[k] = -shape(i, j, x, y); });
    if (kind != Law::rubs)
      continue;
    pairs.back().tangential.push_back({.slip = pairs.back().gap});
    each([&](Index k, int i, int j) {
      pairs.back().tangential[0].slip.row[k] = half_thickness * slope(i, j, x, y);
    });
  }
  problem.contacts = contact::ContactSet(std::move(pairs));
  problem.end = (settling + periods) * 2 * pi / forcing;
  return problem;
}

double megabytes() {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
    if (word == "VmHWM:") {
      double kilobytes = 0;
      status >> kilobytes;
      return kilobytes / 1024;
    }
  return 0;
}

struct Cost {
  double seconds = 0;
  long changes = 0, steps = 0;
  double residual = 0;
};

Cost measure(const Problem &problem, const std::string &method, bool records) {
  motion::Settings settings;
  settings.method = method;
  settings.relative_tolerance = tolerance;
  motion::Trajectory trajectory(problem.model, problem.contacts, settings);
  const Index n = problem.model.size();
  trajectory.start(0, Vector::Zero(n), Vector::Zero(n));
  const double begin = settling * 2 * pi / forcing;
  trajectory.advance(begin);
  const motion::Accuracy before = trajectory.accuracy();
  motion::ImpactLog log(problem.contacts, 0);
  const std::clock_t started = std::clock();
  if (records)
    trajectory.advance(problem.end, log);
  else
    trajectory.advance(problem.end);
  const motion::Accuracy after = trajectory.accuracy();
  return {.seconds = static_cast<double>(std::clock() - started) / CLOCKS_PER_SEC,
          .changes = after.events - before.events,
          .steps = after.steps - before.steps,
          .residual = records ? after.energy_residual : 0};
}

void print_head() {
  std::printf("%6s %-7s %-8s %-8s %10s %9s %11s %10s %9s %9s %8s\n", "pairs", "law", "method",
              "records", "ms/period", "changes", "us/change", "steps", "residual", "exponent",
              "MB");
}

struct Case {
  int pairs = 0;
  Law law = Law::linear;
  std::string method;
};

// The exponent is that of the time in the number of pairs, from the size before.
bool run(const Case &of, std::map<std::string, std::pair<int, double>> &before) {
  const Problem problem = plate_on_stops(of.pairs, of.law);
  bool closes = true;
  for (const bool records : {false, true}) {
    const Cost cost = measure(problem, of.method, records);
    const double per_period = 1e3 * cost.seconds / periods;
    const std::string key = of.method + name_of(of.law) + (records ? "r" : "-");
    std::string exponent = "-";
    if (const auto known = before.find(key); known != before.end())
      exponent = std::to_string(std::log(per_period / known->second.second) /
                                std::log(static_cast<double>(of.pairs) / known->second.first))
                     .substr(0, 4);
    before[key] = {of.pairs, per_period};
    std::printf("%6d %-7s %-8s %-8s %10.1f %9.0f %11.1f %10.0f %9.1e %9s %8.0f\n", of.pairs,
                name_of(of.law), of.method.c_str(), records ? "impacts" : "none", per_period,
                static_cast<double>(cost.changes) / periods,
                1e6 * cost.seconds / static_cast<double>(cost.changes),
                static_cast<double>(cost.steps) / periods, cost.residual, exponent.c_str(),
                megabytes());
    std::fflush(stdout);
    closes = closes && cost.residual < most_residual;
  }
  return closes;
}

} // namespace

bool run(int pairs, const std::string &law, const std::string &method) {
  print_head();
  std::map<std::string, std::pair<int, double>> before;
  bool closes = true;
  for (const std::string &by : {std::string("moments"), std::string("rk")})
    for (const Law kind : laws)
      for (const int count : {250, 500, 1000, 2000}) {
        const bool wanted = (pairs == 0 ? by == "moments" || count == 250 : count == pairs) &&
                            (law.empty() || law == name_of(kind)) &&
                            (method.empty() || method == by);
        if (wanted)
          closes = run({.pairs = count, .law = kind, .method = by}, before) && closes;
      }
  return closes;
}

} // namespace vibroimpact::benchmarks

int main(int argc, char **argv) {
  const auto argument = [&](int i) { return std::string(argc > i ? argv[i] : ""); };
  try {
    const vibroimpact::benchmarks::PetscSession petsc("benchmark_many_contacts");
    const int pairs = argc > 1 ? std::atoi(argv[1]) : 0;
    return vibroimpact::benchmarks::run(pairs, argument(2), argument(3)) ? 0 : 1;
  } catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
