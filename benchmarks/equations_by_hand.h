// The systems as one would write them for a general solver: fixed arrays, no calls that the
// compiler cannot see through. `touching` is switched by whoever locates the contact changes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace vibroimpact::benchmarks {

/// F = k u
struct LinearStop {
  double stiffness = 0; ///< [N/m]
  double force(double gap, double /*gap_rate*/) const { return -stiffness * gap; }
};

/// F = k u^(3/2) (1 + d u'), without tension
struct HertzStop {
  double stiffness = 0;   ///< [N/m^1.5]
  double dissipation = 0; ///< [s/m]
  double force(double gap, double gap_rate) const {
    const double u = std::max(0.0, -gap);
    return stiffness * u * std::sqrt(u) * std::max(0.0, 1 - dissipation * gap_rate);
  }
};

/// A mass on a spring and a dashpot under the force amplitude sin(omega t), with a stop on its
/// positive side.
template <class Stop> struct ForcedMass {
  using State = std::array<double, 2>; // q, v
  double mass = 0, stiffness = 0, damping = 0, amplitude = 0, omega = 0, clearance = 0;
  Stop stop;
  bool touching = false;
  long evaluations = 0;

  double gap(const State &x) const { return clearance - x[0]; }
  double highest_frequency() const { return std::max(omega, std::sqrt(stiffness / mass)); }
  void operator()(const State &x, State &dxdt, double time) {
    ++evaluations;
    double force = amplitude * std::sin(omega * time) - stiffness * x[0] - damping * x[1];
    if (touching)
      force -= stop.force(clearance - x[0], -x[1]);
    dxdt[0] = x[1];
    dxdt[1] = force / mass;
  }
};

/// Two undamped beams in modal coordinates of unit modal mass; gap = clearance + row . q.
template <std::size_t n> struct ModalPair {
  using State = std::array<double, 2 * n>; // q, v
  std::array<double, n> squared_frequency{}, row{};
  double clearance = 0;
  HertzStop stop;
  bool touching = false;
  long evaluations = 0;

  double gap(const State &x) const {
    double gap = clearance;
    for (std::size_t j = 0; j < n; ++j)
      gap += row[j] * x[j];
    return gap;
  }
  double highest_frequency() const {
    return std::sqrt(*std::max_element(squared_frequency.begin(), squared_frequency.end()));
  }
  void operator()(const State &x, State &dxdt, double /*time*/) {
    ++evaluations;
    for (std::size_t j = 0; j < n; ++j) {
      dxdt[j] = x[n + j];
      dxdt[n + j] = -squared_frequency[j] * x[j];
    }
    if (!touching)
      return;
    double gap_rate = 0;
    for (std::size_t j = 0; j < n; ++j)
      gap_rate += row[j] * x[n + j];
    const double force = stop.force(gap(x), gap_rate);
    for (std::size_t j = 0; j < n; ++j)
      dxdt[n + j] += force * row[j];
  }
};

} // namespace vibroimpact::benchmarks
