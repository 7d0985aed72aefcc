#include "motion/variation/vanishing_gap.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::motion {

namespace {

constexpr double negligible = 1e-9;
// Parts of the duration of a step.
constexpr double short_part = 1e-7;
constexpr double longest_part = 1e-2;

ConstVectorView view(const Vector &vector) { return {vector.data(), vector.size()}; }

Vector rates_at(const Equations &equations, double time, const Vector &state) {
  Vector rates(state.size());
  equations.rates(time, view(state), VectorView(rates.data(), rates.size()));
  return rates;
}

// Long enough for the gap to be more than its rounding.
double short_time(const Equations &equations, std::size_t c, double time, const Vector &state,
                  double duration) {
  const double rounding = equations.rounding(c, {.gap = 1}, time, state);
  const double speed = std::abs(equations.local_state(c, time, view(state)).gap_rate);
  const double wanted = std::max(short_part * duration, 100 * rounding / speed);
  return std::min(wanted, longest_part * duration);
}

// State after a time so short that rates are as good as constant but for the kinematics.
Vector state_after(const Equations &equations, const Vector &state, const Vector &rates,
                   double dt) {
  const StateLayout &layout = equations.layout();
  Vector after = state + dt * rates;
  after.head(layout.n) += 0.5 * dt * dt * rates.segment(layout.velocity(), layout.n);
  return after;
}

} // namespace

std::optional<VanishingGap> vanishing_gap(const Equations &equations, double time,
                                          const Vector &state, double duration) {
  for (std::size_t c = 0; c < equations.contacts().size(); ++c) {
    const contact::Mode &mode = equations.mode(c);
    if (equations.inactive(c) || mode.holds_gap || mode.affine)
      continue;
    const contact::LocalState local = equations.local_state(c, time, view(state));
    if (std::abs(local.gap) < std::max(negligible * std::abs(local.gap_rate) * duration,
                                       equations.rounding(c, {.gap = 1}, time, state)))
      return VanishingGap{.contact = c,
                          .duration = short_time(equations, c, time, state, duration)};
  }
  return std::nullopt;
}

Vector state_at_other(const Equations &equations, const ShortInterval &interval) {
  const Vector rates = rates_at(equations, interval.zero, interval.state_at_zero);
  return state_after(equations, interval.state_at_zero, rates, interval.other - interval.zero);
}

void cross(const Equations &equations, const std::vector<KeyTangent *> &keys,
           const ShortInterval &interval, Matrix &columns) {
  const StateLayout &layout = equations.layout();
  const Index n = layout.n;
  const Index size = layout.physical_size();
  const auto n_keys = static_cast<Index>(keys.size());
  const Index first_key = columns.cols() - n_keys;
  const bool forward = interval.other > interval.zero;
  const double dt = std::abs(interval.other - interval.zero);
  const contact::ContactPair &pair = equations.contacts().pairs()[interval.contact];
  const Vector &at_zero = interval.state_at_zero;
  const Vector rates_at_zero = rates_at(equations, interval.zero, at_zero);
  const Vector at_other = state_at_other(equations, interval);
  const Vector rates_at_other = rates_at(equations, interval.other, at_other);
  const Vector &rates = forward ? rates_at_zero : rates_at_other;
  const Vector gained = (forward ? 1 : -1) * (rates_at_other - rates_at_zero);

  RowVector gap = pair.gap.row * columns.topRows(n);
  if (!forward) // where it vanishes
    gap += dt * pair.gap.row * columns.middleRows(layout.velocity(), n);
  for (Index k = 0; k < n_keys; ++k)
    gap[first_key + k] +=
        keys[static_cast<std::size_t>(k)]->gap(interval.contact, interval.zero, at_zero);
  const double gap_rate =
      equations.local_state(interval.contact, interval.zero, view(at_zero)).gap_rate;
  const RowVector shift = gap / gap_rate;
  Matrix rest = columns - rates.head(size) * shift;
  rest.topRows(n) += 0.5 * dt * rest.middleRows(layout.velocity(), n);

  const double middle = 0.5 * (interval.zero + interval.other);
  const Vector state = state_after(equations, at_zero, rates_at_zero, middle - interval.zero);
  Matrix jacobian;
  equations.jacobian(middle, view(state), jacobian);
  Matrix change = jacobian.topLeftCorner(size, size) * rest;
  RowVector gap_of_rest = pair.gap.row * rest.topRows(n);
  for (Index k = 0; k < n_keys; ++k) {
    KeyTangent &key = *keys[static_cast<std::size_t>(k)];
    change.col(first_key + k) += key.rates(equations, middle, state);
    gap_of_rest[first_key + k] += key.gap(interval.contact, middle, state);
  }
  contact::LawResponse response;
  pair.law->evaluate(equations.modes()[interval.contact],
                     equations.local_state(interval.contact, middle, view(state)), response);
  change.middleRows(layout.velocity(), n) -=
      response.force_by_gap * equations.response_to(pair.gap.row, middle, view(state)) *
      gap_of_rest;
  columns += gained.head(size) * shift + dt * change;
}

} // namespace vibroimpact::motion
