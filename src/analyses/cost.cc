#include "analyses/cost.h"

#include "common/error.h"
#include "integration/trajectory.h"

#include <algorithm>
#include <chrono>
#include <numbers>
#include <sstream>

namespace vibroimpact {

namespace {

// Seconds of the motion from the initial conditions that are integrated in a second, here and now.
// Models without frequencies of their own are tried for parts of the time that is wanted.
double motion_per_second(const System &system, double wanted) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::duration<double> enough(0.05);
  const double highest = std::max(system.model.highest_frequency(), 1e-3);
  const double stretch = std::min(2 * std::numbers::pi / highest, wanted / 1000);
  Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  const Clock::time_point start = Clock::now();
  std::chrono::duration<double> elapsed{};
  for (int i = 1; elapsed < enough && i <= 5000; ++i) {
    trajectory.advance(i * stretch);
    elapsed = Clock::now() - start;
  }
  return trajectory.time() / elapsed.count();
}

} // namespace

std::string cost_sentence(const Analysis &analysis, const System &system, std::size_t repetitions) {
  const Workload work = analysis.workload(system);
  const auto lines = static_cast<double>(analysis.lines() * repetitions);
  std::ostringstream text;
  text.precision(3);
  text << system.model.size() << " coordinates, " << lines * static_cast<double>(work.points)
       << " points, at most " << lines * work.simulated_time << " s of motion, ";
  if (!(work.simulated_time > 0)) {
    text << "nothing to integrate";
    return text.str();
  }
  try {
    text << "about " << lines * work.simulated_time / motion_per_second(system, work.simulated_time)
         << " s of computing on one core if nothing settles early";
  } catch (const NumericalError &error) {
    text << "of which no estimate can be made: " << error.what();
  }
  return text.str();
}

std::string body_sentence(const ReducedBody &body) {
  const Vector frequency = body.omega() / (2 * std::numbers::pi);
  std::ostringstream text;
  text.precision(6);
  text << body.size() << (body.modal() ? " modes from " : " coordinates from ")
       << frequency.minCoeff() << " Hz to " << frequency.maxCoeff() << " Hz, " << body.points.size()
       << " points";
  return text.str();
}

} // namespace vibroimpact
