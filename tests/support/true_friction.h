// Chains of masses of which one is held by friction, in extended precision: each phase is a linear
// system with the excitation among its coordinates, followed by Taylor series.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace vibroimpact::testing {

/// Masses in a row on springs to the ground and between neighbours; the first one rubs on a belt.
struct FrictionChain {
  std::vector<double> mass, stiffness, damping; ///< to the ground, of each
  std::vector<double> link, link_damping;       ///< between i and i + 1
  std::size_t driven = 0;                       ///< P sin(w t + phase) acts on it
  double amplitude = 0, frequency = 1, phase = 0;
  double belt = 0;                     ///< speed of its surface
  double normal = 1, mu = 0, mu_s = 0; ///< of the contact
  double kt = 0, ct = 0;               ///< of a spring-slider; kt = 0: Coulomb

  std::size_t n() const { return mass.size(); }
};

/// Chain and mode: stick 0, slip forward 1 (belt faster than mass), slip backward 2. Coordinates:
/// displacements, velocities, deformation of the slider, sin, cos, 1.
class TruePhase {
public:
  using Real = long double;
  static constexpr std::size_t most = 10, order = 32;
  using State = std::array<Real, most>;

  TruePhase(const FrictionChain &chain, int mode) : chain_(chain), mode_(mode) {
    const std::size_t n = chain.n();
    for (std::size_t j = 0; j < n; ++j)
      add(j, n + j, 1);
    for (std::size_t j = 0; j < n; ++j)
      if (j > 0 || !held())
        add_forces(n + j, j, 1 / static_cast<Real>(chain.mass[j]));
    if (!held())
      add_friction(n, 1 / static_cast<Real>(chain.mass[0]));
    add_deformation();
    add(sine(), sine() + 1, chain.frequency);
    add(sine() + 1, sine(), -static_cast<Real>(chain.frequency));
    add_guards();
    for (std::size_t i = 0; i < most; ++i) {
      Real sum = 0;
      for (std::size_t j = 0; j < most; ++j)
        sum = std::max(sum, std::sqrt(std::abs(matrix_[i][j] * matrix_[j][i])) +
                                (i == j ? std::abs(matrix_[i][j]) : 0));
      fastest_ = std::max(fastest_, sum);
    }
    for (const auto &row : matrix_)
      for (std::size_t j = 0; j < most; ++j)
        if (row[j] != 0)
          entries_.push_back({static_cast<std::size_t>(&row - matrix_.data()), j, row[j]});
  }

  std::size_t sine() const { return 2 * chain_.n() + 1; }
  std::size_t one() const { return 2 * chain_.n() + 3; }
  const std::vector<State> &guards() const { return guards_; }
  /// Of a guard, the rate of which at this state is the value.
  State rate_of(const State &row) const {
    State rate{};
    for (const Entry &e : entries_)
      rate[e.column] += row[e.row] * e.value;
    return rate;
  }
  /// Force that holds the mass at the speed of the belt, on the belt.
  State holding_force() const {
    TruePhase copy = *this;
    copy.matrix_ = {};
    copy.add_forces(0, 0, 1);
    return copy.matrix_[0];
  }

  static Real product(const State &a, const State &b) {
    Real sum = 0;
    for (std::size_t i = 0; i < most; ++i)
      sum += a[i] * b[i];
    return sum;
  }
  static Real size(const State &a, const State &b) {
    Real sum = 0;
    for (std::size_t i = 0; i < most; ++i)
      sum += std::abs(a[i] * b[i]);
    return sum;
  }

  using Series = std::array<State, order + 1>;
  /// State at t is the sum of series[k] t^k, for t up to step().
  void series(const State &from, Series &list) const {
    list[0] = from;
    for (std::size_t k = 1; k <= order; ++k) {
      list[k] = {};
      for (const Entry &e : entries_)
        list[k][e.row] += e.value * list[k - 1][e.column];
      for (Real &x : list[k])
        x /= static_cast<Real>(k);
    }
  }
  Real step() const { return 1 / fastest_; }
  State advance(const State &from, Real time) const {
    State state = from;
    const auto steps = static_cast<std::size_t>(std::ceil(std::abs(time) / step())) + 1;
    Series list;
    for (std::size_t s = 0; s < steps; ++s) {
      series(state, list);
      state = list[order];
      for (std::size_t k = order; k-- > 0;)
        for (std::size_t i = 0; i < most; ++i)
          state[i] = state[i] * time / static_cast<Real>(steps) + list[k][i];
    }
    return state;
  }

  /// Coordinates until the end are not larger: of all displacements alike, of all velocities alike,
  /// and these are what the fastest motion makes of those.
  State largest(const State &from, Real end) const {
    const std::size_t n = chain_.n();
    State state = from, bound = from;
    const auto steps = static_cast<std::size_t>(std::ceil(end / step()));
    for (std::size_t s = 0; s <= steps; ++s) {
      for (std::size_t i = 0; i < most; ++i) {
        const std::size_t kind = i < n ? 0 : i < 2 * n ? n : i;
        bound[kind] = std::max(std::abs(bound[kind]), std::abs(state[i]));
      }
      state = advance(state, end / static_cast<Real>(steps));
    }
    const Real way = std::max(bound[0], bound[n] / fastest_);
    const Real speed = std::max(bound[n], bound[0] * fastest_);
    for (std::size_t i = 0; i < 2 * n; ++i)
      bound[i] = i < n ? way : speed;
    return bound;
  }

private:
  struct Entry {
    std::size_t row, column;
    Real value;
  };

  bool held() const { return mode_ == 0 && chain_.kt == 0; }
  Real sigma() const { return mode_ == 1 ? 1 : -1; }
  void add(std::size_t row, std::size_t column, Real value) { matrix_[row][column] += value; }

  // All but friction on mass j, times a factor.
  void add_forces(std::size_t row, std::size_t j, Real factor) {
    const std::size_t n = chain_.n();
    const auto spring = [&](std::size_t to, Real k, Real c) {
      add(row, j, -factor * k);
      add(row, n + j, -factor * c);
      if (to < n) {
        add(row, to, factor * k);
        add(row, n + to, factor * c);
      }
    };
    spring(n, chain_.stiffness[j], chain_.damping[j]);
    if (j > 0)
      spring(j - 1, chain_.link[j - 1], chain_.link_damping[j - 1]);
    if (j + 1 < n)
      spring(j + 1, chain_.link[j], chain_.link_damping[j]);
    if (j == chain_.driven)
      add(row, sine(), factor * chain_.amplitude);
  }

  // Of the belt on the mass.
  void add_friction(std::size_t row, Real factor) {
    const std::size_t n = chain_.n();
    if (mode_ > 0) {
      add(row, one(), factor * sigma() * chain_.mu * chain_.normal);
      return;
    }
    add(row, 2 * n, factor * chain_.kt);
    add(row, n, -factor * chain_.ct);
    add(row, one(), factor * chain_.ct * chain_.belt);
  }

  void add_deformation() {
    const std::size_t n = chain_.n(), z = 2 * n;
    if (chain_.kt == 0)
      return;
    if (mode_ == 0) {
      add(z, n, -1);
      add(z, one(), chain_.belt);
    } else if (chain_.ct > 0) {
      const Real ct = chain_.ct;
      add(z, z, -chain_.kt / ct);
      add(z, one(), sigma() * chain_.mu * chain_.normal / ct);
    }
  }

  void add_guards() {
    const std::size_t n = chain_.n();
    if (mode_ > 0) {
      State speed{};
      speed[n] = -sigma();
      speed[one()] = sigma() * chain_.belt;
      for (std::size_t i = 0; i < most; ++i)
        speed[i] -= sigma() * matrix_[2 * n][i];
      guards_ = {speed};
      return;
    }
    State force{}; // of the belt on the mass
    if (held()) {
      force = holding_force();
      for (Real &x : force)
        x = -x;
    } else {
      TruePhase copy = *this;
      copy.matrix_ = {};
      copy.add_friction(0, 1);
      force = copy.matrix_[0];
    }
    for (const Real sign : {-1.0L, 1.0L}) {
      State guard{};
      for (std::size_t i = 0; i < most; ++i)
        guard[i] = sign * force[i];
      guard[one()] += (held() ? chain_.mu_s : chain_.mu) * chain_.normal;
      guards_.push_back(guard);
    }
  }

  FrictionChain chain_;
  int mode_;
  std::array<State, most> matrix_{};
  std::vector<Entry> entries_;
  std::vector<State> guards_; ///< of stick: forward, backward
  Real fastest_ = 0;          ///< [1/s]
};

/// The first instant at which a guard is below zero by more than rounding, by dense evaluation.
class FirstFall {
public:
  using Real = TruePhase::Real;

  FirstFall(const TruePhase &phase, const TruePhase::State &from, Real end)
      : largest_(phase.largest(from, end)) {
    TruePhase::State state = from;
    const auto steps = static_cast<std::size_t>(std::ceil(end / phase.step()));
    const Real h = end / static_cast<Real>(steps);
    for (std::size_t s = 0; s < steps && !time; ++s) {
      phase.series(state, series_);
      for (const TruePhase::State &guard : phase.guards())
        look(guard, static_cast<Real>(s) * h, h);
      for (std::size_t i = 0; i < TruePhase::most; ++i) {
        state[i] = series_[TruePhase::order][i];
        for (std::size_t k = TruePhase::order; k-- > 0;)
          state[i] = state[i] * h + series_[k][i];
      }
    }
  }

  std::optional<Real> time; ///< [s]
  long touches = 0;         ///< lowest values within the band

  /// What 64 roundings of the largest terms of a guard make of it.
  Real band(const TruePhase::State &guard) const {
    return 64 * 0x1p-53L * TruePhase::size(guard, largest_);
  }

private:
  using Polynomial = std::array<Real, TruePhase::order + 1>;

  static Real value(const Polynomial &p, Real t) {
    Real sum = p[TruePhase::order];
    for (std::size_t k = TruePhase::order; k-- > 0;)
      sum = sum * t + p[k];
    return sum;
  }
  static Polynomial derivative(const Polynomial &p) {
    Polynomial d{};
    for (std::size_t k = 1; k < p.size(); ++k)
      d[k - 1] = static_cast<Real>(k) * p[k];
    return d;
  }
  static Real zero(const Polynomial &p, Real a, Real b, Real level = 0) {
    const bool falls = value(p, a) > level;
    for (int i = 0; i < 70 && a < b; ++i) {
      const Real middle = (a + b) / 2;
      ((value(p, middle) > level) == falls ? a : b) = middle;
    }
    return (a + b) / 2;
  }

  void look(const TruePhase::State &guard, Real begin, Real h) {
    Polynomial p;
    Real power = 1, least = 0;
    for (std::size_t k = 0; k <= TruePhase::order; ++k, power *= h) {
      p[k] = TruePhase::product(guard, series_[k]);
      least += k == 0 ? p[0] : -std::abs(p[k]) * power;
    }
    const Real band_here = band(guard);
    if (least > band_here)
      return;
    const Polynomial slope = derivative(p), bend = derivative(slope);
    constexpr int samples = 12;
    for (int i = 0; i < samples; ++i) {
      const Real a = h * i / samples, b = h * (i + 1) / samples;
      const Real middle = value(bend, a) * value(bend, b) < 0 ? zero(bend, a, b) : (a + b) / 2;
      if (below(p, slope, a, middle, begin, band_here) ||
          below(p, slope, middle, b, begin, band_here))
        return;
    }
  }

  // The slope changes its sign once at most from a to b.
  bool below(const Polynomial &p, const Polynomial &slope, Real a, Real b, Real begin,
             Real band_here) {
    Real lowest = b;
    if (value(slope, a) < 0 && value(slope, b) > 0) {
      lowest = zero(slope, a, b);
      touches += std::abs(value(p, lowest)) <= 4 * band_here ? 1 : 0;
    }
    const Real level = -4 * band_here; // where no rounding of its terms takes it for a touch
    if (value(p, a) < level)
      lowest = a;
    if (!(value(p, lowest) < level))
      return false;
    const Real t = begin + (lowest > a ? zero(p, a, lowest, level) : a);
    time = time ? std::min(*time, t) : t;
    return true;
  }

  TruePhase::State largest_;
  TruePhase::Series series_;
};

} // namespace vibroimpact::testing
