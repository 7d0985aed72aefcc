#include "contact/friction/planar_coulomb.h"

#include <cmath>

namespace vibroimpact::contact {

namespace {

enum : int { stick = 0, slip = 1, stopping = 2, starting = 3 };
constexpr std::size_t directions = 2;
using Plane = std::array<double, directions>;

Plane slip_rate(const LocalState &state) {
  return {state.tangential[0].slip_rate, state.tangential[1].slip_rate};
}

Plane kept_direction(const LocalState &state, std::size_t first_internal) {
  return {state.internal[first_internal], state.internal[first_internal + 1]};
}

Plane unit(const Plane &a) {
  const double size = std::hypot(a[0], a[1]);
  return size > 0 ? Plane{a[0] / size, a[1] / size} : Plane{};
}

// Partial derivatives by the slip rates and the direction that is kept.
TangentialValue value_of_slip(double value, std::size_t first_internal) {
  TangentialValue made{.value = value, .by = {}};
  made.by.internal.assign(first_internal + directions, 0.0);
  return made;
}

// d(w / |w|)_i / dw_j
double turning(const Plane &w, const Plane &along, std::size_t i, std::size_t j) {
  const double size = std::hypot(w[0], w[1]);
  return size > 0 ? ((i == j ? 1.0 : 0.0) - along[i] * along[j]) / size : 0;
}

void add_turning(std::size_t i, const LocalState &state, const Plane &along, double most,
                 std::size_t first_internal, TangentialValues &values) {
  for (std::size_t j = 0; j < directions; ++j)
    values.force[i].by.internal[first_internal + j] =
        -most * turning(kept_direction(state, first_internal), along, i, j);
}

} // namespace

std::shared_ptr<const TangentialLaw> PlanarCoulomb::create(const parameters::Values &friction) {
  return std::make_shared<PlanarCoulomb>(read_coulomb(friction));
}

std::vector<TangentialMode> PlanarCoulomb::modes(const AffineForm &normal_force,
                                                 std::size_t /*first_internal*/) const {
  std::vector<TangentialMode> modes = {{.name = "stick", .friction = Friction::stick},
                                       {.name = "slip", .friction = Friction::slip},
                                       {.name = "stopping", .friction = Friction::slip},
                                       {.name = "starting", .friction = Friction::slip}};
  modes[stick].holds_slip = true;
  modes[stick].limit = LimitCircle{.radius = constants_.static_coefficient * normal_force};
  Guard yields{.indicator = {.margin = 1}, .target = starting};
  Guard slows{.indicator = {.margin = 1}, .target = stopping};
  for (int d = 1; d <= static_cast<int>(directions); ++d) {
    const AffineForm held = AffineForm::force_along(d);
    modes[stick].limit->across[static_cast<std::size_t>(d - 1)] = held;
    yields.reset.push_back(-1.0 * held);
    slows.reset.push_back(AffineForm::rate_along(d));
  }
  modes[stick].guards = {yields};
  modes[slip].guards = {slows};
  modes[stopping].guards = {{.indicator = {.margin = 1}, .target = stopping, .by_slip = true}};
  modes[starting].guards = {{.indicator = {.margin = 1}, .target = slip}};
  for (TangentialMode &mode : modes) {
    mode.internal_rate.resize(directions);
    mode.evaluated = !mode.holds_slip;
  }
  return modes;
}

// A slip that was to stop has done so, unless it is faster than where that was thought of.
int PlanarCoulomb::mode_by_slip(int mode, const LocalState &state,
                                std::size_t /*first_internal*/) const {
  const Plane v = slip_rate(state);
  const double speed = std::hypot(v[0], v[1]);
  const bool stopped = mode == stopping && speed < 2 * state.slow_slip;
  return speed == 0 || stopped ? stick : slip;
}

std::vector<InternalState> PlanarCoulomb::internal_states() const {
  std::vector<InternalState> states;
  for (const char *which : {"first", "second"})
    states.push_back({.name = std::string("friction_course_") + (states.empty() ? "1" : "2"),
                      .unit = "1",
                      .description = std::string("Along which a slow slip began or ends, in "
                                                 "any size: part along the ") +
                                     which + " direction of friction"});
  return states;
}

void PlanarCoulomb::evaluate(int mode, const LocalState &state, std::size_t first_internal,
                             TangentialValues &values) const {
  const Plane v = slip_rate(state);
  const double speed = std::hypot(v[0], v[1]);
  const bool slides = mode == slip;
  const Plane along = unit(slides ? v : kept_direction(state, first_internal));
  const double most = constants_.coefficient * state.normal_force;
  values.internal_rate.assign(directions, {});
  for (std::size_t i = 0; i < directions; ++i) {
    TangentialValue &force = values.force[i];
    force = value_of_slip(-most * along[i] - constants_.damping_constant * v[i], first_internal);
    force.by.normal_force = -constants_.coefficient * along[i];
    force.by.tangential[i].rate = -constants_.damping_constant;
    for (std::size_t j = 0; j < directions && slides && speed > 0; ++j)
      force.by.tangential[j].rate -= most * ((i == j ? 1.0 : 0.0) - along[i] * along[j]) / speed;
    if (!slides)
      add_turning(i, state, along, most, first_internal, values);
  }
  values.sliding_speed = speed;
  values.margin = margin(mode, state, along, first_internal);
}

// Of slip |v|^2 - s^2, of a start 4 s^2 - |v|^2, of a stop w . v - |v|^2 / (4 s) with w of length
// 1: that is zero where the sides have stopped, and where they go on faster after all.
TangentialValue PlanarCoulomb::margin(int mode, const LocalState &state,
                                      const std::array<double, 2> &along,
                                      std::size_t first_internal) const {
  const Plane v = slip_rate(state);
  const double slow = state.slow_slip;
  TangentialValue margin = value_of_slip(0, first_internal);
  const double square = mode == slip ? 1 : mode == starting ? -1 : slow > 0 ? -0.25 / slow : 0;
  const double forward = mode == stopping ? 1 : 0;
  margin.value = mode == slip ? -slow * slow : mode == starting ? 4 * slow * slow : 0;
  for (std::size_t i = 0; i < directions; ++i) {
    margin.value += (forward * along[i] + square * v[i]) * v[i];
    margin.by.tangential[i].rate = forward * along[i] + 2 * square * v[i];
  }
  if (mode == stopping)
    for (std::size_t i = 0; i < directions; ++i)
      for (std::size_t j = 0; j < directions; ++j)
        margin.by.internal[first_internal + j] +=
            turning(kept_direction(state, first_internal), along, i, j) * v[i];
  return margin;
}

} // namespace vibroimpact::contact
