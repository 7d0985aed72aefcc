#include "analyses/cost.h"

#include "integration/equations.h"

#include <chrono>
#include <cmath>
#include <numbers>
#include <sstream>

namespace vibroimpact {

namespace {

// Seconds that one evaluation of the equations takes here and now.
double evaluation_time(const System &system) {
  const Equations equations(system.model, system.contacts);
  const Vector x = Vector::Zero(equations.layout().size());
  Vector rates(x.size());
  constexpr int repetitions = 2000;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < repetitions; ++i)
    equations.rates(1e-6 * i, ConstVectorView(x.data(), x.size()),
                    VectorView(rates.data(), rates.size()));
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count() / repetitions;
}

// A fifth-order method advances about 3 tolerance^(1/5) radians of the highest frequency per step.
double steps_per_second(const System &system) {
  const double radians = 3 * std::pow(system.integration.relative_tolerance, 0.2);
  return system.model.highest_frequency() / radians;
}

} // namespace

std::string cost_sentence(const Analysis &analysis, const System &system, std::size_t repetitions) {
  const Workload work = analysis.workload(system);
  const auto lines = static_cast<double>(analysis.lines() * repetitions);
  // Eight evaluations in a step and as much again around them.
  const double seconds =
      lines * work.simulated_time * steps_per_second(system) * 16 * evaluation_time(system);
  std::ostringstream text;
  text.precision(3);
  text << system.model.size() << " coordinates, " << lines * static_cast<double>(work.points)
       << " points, at most " << lines * work.simulated_time << " s of motion, about " << seconds
       << " s of computing on one core if nothing settles early";
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
