#include "motion/variation/vanishing_gap.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

namespace {

constexpr double negligible = 1e-9;
// Of the time scales of the contact and of the model.
constexpr double short_part = 1e-4;

ConstVectorView view(const Vector &vector) { return {vector.data(), vector.size()}; }

Vector rates_at(const Equations &equations, double time, const Vector &state) {
  Vector rates(state.size());
  equations.rates(time, view(state), VectorView(rates.data(), rates.size()));
  return rates;
}

// dF/dgap at a time from where the gap vanishes.
double slope_after(const Equations &equations, std::size_t c, contact::LocalState local,
                   double dt) {
  contact::LawResponse response;
  local.gap = -std::abs(local.gap_rate) * dt;
  equations.contacts().pairs()[c].law->evaluate(equations.modes()[c], local, response);
  return std::abs(response.force_by_gap);
}

// Zero where the slope does not fall from there on. The square of the time falls faster than the
// slope grows.
double short_time(const Equations &equations, std::size_t c, const contact::LocalState &local,
                  double duration) {
  const model::Model &model = equations.model();
  const double mass = equations.contacts().effective_mass(c, model);
  double dt = std::min(duration, short_part / std::max(model.highest_frequency(), 1.0));
  if (!(slope_after(equations, c, local, dt / 4) > 1.2 * slope_after(equations, c, local, dt)))
    return 0;
  for (int i = 0; i < 60; ++i, dt /= 2)
    if (slope_after(equations, c, local, dt) * dt * dt <= short_part * short_part * mass)
      break;
  return dt;
}

// By the midpoint rule.
Vector state_after(const Equations &equations, double time, const Vector &state, double dt) {
  const StateLayout &layout = equations.layout();
  const auto move = [&](const Vector &rates, double by) {
    Vector after = state + by * rates;
    after.head(layout.n) = state.head(layout.n) + by * state.segment(layout.velocity(), layout.n) +
                           0.5 * by * by * rates.segment(layout.velocity(), layout.n);
    return after;
  };
  const Vector middle = move(rates_at(equations, time, state), 0.5 * dt);
  return move(rates_at(equations, time + 0.5 * dt, middle), dt);
}

// How the accelerations change from one time to another by the loads alone.
Vector by_loads(const Equations &equations, double from, double to, const Vector &state) {
  Vector before;
  Vector after;
  equations.model().load(equations.source_time(from), before);
  equations.model().load(equations.source_time(to), after);
  return equations.response_to((after - before).transpose(), from, view(state));
}

struct Slope {
  double middle = 0;   ///< dF/dgap half way between [N/m]
  double integral = 0; ///< int s dF/dgap ds over the time s since the gap was zero [N s^2/m]
};

// dF/dgap = c s^-q: q from two instants.
Slope slope_of(const Equations &equations, const ShortInterval &interval, const Vector &at_other,
               const Vector &at_middle) {
  const contact::ContactPair &pair = equations.contacts().pairs()[interval.contact];
  const int mode = equations.modes()[interval.contact];
  const double dt = interval.other - interval.zero;
  contact::LawResponse response;
  const auto slope = [&](double time, const Vector &state) {
    pair.law->evaluate(mode, equations.local_state(interval.contact, time, view(state)), response);
    return response.force_by_gap;
  };
  const double middle = slope(interval.zero + 0.5 * dt, at_middle);
  const double end = slope(interval.other, at_other);
  const bool power = middle * end > 0;
  const double exponent = power ? std::log2(middle / end) : 0;
  return {.middle = middle, .integral = end * dt * dt / (2 - std::min(exponent, 1.0))};
}

} // namespace

std::optional<VanishingGap> vanishing_gap(const Equations &equations, double time,
                                          const Vector &state, double duration) {
  for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
    const contact::Mode &mode = equations.mode(c);
    if (equations.inactive(c) || mode.holds_gap || mode.affine)
      continue;
    const contact::LocalState local = equations.local_state(c, time, view(state));
    const double zero = std::max(negligible * std::abs(local.gap_rate) * duration,
                                 equations.rounding(c, {.gap = 1}, time, state));
    const double dt = std::abs(local.gap) < zero ? short_time(equations, c, local, duration) : 0;
    if (dt > 0)
      return VanishingGap{.contact = c, .duration = dt};
  }
  return std::nullopt;
}

Vector state_at_other(const Equations &equations, const ShortInterval &interval) {
  return state_after(equations, interval.zero, interval.state_at_zero,
                     interval.other - interval.zero);
}

double cross(const Equations &equations, const std::vector<KeyTangent *> &keys,
             const ShortInterval &interval, Matrix &columns) {
  const StateLayout &layout = equations.layout();
  const Index n = layout.n;
  const Index v = layout.velocity();
  const Index size = layout.physical_size();
  const auto n_keys = static_cast<Index>(keys.size());
  const Index first_key = columns.cols() - n_keys;
  const std::size_t c = interval.contact;
  const RowVector &row = equations.contacts().pairs()[c].gap.row;
  const bool forward = interval.other > interval.zero;
  const double dt = std::abs(interval.other - interval.zero);
  const double middle = 0.5 * (interval.zero + interval.other);
  const Vector &at_zero = interval.state_at_zero;
  const Vector at_other = state_at_other(equations, interval);
  const Vector at_middle = state_after(equations, interval.zero, at_zero, middle - interval.zero);
  const Vector rates_at_zero = rates_at(equations, interval.zero, at_zero);
  const Vector rates_at_other = rates_at(equations, interval.other, at_other);

  RowVector gap = row * columns.topRows(n);
  RowVector gap_rate = row * columns.middleRows(v, n);
  if (!forward) // where it vanishes
    gap += dt * gap_rate;
  for (Index k = 0; k < n_keys; ++k) {
    KeyTangent &key = *keys[static_cast<std::size_t>(k)];
    gap[first_key + k] += key.gap(c, interval.zero, at_zero);
    gap_rate[first_key + k] += key.gap_rate(c, interval.zero, at_zero);
  }
  const RowVector shift = gap / equations.local_state(c, interval.zero, view(at_zero)).gap_rate;
  gap_rate -= shift * equations.gap_acceleration(c, interval.zero,
                                                 ConstVectorView(rates_at_zero.data() + v, n));

  Matrix rest = columns - (forward ? rates_at_zero : rates_at_other).head(size) * shift;
  rest.topRows(n) += 0.5 * dt * rest.middleRows(v, n);
  Matrix jacobian;
  equations.jacobian(middle, view(at_middle), jacobian);
  Matrix change = dt * (jacobian.topLeftCorner(size, size) * rest);
  RowVector gap_of_rest = row * rest.topRows(n);
  for (Index k = 0; k < n_keys; ++k) {
    KeyTangent &key = *keys[static_cast<std::size_t>(k)];
    change.col(first_key + k) += dt * key.rates(equations, middle, at_middle);
    gap_of_rest[first_key + k] += key.gap(c, middle, at_middle);
  }
  const Slope slope = slope_of(equations, interval, at_other, at_middle);
  const Matrix response = equations.response_to(row, middle, view(at_middle));
  const double sign = forward ? 1 : -1; // of the time from where the gap is zero
  change.middleRows(v, n) +=
      response * (sign * slope.integral * gap_rate - dt * slope.middle * gap_of_rest);
  change.middleRows(v, n) -=
      sign * by_loads(equations, interval.zero, interval.other, at_zero) * shift;
  columns += sign * (rates_at_other - rates_at_zero).head(size) * shift + change;
  return dt * jacobian.topLeftCorner(size, size).trace();
}

} // namespace vibroimpact::motion
