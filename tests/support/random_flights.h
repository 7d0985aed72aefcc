// Random linear systems between two stops, and start states from which they graze a stop.
#pragma once

#include "support/true_motion.h"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace vibroimpact::testing {

struct RandomSystem {
  std::vector<TrueMode> modes;
  TrueForce force;
  double right = 0, left = 0; ///< clearances of the stops [m]
  double period = 0;          ///< of the slowest mode [s]
};

struct RandomFlight {
  std::vector<double> displacement, velocity; ///< at time 0
  double end = 0;                             ///< [s]
};

/// What a flight is made for.
enum class Touch { anywhere, near_start, inflection, departure };

class FlightGenerator {
public:
  explicit FlightGenerator(std::uint64_t seed) : random_(seed) {}

  /// One to six modes, undamped to overdamped, close and far frequencies. With `safe_path`, modes
  /// that eigenvectors do not describe: critical damping, free masses, resonance.
  RandomSystem system(bool safe_path) {
    RandomSystem system;
    const int count = 1 + static_cast<int>(uniform(0, 6));
    const double first = std::exp(uniform(0, 5));
    const double clearance = std::pow(10, uniform(-4, 0));
    system.right = clearance;
    system.left = clearance * uniform(0.5, 2);
    system.period = 2 * std::numbers::pi / first;
    const double damping = chance(0.4) ? 0 : std::pow(10, uniform(-4, -0.5));
    for (int j = 0; j < count; ++j)
      system.modes.push_back(mode(j == 0 ? first : frequency(first), damping));
    if (!chance(0.15))
      system.force = force(system, first);
    if (safe_path)
      make_defective(system);
    return system;
  }

  /// A flight that comes near a stop at one instant, by 1e-16 ... 1e-1 of the clearance, and begins
  /// between the stops.
  RandomFlight flight(const RandomSystem &system, Touch touch) {
    RandomFlight flight = attempt(system, touch);
    // Where the steady motion alone is beyond a stop only short flights are possible.
    for (int i = 0; !begins_between(system, flight); ++i)
      flight = attempt(system, i < 20 ? touch : Touch::near_start);
    return flight;
  }

private:
  RandomFlight attempt(const RandomSystem &system, Touch touch) {
    const double instant = touch == Touch::departure    ? 0
                           : touch == Touch::near_start ? system.period * power(-9, -2)
                                                        : system.period * uniform(0.02, 1.2);
    const int side = chance(0.5) ? 1 : -1;
    const double clearance = side > 0 ? system.right : system.left;
    const double depth = touch == Touch::departure ? 0 : signed_power(-16, -1);
    std::vector<double> q = displacements(system, side * clearance * (1 + depth));
    std::vector<double> v = velocities(system);
    settle_damped(system, instant, q, v);
    const double speed = 2 * std::numbers::pi * clearance / system.period;
    double rate = 0;
    if (touch == Touch::departure)
      rate = -side * speed * power(-9, -1);
    else if (touch == Touch::inflection || chance(0.2))
      rate = side * speed * signed_power(-16, -2);
    aim(system, instant, side * clearance * (1 + depth), rate, q, v);
    if (touch == Touch::inflection)
      straighten(system, instant, signed_power(-16, -2) * speed / system.period, q);
    const double end = instant + uniform(0.05, 0.6) * system.period;
    return back_to_start(system, instant, q, v, end);
  }

  // On a stop, as far as rounding can tell, counts as between.
  static bool begins_between(const RandomSystem &system, const RandomFlight &flight) {
    long double displacement = 0;
    long double size = 0;
    for (std::size_t j = 0; j < flight.displacement.size(); ++j) {
      const long double part =
          static_cast<long double>(system.modes[j].weight) * flight.displacement[j];
      displacement += part;
      size += std::abs(part);
    }
    const long double rounding = 4 * std::numeric_limits<double>::epsilon() * size;
    return displacement <= system.right + rounding && -displacement <= system.left + rounding;
  }

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  double power(double low, double high) { return std::pow(10, uniform(low, high)); }
  double signed_power(double low, double high) { return (chance(0.5) ? 1 : -1) * power(low, high); }
  double normal() { return std::normal_distribution<double>()(random_); }

  double frequency(double first) {
    return first * (chance(0.3) ? 1 + power(-7, -1) : std::exp(uniform(0, std::log(30.0))));
  }

  TrueMode mode(double omega, double damping_ratio) {
    const double ratio = damping_ratio > 0 && chance(0.1) ? uniform(1.2, 3) : damping_ratio;
    return {.stiffness = omega * omega,
            .damping = 2 * ratio * omega,
            .load = normal(),
            .weight = normal() + (chance(0.5) ? 1 : -1) * 0.1};
  }

  // A tenth to twice the clearance by its steady response; no undamped mode within 2 % of it.
  TrueForce force(const RandomSystem &system, double first) {
    TrueForce force{.amplitude = 1, .frequency = 1, .phase = uniform(-3, 3)};
    bool resonant = true;
    while (resonant) {
      force.frequency = first * std::exp(uniform(-1, 2));
      resonant = false;
      for (const TrueMode &mode : system.modes)
        resonant |= std::abs(std::sqrt(mode.stiffness) / force.frequency - 1) < 0.02;
    }
    double response = 0;
    for (const TrueMode &mode : system.modes)
      response += std::abs(mode.load * mode.weight) /
                  std::hypot(mode.stiffness - force.frequency * force.frequency,
                             mode.damping * force.frequency);
    force.amplitude = system.right * uniform(0.1, 2) / response;
    return force;
  }

  // Frequencies that are squared without rounding, so that the closed form is in the same case.
  void make_defective(RandomSystem &system) {
    const double omega = std::round(8 * 2 * std::numbers::pi / system.period) / 8 + 0.125;
    TrueMode &mode = system.modes[0];
    const int kind = static_cast<int>(uniform(0, 3));
    mode.stiffness = kind == 0 ? 0 : omega * omega;
    mode.damping = kind == 1 ? 2 * omega : 0;
    if (kind == 2) {
      system.force = {
          .amplitude = system.right * omega * omega, .frequency = omega, .phase = uniform(-3, 3)};
    }
  }

  std::vector<double> displacements(const RandomSystem &system, double size) {
    std::vector<double> q;
    const double range = power(-1, 0.3);
    for (const TrueMode &mode : system.modes)
      q.push_back(range * size * normal() / (1 + std::abs(mode.weight)));
    return q;
  }

  std::vector<double> velocities(const RandomSystem &system) {
    std::vector<double> v;
    const double range = power(-1, 0.3) * system.right;
    for (const TrueMode &mode : system.modes)
      v.push_back(range * std::sqrt(mode.stiffness) * normal() / (1 + std::abs(mode.weight)));
    return v;
  }

  static bool long_gone(const TrueMode &mode, double instant) { return mode.damping * instant > 6; }

  struct State {
    double displacement = 0, velocity = 0;
  };

  static State steady(const TrueMode &mode, const TrueForce &force, double time) {
    using Complex = std::complex<double>;
    const double w = force.frequency;
    const Complex input =
        Complex(0, -mode.load * force.amplitude) * std::polar(1.0, w * time + force.phase);
    const Complex c = input / Complex(mode.stiffness - w * w, mode.damping * w);
    return {c.real(), -w * c.imag()};
  }

  // What has decayed over the flight would have been out of all bounds at its start.
  static void settle_damped(const RandomSystem &system, double instant, std::vector<double> &q,
                            std::vector<double> &v) {
    for (std::size_t j = 0; j < q.size(); ++j)
      if (long_gone(system.modes[j], instant)) {
        const State state = steady(system.modes[j], system.force, instant);
        q[j] = state.displacement;
        v[j] = state.velocity;
      }
  }

  static double sum(const RandomSystem &system, const std::vector<double> &values) {
    double total = 0;
    for (std::size_t j = 0; j < values.size(); ++j)
      total += system.modes[j].weight * values[j];
    return total;
  }

  // Displacement and velocity at the stop get the wanted values.
  static void aim(const RandomSystem &system, double instant, double displacement, double rate,
                  std::vector<double> &q, std::vector<double> &v) {
    double size = 0;
    for (const TrueMode &mode : system.modes)
      size += long_gone(mode, instant) ? 0 : mode.weight * mode.weight;
    if (size == 0)
      return;
    const double by = (displacement - sum(system, q)) / size;
    const double rate_by = (rate - sum(system, v)) / size;
    for (std::size_t j = 0; j < q.size(); ++j)
      if (!long_gone(system.modes[j], instant)) {
        q[j] += by * system.modes[j].weight;
        v[j] += rate_by * system.modes[j].weight;
      }
  }

  // The acceleration at the stop is nearly nothing; the displacement there stays.
  static void straighten(const RandomSystem &system, double instant, double wanted,
                         std::vector<double> &q) {
    std::vector<double> direction;
    double size = 0;
    double mean = 0;
    for (const TrueMode &mode : system.modes) {
      const double weight = long_gone(mode, instant) ? 0 : mode.weight;
      size += weight * weight;
      mean += weight * weight * mode.stiffness;
    }
    double change = 0;
    for (const TrueMode &mode : system.modes) {
      const double weight = long_gone(mode, instant) ? 0 : mode.weight;
      direction.push_back(weight * (mode.stiffness - mean / size));
      change -= mode.weight * mode.stiffness * direction.back();
    }
    if (size == 0 || std::abs(change) < 1e-3 * mean)
      return;
    double acceleration = 0;
    for (std::size_t j = 0; j < q.size(); ++j) {
      const TrueMode &mode = system.modes[j];
      const double force = mode.load * system.force.amplitude *
                           std::sin(system.force.frequency * instant + system.force.phase);
      acceleration += mode.weight * (force - mode.stiffness * q[j]);
    }
    for (std::size_t j = 0; j < q.size(); ++j)
      q[j] += (wanted - acceleration) / change * direction[j];
  }

  static RandomFlight back_to_start(const RandomSystem &system, double instant,
                                    const std::vector<double> &q, const std::vector<double> &v,
                                    double end) {
    RandomFlight flight{.displacement = {}, .velocity = {}, .end = end};
    const long double phase =
        system.force.phase + static_cast<long double>(system.force.frequency) * instant;
    for (std::size_t j = 0; j < q.size(); ++j) {
      TrueMode mode = system.modes[j];
      if (long_gone(mode, instant)) {
        const State state = steady(mode, system.force, 0);
        flight.displacement.push_back(state.displacement);
        flight.velocity.push_back(state.velocity);
        continue;
      }
      mode.weight = 1;
      const TrueMotion<long double> motion({mode}, system.force, phase, {q[j]}, {v[j]});
      const TrueJet<long double> at = motion.at(-static_cast<long double>(instant));
      flight.displacement.push_back(static_cast<double>(at[0]));
      flight.velocity.push_back(static_cast<double>(at[1]));
    }
    return flight;
  }

  std::mt19937_64 random_;
};

} // namespace vibroimpact::testing
