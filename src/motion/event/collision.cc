#include "motion/event/collision.h"

#include "common/decompositions.h"
#include "contact/impulses.h"
#include "motion/event/leading_acceleration.h"
#include "motion/event/mode_change.h"
#include "motion/event/rubbing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

using contact::Guard;

namespace {

constexpr double small_flights = 8; // in tolerances

// In relative tolerances: no more than what the energy balance of a motion leaves open
// (Accuracy::energy_threshold).
constexpr double negligible_energy_share = 1000;

const Guard *impact_guard(const contact::Mode &mode) {
  const auto found = std::find_if(mode.guards.begin(), mode.guards.end(), [](const Guard &guard) {
    return guard.action == contact::GuardAction::impact;
  });
  return found == mode.guards.end() ? nullptr : &*found;
}

Vector part(const Vector &all, const std::vector<Index> &list) {
  Vector some(static_cast<Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i)
    some[static_cast<Index>(i)] = all[list[i]];
  return some;
}

Matrix part(const Matrix &all, const std::vector<Index> &list) {
  Matrix some(static_cast<Index>(list.size()), static_cast<Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i)
    for (std::size_t j = 0; j < list.size(); ++j)
      some(static_cast<Index>(i), static_cast<Index>(j)) = all(list[i], list[j]);
  return some;
}

} // namespace

struct Collisions::Instant {
  double time = 0, time_tolerance = 0;
  double slow = 0; // speeds below count as none
  std::vector<int> modes;
  std::vector<std::size_t> contacts;
  std::vector<char> held;
  std::vector<int> open_mode, held_mode; // of each contact
  Vector gap, gap_rate, carried;         // carried: part of the gap rate that comes from the base
  Vector restitution;                    // 0 where nothing approaches
  Matrix rows, response, effect;         // W, M^-1 W^T, W M^-1 W^T
  std::vector<Index> taking_part;
  Vector impulse, after;          // after: gap rates
  Vector chatter_durations;       // of the chatters that are left out
  std::optional<Rubbing> rubbing; // where there is friction

  Index size() const { return static_cast<Index>(contacts.size()); }
  bool approaches(Index k) const { return gap_rate[k] < -slow; }
  // What stays together keeps what error it had.
  bool rests(Index k) const {
    return std::abs(after[k]) <=
           slow + (held[static_cast<std::size_t>(k)] ? std::abs(gap_rate[k]) : 0);
  }
};

bool Collisions::touches(std::size_t contact, const contact::LocalState &local, double time,
                         double time_tolerance, const Vector &state) const {
  return std::abs(local.gap) <=
         std::max({scales_.length(contact), 2 * time_tolerance * std::abs(local.gap_rate),
                   equations_.rounding(contact, {.gap = 1}, time, state)});
}

Collisions::Instant Collisions::look(double time, double time_tolerance, std::size_t first,
                                     const Vector &state) const {
  Instant instant;
  instant.time = time;
  instant.time_tolerance = time_tolerance;
  instant.modes = equations_.modes();
  std::vector<double> gap;
  std::vector<double> gap_rate;
  for (std::size_t c = 0; c < equations_.contacts().size(); ++c) {
    const contact::Mode &mode = equations_.mode(c);
    const Guard *impact = impact_guard(mode);
    if (!impact && !mode.holds_gap)
      continue;
    const contact::LocalState local =
        equations_.local_state(c, time, ConstVectorView(state.data(), state.size()));
    if (c != first && !mode.holds_gap && !touches(c, local, time, time_tolerance, state))
      continue;
    instant.contacts.push_back(c);
    instant.held.push_back(mode.holds_gap ? 1 : 0);
    instant.open_mode.push_back(mode.holds_gap ? mode.guards.front().target
                                               : equations_.modes()[c]);
    instant.held_mode.push_back(mode.holds_gap ? equations_.modes()[c] : impact->target);
    instant.slow = std::max(instant.slow, scales_.speed(c));
    gap.push_back(local.gap);
    gap_rate.push_back(local.gap_rate);
  }
  const Index size = instant.size();
  const StateLayout &layout = equations_.layout();
  instant.gap = ConstVectorView(gap.data(), size);
  instant.gap_rate = ConstVectorView(gap_rate.data(), size);
  instant.rows.resize(size, layout.n);
  for (Index k = 0; k < size; ++k)
    instant.rows.row(k) = equations_.row_along(instant.contacts[static_cast<std::size_t>(k)], 0,
                                               time, ConstVectorView(state.data(), state.size()));
  instant.carried = instant.gap_rate - instant.rows * state.segment(layout.velocity(), layout.n);
  instant.response =
      equations_.response_to(instant.rows, time, ConstVectorView(state.data(), state.size()));
  instant.effect = instant.rows * instant.response;
  instant.restitution = Vector::Zero(size);
  instant.impulse = Vector::Zero(size);
  instant.after = instant.gap_rate;
  instant.chatter_durations = Vector::Zero(size);
  if (Rubbing::holds(equations_, instant.contacts))
    instant.rubbing.emplace(equations_, instant.contacts, time, state);
  for (Index k = 0; k < size; ++k) {
    const std::size_t c = instant.contacts[static_cast<std::size_t>(k)];
    if (instant.held[static_cast<std::size_t>(k)] || instant.gap_rate[k] <= instant.slow)
      instant.taking_part.push_back(k);
    if (!instant.held[static_cast<std::size_t>(k)] && instant.approaches(k))
      instant.restitution[k] =
          equations_.contacts().pairs()[c].law->restitution(-instant.gap_rate[k]);
  }
  return instant;
}

void Collisions::find_impulses(Instant &instant) const {
  if (instant.rubbing) {
    instant.rubbing->find(instant.taking_part, instant.restitution);
    instant.impulse = instant.rubbing->normal_impulses();
    instant.after = instant.rubbing->normal_rates_after();
    return;
  }
  const Vector wanted = instant.restitution.cwiseProduct((-instant.gap_rate).cwiseMax(0));
  const Vector found = contact::newton_impulses(part(instant.effect, instant.taking_part),
                                                part(instant.gap_rate, instant.taking_part),
                                                part(wanted, instant.taking_part));
  instant.impulse.setZero();
  for (std::size_t i = 0; i < instant.taking_part.size(); ++i)
    instant.impulse[instant.taking_part[i]] = found[static_cast<Index>(i)];
  instant.after = instant.gap_rate + instant.effect * instant.impulse;
  // The rule itself, where it holds, without the rounding of the solution.
  for (const Index k : instant.taking_part)
    if (instant.impulse[k] > 0)
      instant.after[k] = wanted[k];
}

double Collisions::gap_acceleration(std::size_t contact, double time, const Vector &state,
                                    int direction) const {
  return present_acceleration(equations_, contact, time, state, direction);
}

double Collisions::leaning(std::size_t contact, double time, const Vector &state,
                           int direction) const {
  return leading_acceleration(equations_, contact, time, state, direction);
}

// Where rounding moves the gap by d from one impact to the next, the speed v follows
// v^2 <- e^2 (v^2 + 2 a d), which does not fall below 2 a d e^2 / (1 - e^2): flights lower than
// d / (1 - e^2) would never end.
double Collisions::negligible_height(const Instant &instant, std::size_t k) const {
  const double e = instant.restitution[static_cast<Index>(k)];
  const double rounding = scales_.rounding(instant.contacts[k]);
  return small_flights *
         std::max(scales_.length(instant.contacts[k]), e < 1 ? rounding / (1 - e * e) : rounding);
}

bool Collisions::negligible_energy(const Instant &instant, std::size_t k,
                                   const Vector &state) const {
  if (instant.restitution[static_cast<Index>(k)] < 1)
    return false;
  const auto place = static_cast<Index>(k);
  const double speed = instant.after[place];
  const double mass = 1 / instant.effect(place, place);
  return 0.5 * mass * speed * speed <=
         negligible_energy_share * settings_.relative_tolerance *
             equations_.stored_energy(instant.time, ConstVectorView(state.data(), state.size()));
}

// Zero: no chatter, or one that must be followed further. `after`: the state after the impulses.
double Collisions::chatter_duration(const Instant &instant, std::size_t k, const Vector &after) {
  const double speed = instant.after[static_cast<Index>(k)];
  const double restitution = instant.restitution[static_cast<Index>(k)];
  const double falling = -gap_acceleration(instant.contacts[k], instant.time, after);
  if (falling <= 0)
    return 0;
  const double flight = 2 * speed / falling;
  const double duration = restitution < 1 ? flight / (1 - restitution) : flight;
  if (flight <= small_flights * instant.time_tolerance)
    return duration;
  if (speed * speed / (2 * falling) > negligible_height(instant, k) &&
      !negligible_energy(instant, k, after))
    return 0;
  Vector rates(after.size());
  equations_.rates(instant.time, ConstVectorView(after.data(), after.size()),
                   VectorView(rates.data(), rates.size()));
  const Vector later = after + duration * rates;
  const double then = -gap_acceleration(instant.contacts[k], instant.time + duration, later);
  return then > 0.5 * falling ? duration : 0;
}

void Collisions::complete_chatter(Instant &instant, const Vector &state) {
  std::vector<char> bouncing(instant.contacts.size());
  for (std::size_t k = 0; k < bouncing.size(); ++k)
    bouncing[k] = instant.restitution[static_cast<Index>(k)] > 0 &&
                          instant.after[static_cast<Index>(k)] > instant.slow
                      ? 1
                      : 0;
  if (std::find(bouncing.begin(), bouncing.end(), 1) == bouncing.end())
    return;
  Vector after = state;
  apply(instant, after);
  choose_modes(instant, after, bouncing);
  bool found = false;
  for (std::size_t k = 0; k < bouncing.size(); ++k)
    if (bouncing[k]) {
      const double duration = chatter_duration(instant, k, after);
      instant.chatter_durations[static_cast<Index>(k)] = duration;
      if (duration > 0) {
        instant.restitution[static_cast<Index>(k)] = 0;
        found = true;
      }
    }
  if (found)
    find_impulses(instant);
}

// Velocities, and the work integrals: the impulse p of a contact takes p (gap_rate- + gap_rate+) /
// 2 from the energy of the bodies, and a moving base puts its share in.
void Collisions::apply(const Instant &instant, Vector &state) const {
  if (instant.rubbing)
    return instant.rubbing->apply(state);
  const StateLayout &layout = equations_.layout();
  state.segment(layout.velocity(), layout.n) += instant.response * instant.impulse;
  const Vector after = instant.rows * state.segment(layout.velocity(), layout.n) + instant.carried;
  for (Index k = 0; k < instant.size(); ++k) {
    const double impulse = instant.impulse[k];
    const auto contact = static_cast<Index>(instant.contacts[static_cast<std::size_t>(k)]);
    const double carried = -impulse * instant.carried[k];
    state[layout.impulse(contact)] += impulse;
    state[layout.contact_work(contact)] -= 0.5 * impulse * (instant.gap_rate[k] + after[k]);
    state[layout.input_work()] += carried;
    state[layout.absolute_input_work()] += std::abs(carried);
  }
}

// `bouncing` ones stay open whatever their speed.
void Collisions::choose_modes(const Instant &instant, const Vector &state,
                              const std::vector<char> &bouncing) {
  std::vector<Index> resting;
  for (Index k = 0; k < instant.size(); ++k) {
    const auto place = static_cast<std::size_t>(k);
    equations_.set_mode(instant.contacts[place], instant.open_mode[place]);
    if (!bouncing[place] && instant.rests(k))
      resting.push_back(k);
  }
  if (instant.rubbing)
    return rest_rubbing(instant, state, resting);
  Vector accelerations(static_cast<Index>(resting.size()));
  for (std::size_t i = 0; i < resting.size(); ++i)
    accelerations[static_cast<Index>(i)] =
        leaning(instant.contacts[static_cast<std::size_t>(resting[i])], instant.time, state);
  const Vector forces =
      contact::solve_complementarity(part(instant.effect, resting), accelerations);
  for (std::size_t i = 0; i < resting.size(); ++i)
    if (forces[static_cast<Index>(i)] > 0) {
      const auto place = static_cast<std::size_t>(resting[i]);
      equations_.set_mode(instant.contacts[place], instant.held_mode[place]);
    }
}

void Collisions::rest_rubbing(const Instant &instant, const Vector &state,
                              const std::vector<Index> &resting) {
  Vector accelerations = Vector::Zero(2 * static_cast<Index>(resting.size()));
  std::vector<RestingContact> list;
  for (std::size_t i = 0; i < resting.size(); ++i) {
    const auto place = static_cast<std::size_t>(resting[i]);
    const std::size_t c = instant.contacts[place];
    for (int d = 0; d < (instant.rubbing->has_friction(resting[i]) ? 2 : 1); ++d)
      accelerations[2 * static_cast<Index>(i) + d] = leaning(c, instant.time, state, d);
    list.push_back(
        {.place = resting[i], .mode = instant.held_mode[place], .slow = scales_.speed(c)});
  }
  const std::vector<int> chosen = instant.rubbing->modes_at_rest(list, accelerations, state);
  for (std::size_t i = 0; i < resting.size(); ++i)
    if (chosen[i] >= 0)
      equations_.set_mode(instant.contacts[static_cast<std::size_t>(resting[i])], chosen[i]);
}

void Collisions::record_struck(const Instant &instant, const std::vector<Index> &struck,
                               Collision &record) const {
  if (instant.rubbing) {
    instant.rubbing->record(struck, record);
    return;
  }
  for (const Index k : struck)
    record.contacts.push_back(instant.contacts[static_cast<std::size_t>(k)]);
  record.directions.assign(struck.size(), 0);
  record.rows = instant.rows(struck, Eigen::all);
  record.response.resize(equations_.layout().n, static_cast<Index>(struck.size()));
  for (std::size_t i = 0; i < struck.size(); ++i)
    record.response.col(static_cast<Index>(i)) = instant.response.col(struck[i]);
  const Vector factor = part(instant.restitution, struck).array() + 1;
  if (!struck.empty())
    record.impulse_by_rate =
        -least_norm_solution(part(instant.effect, struck), Matrix(factor.asDiagonal()));
}

Collisions::Outcome Collisions::report(const Instant &instant, std::size_t first) const {
  Outcome outcome;
  outcome.touching = instant.contacts;
  outcome.gaps.assign(instant.gap.begin(), instant.gap.end());
  outcome.record.modes_before = instant.modes;
  outcome.record.modes_after = equations_.modes();
  std::vector<Index> struck;
  Index approaching = 0;
  for (Index k = 0; k < instant.size(); ++k) {
    const std::size_t c = instant.contacts[static_cast<std::size_t>(k)];
    const bool was_held = instant.held[static_cast<std::size_t>(k)] != 0;
    const bool took = instant.impulse[k] > 0;
    approaching += instant.approaches(k) ? 1 : 0;
    if (took)
      struck.push_back(k);
    const Change change{.contact = c,
                        .from = instant.modes[c],
                        .to = equations_.modes()[c],
                        .onset = !was_held && (took || equations_.mode(c).in_contact),
                        .gap = instant.gap[k],
                        .gap_rate = instant.gap_rate[k],
                        .gap_rate_after = instant.after[k],
                        .chatter_duration = instant.chatter_durations[k]};
    if (change.onset || change.from != change.to)
      outcome.changes.insert(c == first ? outcome.changes.begin() : outcome.changes.end(), change);
  }
  for (std::size_t c = 0; c < instant.modes.size(); ++c)
    if (!equations_.contacts().pairs()[c].tangential.empty() &&
        equations_.modes()[c] != instant.modes[c] &&
        std::ranges::find(instant.contacts, c) == instant.contacts.end())
      outcome.changes.push_back(
          {.contact = c, .from = instant.modes[c], .to = equations_.modes()[c]});
  record_struck(instant, struck, outcome.record);
  outcome.record.unique = approaching <= 1;
  outcome.reduced = instant.rubbing ? instant.rubbing->reduced() : 0;
  return outcome;
}

Collisions::Outcome Collisions::resolve(double time, double time_tolerance, std::size_t first,
                                        bool last, Vector &state) {
  Instant instant = look(time, time_tolerance, first, state);
  if (last)
    instant.restitution.setZero();
  find_impulses(instant);
  complete_chatter(instant, state);
  apply(instant, state);
  choose_modes(instant, state, std::vector<char>(instant.contacts.size(), 0));
  renew_friction(equations_, scales_, time, state);
  if (instant.rubbing && !equations_.holding().empty())
    equations_.stop_slip(time, state);
  return report(instant, first);
}

void Collisions::settle(double time, double time_tolerance, Vector &state) {
  const Instant instant =
      look(time, time_tolerance, std::numeric_limits<std::size_t>::max(), state);
  choose_modes(instant, state, std::vector<char>(instant.contacts.size(), 0));
  if (instant.rubbing && !equations_.holding().empty())
    equations_.stop_slip(time, state);
}

} // namespace vibroimpact::motion
