#include "contact/friction/planar_spring_slider.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::contact {

namespace {

enum : int { stick = 0, slip = 1 };
constexpr std::size_t directions = 2;

AffineForm deformation(std::size_t place) {
  AffineForm form{.internal = std::vector<double>(place + 1, 0.0)};
  form.internal.back() = 1;
  return form;
}

TangentialValue value_of_states(double value, std::size_t first_internal) {
  TangentialValue made{.value = value, .by = {}};
  made.by.internal.assign(first_internal + directions, 0.0);
  return made;
}

} // namespace

/// Which way the slider goes: e, and how it turns with what pulls, (1 - e e^T) / |p|.
struct PlanarSpringSlider::Pull {
  std::size_t first = 0; ///< internal state
  std::array<double, directions> along{};
  double size = 0; ///< |p|, or |z| without a dashpot
  double turning[directions][directions] = {};
};

std::shared_ptr<const TangentialLaw>
PlanarSpringSlider::create(const parameters::Values &friction) {
  return std::make_shared<PlanarSpringSlider>(read_spring_slider(friction));
}

std::vector<TangentialMode> PlanarSpringSlider::modes(const AffineForm &normal_force,
                                                      std::size_t first_internal) const {
  TangentialMode sticks{.name = "stick", .friction = Friction::stick};
  sticks.limit = LimitCircle{.radius = constants_.coefficient * normal_force};
  for (std::size_t k = 0; k < directions; ++k) {
    const AffineForm rate = AffineForm::rate_along(static_cast<int>(k) + 1);
    const AffineForm pull =
        constants_.stiffness * deformation(first_internal + k) + constants_.damping_constant * rate;
    sticks.force[k] = -1.0 * pull;
    sticks.internal_rate.push_back(rate);
    sticks.limit->across[k] = pull;
  }
  sticks.guards = {{.indicator = {.margin = 1}, .target = slip}};
  TangentialMode slips{.name = "slip", .friction = Friction::slip};
  slips.internal_rate.resize(directions);
  slips.guards = {{.indicator = {.margin = 1}, .target = stick}};
  slips.evaluated = true;
  slips.sees_force_rate = follows_normal_rate();
  return {sticks, slips};
}

// A jump of the slip rate leaves the spring as it is; the slider goes on only along it.
int PlanarSpringSlider::mode_by_slip(int mode, const LocalState &state,
                                     std::size_t first_internal) const {
  if (mode == stick || state.internal.size() < first_internal + directions)
    return stick;
  double along = 0;
  for (std::size_t k = 0; k < directions; ++k)
    along += state.internal[first_internal + k] * state.tangential[k].slip_rate;
  return along > 0 ? slip : stick;
}

// Without a dashpot the spring pulls as much as the slider gives.
void PlanarSpringSlider::leave(int mode, double normal_force, std::span<double> internal) const {
  const double size = std::hypot(internal[0], internal[1]);
  if (mode != slip || !follows_normal_rate() || size == 0)
    return;
  const double most = constants_.coefficient * normal_force / constants_.stiffness;
  for (double &deformation : internal.first(directions))
    deformation *= most / size;
}

std::vector<InternalState> PlanarSpringSlider::internal_states() const {
  std::vector<InternalState> states;
  for (const char *which : {"first", "second"})
    states.push_back(
        {.name = std::string("friction_deformation_") + (states.empty() ? "1" : "2"),
         .unit = "m",
         .description = std::string("Deformation of the tangential spring along the ") + which +
                        " direction of friction"});
  return states;
}

// Where a contact begins to slide without a force yet, it pulls along the slip rate.
PlanarSpringSlider::Pull PlanarSpringSlider::pull(const LocalState &state,
                                                  std::size_t first_internal) const {
  Pull pull{.first = first_internal};
  std::array<double, directions> p{};
  for (std::size_t k = 0; k < directions; ++k) {
    const double z = state.internal[first_internal + k];
    p[k] = follows_normal_rate() ? z
                                 : constants_.stiffness * z +
                                       constants_.damping_constant * state.tangential[k].slip_rate;
  }
  pull.size = std::hypot(p[0], p[1]);
  if (pull.size == 0) {
    const double speed = std::hypot(state.tangential[0].slip_rate, state.tangential[1].slip_rate);
    for (std::size_t k = 0; k < directions && speed > 0; ++k)
      pull.along[k] = state.tangential[k].slip_rate / speed;
    return pull;
  }
  for (std::size_t k = 0; k < directions; ++k)
    pull.along[k] = p[k] / pull.size;
  for (std::size_t i = 0; i < directions; ++i)
    for (std::size_t j = 0; j < directions; ++j)
      pull.turning[i][j] = ((i == j ? 1.0 : 0.0) - pull.along[i] * pull.along[j]) / pull.size;
  return pull;
}

void PlanarSpringSlider::evaluate(int /*mode*/, const LocalState &state, std::size_t first_internal,
                                  TangentialValues &values) const {
  const Pull pull = this->pull(state, first_internal);
  const double most = constants_.coefficient * state.normal_force;
  const double by_deformation = follows_normal_rate() ? 1 : constants_.stiffness;
  values.internal_rate.assign(directions, value_of_states(0, first_internal));
  for (std::size_t i = 0; i < directions; ++i) {
    TangentialValue &force = values.force[i];
    force = value_of_states(-most * pull.along[i], first_internal);
    force.by.normal_force = -constants_.coefficient * pull.along[i];
    for (std::size_t j = 0; j < directions; ++j) {
      const double turning = -most * pull.turning[i][j];
      force.by.internal[first_internal + j] = turning * by_deformation;
      force.by.tangential[j].rate = turning * constants_.damping_constant;
    }
  }
  values.margin = value_of_states(0, first_internal);
  if (follows_normal_rate())
    follow_normal_rate(state, pull, values);
  else
    relax(state, pull, values);
}

void PlanarSpringSlider::follow_normal_rate(const LocalState &state, const Pull &pull,
                                            TangentialValues &values) const {
  const double by_force_rate = -constants_.coefficient / constants_.stiffness;
  TangentialValue &speed = values.margin;
  speed.value = by_force_rate * state.normal_force_rate;
  speed.by.normal_force_rate = by_force_rate;
  for (std::size_t i = 0; i < directions; ++i) {
    const double v = state.tangential[i].slip_rate;
    speed.value += pull.along[i] * v;
    speed.by.tangential[i].rate = pull.along[i];
    for (std::size_t j = 0; j < directions; ++j)
      speed.by.internal[pull.first + j] += pull.turning[i][j] * v;
  }
  for (std::size_t i = 0; i < directions; ++i) {
    TangentialValue &rate = values.internal_rate[i];
    rate.by = -pull.along[i] * speed.by;
    rate.value = state.tangential[i].slip_rate - pull.along[i] * speed.value;
    rate.by.tangential[i].rate += 1;
    for (std::size_t j = 0; j < directions; ++j)
      rate.by.internal[pull.first + j] -= pull.turning[i][j] * speed.value;
  }
  values.sliding_speed = std::max(0.0, speed.value);
}

void PlanarSpringSlider::relax(const LocalState &state, const Pull &pull,
                               TangentialValues &values) const {
  const auto &[stiffness, coefficient, damping] = constants_;
  const double most = coefficient * state.normal_force;
  for (std::size_t i = 0; i < directions; ++i) {
    const double z = state.internal[pull.first + i];
    TangentialValue &rate = values.internal_rate[i];
    rate.by = -1 / damping * values.force[i].by;
    rate.value = (-values.force[i].value - stiffness * z) / damping;
    rate.by.internal[pull.first + i] -= stiffness / damping;
    values.margin.by.internal[pull.first + i] = 2 * pull.size * pull.along[i] * stiffness;
    values.margin.by.tangential[i].rate = 2 * pull.size * pull.along[i] * damping;
  }
  values.margin.value = (pull.size - most) * (pull.size + most);
  values.margin.by.normal_force = -2 * most * coefficient;
  values.sliding_speed = std::max(0.0, (pull.size - most) / damping);
}

} // namespace vibroimpact::contact
