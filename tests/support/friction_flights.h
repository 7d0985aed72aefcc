// Random phases of stick and slip that come near their end or reach it, through Trajectory, and
// judged by dense evaluation in extended precision.
#pragma once

#include "contact/friction/spring_slider.h"
#include "model/time_function.h"
#include "support/friction_models.h"
#include "support/true_friction.h"

#include <Eigen/Dense>

#include <algorithm>
#include <numbers>
#include <random>

namespace vibroimpact::testing {

struct FrictionFlightCounts {
  long flights = 0;
  long changes = 0;       ///< flights with one, by dense evaluation
  long touches = 0;       ///< lowest values of a guard within rounding
  long undecided = 0;     ///< flights with touches that the program reports as undecided
  long missed = 0;        ///< changes that were found later, or not at all, and nothing reported
  long invented = 0;      ///< found where no guard is zero to rounding
  long wrong_mode = 0;    ///< what follows is not what the force or the slip asks for
  long apart = 0;         ///< motions that end elsewhere when nobody observes them
  double worst_value = 0; ///< of the guard at the instant found, over the size of its terms

  long wrong() const { return missed + invented + wrong_mode + apart; }
};

class FrictionFlights {
public:
  explicit FrictionFlights(std::uint64_t seed)
      : random_(seed), chain_(random_chain()), model_(build_model()),
        contacts_({sliding_along_x(model_, "m0.head", "", law(), chain_.belt)}),
        trajectory_(model_, contacts_, motion::Settings{}) {
    for (int mode = 0; mode < 3; ++mode)
      phases_.emplace_back(chain_, mode);
  }

  void count(int flights, FrictionFlightCounts &counts) {
    for (int i = 0; i < flights; ++i)
      if (const auto flight = random_flight())
        judge(*flight, counts);
  }

private:
  using Real = TruePhase::Real;
  using State = TruePhase::State;
  struct Flight {
    int mode = 0;
    State start{};
    double end = 0;
  };

  class FirstChange : public motion::Observer {
  public:
    void event(const motion::ContactEvent &event) override {
      if (from < 0) {
        time = event.time;
        from = event.from;
        to = event.to;
      }
    }
    int from = -1, to = -1;
    double time = 0;
  };

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  double power(double low, double high) { return std::pow(10, uniform(low, high)); }
  double normal() { return std::normal_distribution<double>()(random_); }

  FrictionChain random_chain() {
    FrictionChain chain;
    const int n = 1 + static_cast<int>(uniform(0, 3));
    const double ratio = chance(0.4) ? 0 : power(-4, -0.5);
    for (int j = 0; j < n; ++j) {
      chain.mass.push_back(power(-0.7, 0.7));
      chain.stiffness.push_back(chance(0.2) ? 0 : power(-0.7, 0.7));
      // A dashpot alone would slow a mass down for so long that the terms of its way cancel.
      chain.damping.push_back(chain.stiffness.back() > 0 ? ratio * power(-1, 1) : 0);
      if (j > 0) {
        chain.link.push_back(power(-0.7, 0.7));
        chain.link_damping.push_back(ratio * power(-1, 1));
      }
    }
    chain.driven = static_cast<std::size_t>(uniform(0, n));
    chain.amplitude = chance(0.15) ? 0 : power(-1, 0.5);
    chain.frequency = power(-0.5, 0.5);
    chain.phase = uniform(-3, 3);
    chain.belt = chance(0.5) ? 0 : (chance(0.5) ? 1 : -1) * power(-2, 0.3);
    chain.normal = power(-0.5, 0.5);
    chain.mu = power(-1, 0);
    chain.mu_s = chain.mu * (chance(0.5) ? 1 : uniform(1, 2));
    if (chance(0.4)) {
      chain.kt = power(-0.5, 1.5);
      chain.ct = chance(0.5) ? 0 : chain.kt * power(-1.3, 0.5);
    }
    return chain;
  }

  model::Model build_model() const {
    std::vector<std::shared_ptr<const reduction::ReducedBody>> bodies;
    for (std::size_t j = 0; j < chain_.n(); ++j)
      bodies.push_back(single_mass("m" + std::to_string(j), chain_.mass[j], chain_.stiffness[j],
                                   chain_.damping[j]));
    model::Model model(bodies);
    for (std::size_t j = 0; j + 1 < chain_.n(); ++j) {
      RowVector row = RowVector::Zero(static_cast<Index>(chain_.n()));
      row[static_cast<Index>(j)] = -1;
      row[static_cast<Index>(j) + 1] = 1;
      model.add_connection({.name = "link" + std::to_string(j),
                            .side_a = "m" + std::to_string(j) + ".head",
                            .side_b = "m" + std::to_string(j + 1) + ".head",
                            .elongation = {.row = row, .base_coefficients = {}},
                            .stiffness = chain_.link[j],
                            .damping = chain_.link_damping[j]});
    }
    if (chain_.amplitude != 0)
      model.add_force("force",
                      std::make_shared<model::Harmonic>(model::Given::displacement,
                                                        chain_.amplitude, chain_.frequency,
                                                        chain_.phase),
                      {.body = chain_.driven, .point = 0}, Vector3::UnitX());
    return model;
  }

  std::shared_ptr<const contact::ContactLaw> law() const {
    if (chain_.kt == 0)
      return coulomb(chain_.normal, chain_.mu, chain_.mu_s);
    return constant_with(chain_.normal,
                         std::make_shared<contact::SpringSlider>(chain_.kt, chain_.mu, chain_.ct));
  }

  // What a state of this mode must fulfil: the held mass has the belt's speed, a spring that slides
  // without a dashpot has its limit.
  void constrain(int mode, State &state) const {
    const std::size_t n = chain_.n();
    if (chain_.kt == 0 && mode == 0)
      state[n] = chain_.belt;
    if (chain_.kt == 0)
      state[2 * n] = 0;
    else if (mode > 0 && chain_.ct == 0)
      state[2 * n] =
          (mode == 1 ? 1 : -1) * static_cast<double>(chain_.mu * chain_.normal) / chain_.kt;
  }

  bool movable(int mode, std::size_t i) const {
    const std::size_t n = chain_.n();
    if (i == n)
      return chain_.kt > 0 || mode > 0;
    return i < 2 * n || (i == 2 * n && chain_.kt > 0 && (mode == 0 || chain_.ct > 0));
  }

  // The nearest state at which forms have these values.
  void aim(int mode, const std::vector<std::pair<State, Real>> &forms, State &state) const {
    using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
    const std::size_t n = 2 * chain_.n() + 1;
    Matrix rows = Matrix::Zero(static_cast<Index>(forms.size()), static_cast<Index>(n));
    Matrix missing(static_cast<Index>(forms.size()), 1);
    for (std::size_t f = 0; f < forms.size(); ++f) {
      for (std::size_t i = 0; i < n; ++i)
        if (movable(mode, i))
          rows(static_cast<Index>(f), static_cast<Index>(i)) = forms[f].first[i];
      missing(static_cast<Index>(f), 0) =
          forms[f].second - TruePhase::product(forms[f].first, state);
    }
    const Matrix change = rows.completeOrthogonalDecomposition().solve(missing);
    for (std::size_t i = 0; i < n; ++i)
      if (movable(mode, i))
        state[i] += change(static_cast<Index>(i), 0);
  }

  // A flight at whose instant a guard is zero but for 1e-16 ... 1e-1, mostly with its lowest value
  // there, and which begins before; none where it cannot begin in this mode.
  std::optional<Flight> random_flight() {
    const int mode = static_cast<int>(uniform(0, 3));
    const TruePhase &phase = phases_[static_cast<std::size_t>(mode)];
    const std::size_t n = chain_.n();
    State at{};
    const double range = power(-1, 0.5);
    for (std::size_t i = 0; i <= 2 * n; ++i)
      at[i] = range * normal();
    at[phase.one()] = 1;
    constrain(mode, at);
    const double period = 2 * std::numbers::pi;
    const double instant = chance(0.2) ? period * power(-6, -2) : period * uniform(0.02, 1);
    const Real angle = chain_.phase + static_cast<Real>(chain_.frequency) * instant;
    at[phase.sine()] = std::sin(angle);
    at[phase.sine() + 1] = std::cos(angle);
    const State &guard = phase.guards()[phase.guards().size() > 1 && chance(0.5) ? 1 : 0];
    const State rate = phase.rate_of(guard);
    std::vector<std::pair<State, Real>> forms = {
        {guard, (chance(0.5) ? 1 : -1) * range * power(-16, -1)}};
    if (chance(0.7))
      forms.emplace_back(rate, (chance(0.5) ? 1 : -1) * range * power(-16, -2));
    if (chance(0.2))
      forms.emplace_back(phase.rate_of(rate), (chance(0.5) ? 1 : -1) * range * power(-16, -2));
    aim(mode, forms, at);
    Flight flight{.mode = mode,
                  .start = phase.advance(at, -instant),
                  .end = instant + uniform(0.05, 0.6) * period};
    for (std::size_t i = 0; i <= 2 * n; ++i)
      flight.start[i] = static_cast<double>(flight.start[i]);
    if (std::any_of(flight.start.begin(), flight.start.end(),
                    [](Real x) { return std::abs(x) > 1e3; }))
      return std::nullopt; // what decays fast would have begun beyond all bounds
    constrain(mode, flight.start);
    flight.start[phase.sine()] = std::sin(static_cast<Real>(chain_.phase));
    flight.start[phase.sine() + 1] = std::cos(static_cast<Real>(chain_.phase));
    const State largest = phase.largest(flight.start, flight.end);
    for (const State &g : phase.guards())
      if (!(TruePhase::product(g, flight.start) > 1e-6 * TruePhase::size(g, largest)))
        return std::nullopt;
    return flight;
  }

  motion::MotionState start(const Flight &flight) const {
    const std::size_t n = chain_.n();
    const std::size_t size = 2 * n + (chain_.kt > 0 ? 1 : 0);
    motion::MotionState state{.time = 0, .physical = Vector::Zero(static_cast<Index>(size))};
    for (std::size_t i = 0; i < size; ++i)
      state.physical[static_cast<Index>(i)] = static_cast<double>(flight.start[i]);
    return state;
  }

  // A slider goes on only where it is told to: the program's own choice counts.
  int begun_mode() const {
    const std::string name = trajectory_.equations().mode(0).name;
    return name.ends_with("stick") ? 0 : name.ends_with("forward") ? 1 : 2;
  }

  void judge(const Flight &flight, FrictionFlightCounts &counts) {
    trajectory_.start(start(flight));
    if (begun_mode() != flight.mode)
      return; // a spring-slider begins in stick
    FirstChange found;
    trajectory_.advance(flight.end, found);
    const Vector observed = trajectory_.motion_state().physical;
    const bool undecided = trajectory_.accuracy().undecided_events > 0;
    trajectory_.start(start(flight));
    trajectory_.advance(flight.end);
    const TruePhase &phase = phases_[static_cast<std::size_t>(flight.mode)];
    const FirstFall truth(phase, flight.start, flight.end);
    ++counts.flights;
    counts.changes += truth.time ? 1 : 0;
    counts.touches += truth.touches;
    counts.undecided += undecided ? 1 : 0;
    if (truth.touches == 0 && !undecided &&
        (observed - trajectory_.motion_state().physical).cwiseAbs().maxCoeff() >
            1e-9 * (1 + observed.cwiseAbs().maxCoeff()))
      ++counts.apart;
    const double rounding = 1e-12 * (1 + flight.end);
    const double reached = found.from < 0 ? flight.end : found.time;
    counts.missed += truth.time && reached > *truth.time + rounding && !undecided ? 1 : 0;
    if (found.from < 0)
      return;
    judge_change(phase, flight, truth, found, counts);
  }

  // Is one of the guards zero there, and does the mode follow that must?
  void judge_change(const TruePhase &phase, const Flight &flight, const FirstFall &truth,
                    const FirstChange &found, FrictionFlightCounts &counts) const {
    const State at = phase.advance(flight.start, found.time);
    Real least = INFINITY;
    std::size_t fallen = 0;
    for (std::size_t g = 0; g < phase.guards().size(); ++g) {
      const State &guard = phase.guards()[g];
      const Real slack =
          truth.band(guard) +
          4 * 0x1p-53L * found.time * std::abs(TruePhase::product(phase.rate_of(guard), at));
      const Real value = std::abs(TruePhase::product(guard, at)) / slack;
      if (value < least) {
        least = value;
        fallen = g;
      }
    }
    counts.invented += least > 4 ? 1 : 0;
    counts.worst_value = std::max(counts.worst_value, static_cast<double>(least));
    counts.wrong_mode += may_follow(phase, flight.mode, fallen, at, found.to) ? 0 : 1;
  }

  bool may_follow(const TruePhase &phase, int mode, std::size_t fallen, const State &at,
                  int to) const {
    if (mode == 0)
      return to == static_cast<int>(fallen) + 1;
    if (chain_.kt > 0)
      return to == 0;
    const State row = phase.holding_force();
    const Real force = TruePhase::product(row, at); // on the belt
    const Real limit = chain_.mu_s * chain_.normal;
    const Real open = 1e-9L * (TruePhase::size(row, at) + limit);
    return (to == 0 && std::abs(force) < limit + open) || (to == 1 && force < -limit + open) ||
           (to == 2 && force > limit - open);
  }

  std::mt19937_64 random_;
  FrictionChain chain_;
  model::Model model_;
  contact::ContactSet contacts_;
  motion::Trajectory trajectory_;
  std::vector<TruePhase> phases_;
};

inline void count_friction(std::uint64_t seed, std::uint64_t index, int flights,
                           FrictionFlightCounts &counts) {
  FrictionFlights(seed + 0x9e3779b97f4a7c15u * index).count(flights, counts);
}

} // namespace vibroimpact::testing
