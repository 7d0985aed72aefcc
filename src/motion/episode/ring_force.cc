#include "motion/episode/ring_force.h"

namespace vibroimpact::motion {

using contact::AffineForm;
using contact::CircularFrame;
using contact::LocalState;

RingForce::RingForce(const contact::ContactPair &pair, int mode)
    : LawForce(*pair.law, mode), circle_(*pair.circle) {}

CircularFrame RingForce::frame(const Motions &at, int instant) const {
  const auto i = static_cast<std::size_t>(instant);
  const double touching = circle_.sense() * circle_.clearance();
  return circle_.frame({.position = {-(touching + at.places[0][i]), at.places[1][i]},
                        .rate = {-at.rates[0][i], at.rates[1][i]}});
}

LocalState RingForce::local(const CircularFrame &frame, const Motions &at, int instant) const {
  const auto i = static_cast<std::size_t>(instant);
  LocalState state{.internal = internal_};
  circle_.see(frame, state);
  const double inwards = at.places[0][i];
  const double along = at.places[1][i];
  const double sense = circle_.sense();
  state.gap = -sense *
              (2 * sense * circle_.clearance() * inwards + inwards * inwards + along * along) /
              (frame.distance + circle_.clearance());
  return state;
}

LocalState RingForce::local(const Motions &at, int instant) const {
  return local(frame(at, instant), at, instant);
}

// With g' = n . u' and du = (-dw_0, dw_1): the form of -g' has the derivatives of the rate.
Overlap RingForce::overlap(const Motions &at, int instant) const {
  const CircularFrame here = frame(at, instant);
  const LocalState state = local(here, at, instant);
  const AffineForm gap = circle_.gradient(here, {.gap = 1});
  const AffineForm rate = circle_.gradient(here, {.gap_rate = 1});
  return {.penetration = -state.gap,
          .rate = -state.gap_rate,
          .by_place = {gap.gap, -gap.tangential[0].position},
          .rate_by_place = {rate.gap, -rate.tangential[0].position},
          .rate_by_rate = {rate.gap_rate, -rate.tangential[0].rate}};
}

void RingForce::evaluate(int count, const Motions &at, ForceValues &values) const {
  for (int instant = 0; instant < count; ++instant) {
    const auto i = static_cast<std::size_t>(instant);
    const CircularFrame here = frame(at, instant);
    const LocalState state = local(here, at, instant);
    if (!(state.gap < 0)) {
      for (std::size_t d = 0; d < 2; ++d) {
        values.force[d][i] = 0;
        for (std::size_t by = 0; by < 2; ++by)
          values.by_place[d][by][i] = values.by_rate[d][by][i] = 0;
      }
      values.dissipated[i] = values.normal[i] = values.tangential[i] = 0;
      values.friction_power[i] = values.wear_power[i] = 0;
      continue;
    }
    law().evaluate(mode(), state, response_);
    const contact::AcrossAxis force = circle_.force(here, response_);
    values.force[0][i] = force[0];
    values.force[1][i] = force[1];
    values.dissipated[i] = response_.dissipated_power;
    values.normal[i] = response_.force;
    values.tangential[i] = response_.tangential[0].force;
    values.friction_power[i] = response_.friction_power;
    values.wear_power[i] = response_.force * response_.sliding_speed;
    set_derivatives(here, instant, values);
  }
}

void RingForce::set_derivatives(const CircularFrame &frame, int instant,
                                ForceValues &values) const {
  const auto i = static_cast<std::size_t>(instant);
  const std::array<AffineForm, 2> by = circle_.force_gradient(frame, response_);
  for (std::size_t d = 0; d < 2; ++d) {
    values.by_place[d][0][i] = -by[d].gap;
    values.by_place[d][1][i] = by[d].tangential[0].position;
    values.by_rate[d][0][i] = -by[d].gap_rate;
    values.by_rate[d][1][i] = by[d].tangential[0].rate;
  }
}

} // namespace vibroimpact::motion
