// Systems with nonlinear forces as one would write them for a general solver; see
// equations_by_hand.h.
#pragma once

#include "equations_by_hand.h"

namespace vibroimpact::benchmarks {

/// q'' + c q' + q + q^3 = A sin(w t).
struct Duffing {
  static constexpr std::size_t size = 2, contacts = 0;
  using State = std::array<double, size>;
  double damping = 0, amplitude = 0, forcing = 0;
  std::array<long, contacts> begun{};
  long evaluations = 0;

  double omega() const { return forcing; }
  double highest_frequency() const { return std::max(forcing, 1.0); }
  bool is_touching(std::size_t /*i*/) const { return false; }
  double recorded(const State &x, double /*time*/) const { return x[0]; }
  double recorded_rate(const State &x, double /*time*/) const { return x[1]; }
  double guard(std::size_t /*i*/, const State & /*x*/) const { return 1; }
  void pass(std::size_t /*i*/, State & /*x*/) {}
  void operator()(const State &x, State &dxdt, double time) {
    ++evaluations;
    dxdt[0] = x[1];
    dxdt[1] = amplitude * std::sin(forcing * time) - damping * x[1] - x[0] - x[0] * x[0] * x[0];
  }
};

/// A frame on equal springs along x and y that carries an unbalanced rotor with a motor of limited
/// power. State: x, y, angle, their rates, torque.
struct MotorOnFrame {
  static constexpr std::size_t size = 7, contacts = 0;
  using State = std::array<double, size>;
  double frame = 0, stiffness = 0, damping = 0;
  double rotor = 0, eccentricity = 0, inertia = 0;
  double starting_torque = 0, slope = 0, time_constant = 0;
  std::array<long, contacts> begun{};
  long evaluations = 0;

  double omega() const { return starting_torque / slope; }
  double highest_frequency() const { return omega(); }
  bool is_touching(std::size_t /*i*/) const { return false; }
  double recorded(const State &x, double /*time*/) const { return x[0]; }
  double recorded_rate(const State &x, double /*time*/) const { return x[3]; }
  double guard(std::size_t /*i*/, const State & /*x*/) const { return 1; }
  void pass(std::size_t /*i*/, State & /*x*/) {}
  // The accelerations of the frame put into the moment about the shaft.
  void operator()(const State &x, State &dxdt, double /*time*/) {
    ++evaluations;
    const double sine = std::sin(x[2]), cosine = std::cos(x[2]);
    const double moment = rotor * eccentricity, mass = frame + rotor;
    const double force_x = -damping * x[3] - stiffness * x[0];
    const double force_y = -damping * x[4] - stiffness * x[1];
    const double turn = (x[6] + moment * (force_x * sine - force_y * cosine) / mass) /
                        (inertia + moment * eccentricity - moment * moment / mass);
    for (std::size_t i = 0; i < 3; ++i)
      dxdt[i] = x[3 + i];
    dxdt[3] = (force_x + moment * (turn * sine + x[5] * x[5] * cosine)) / mass;
    dxdt[4] = (force_y - moment * (turn * cosine - x[5] * x[5] * sine)) / mass;
    dxdt[5] = turn;
    dxdt[6] = (starting_torque - slope * x[5] - x[6]) / time_constant;
  }
};

/// One elastic body, its modes with unit masses, against `count` stops. State: modal coordinates,
/// their rates.
template <std::size_t n, std::size_t count> struct BodyOnStops {
  static constexpr std::size_t size = 2 * n, contacts = count;
  using State = std::array<double, size>;
  std::array<double, n> squared_frequency{}, damping{}, load{};
  std::array<std::array<double, n>, contacts> row{}; ///< gap = clearance + row q
  std::array<double, contacts> clearance{};
  HertzHeads law{};
  double amplitude = 0, forcing = 0;
  std::array<bool, contacts> touching{};
  std::array<long, contacts> begun{};
  long evaluations = 0;

  double omega() const { return forcing; }
  double highest_frequency() const { return std::sqrt(squared_frequency[n - 1]); }
  bool is_touching(std::size_t i) const { return touching[i]; }
  double recorded(const State &x, double /*time*/) const { return product(load, x.data()); }
  double recorded_rate(const State &x, double /*time*/) const {
    return product(load, x.data() + n);
  }
  static double product(const std::array<double, n> &row, const double *q) {
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j)
      sum += row[j] * q[j];
    return sum;
  }
  double guard(std::size_t i, const State &x) const {
    const double gap = clearance[i] + product(row[i], x.data());
    return touching[i] ? -gap : gap;
  }
  void pass(std::size_t i, State & /*x*/) {
    touching[i] = !touching[i];
    begun[i] += touching[i];
  }
  void operator()(const State &x, State &dxdt, double time) {
    ++evaluations;
    const double force = amplitude * std::sin(forcing * time);
    for (std::size_t j = 0; j < n; ++j) {
      dxdt[j] = x[n + j];
      dxdt[n + j] = force * load[j] - damping[j] * x[n + j] - squared_frequency[j] * x[j];
    }
    for (std::size_t i = 0; i < contacts; ++i)
      if (touching[i]) {
        const double normal =
            law(-clearance[i] - product(row[i], x.data()), -product(row[i], x.data() + n));
        for (std::size_t j = 0; j < n; ++j)
          dxdt[n + j] += normal * row[i][j];
      }
  }
};

} // namespace vibroimpact::benchmarks
