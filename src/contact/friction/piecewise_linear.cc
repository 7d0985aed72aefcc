#include "contact/friction/piecewise_linear.h"

#include "contact/friction/stick_and_slip.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace vibroimpact::contact {

namespace {

constexpr const char *section_name = "Piecewise-linear";
constexpr int stick = 0;
constexpr int most_pieces = 100;

bool is_constant(const AffineForm &form) {
  AffineForm rest = form;
  rest.constant = 0;
  return rest.zero();
}

} // namespace

void PiecewiseLinear::declare(parameters::Section &friction) {
  using namespace parameters;
  friction
      .subsection(section_name, "Friction whose coefficient is a polygon of the slip speed; the "
                                "sides stick until the force that this takes reaches the static "
                                "coefficient times the normal force.")
      .quantities("Speeds", "", dimension::velocity, range::non_negative, "v_i",
                  "Slip speeds of the corners, rising from 0; above the last one the coefficient "
                  "stays.",
                  1, most_pieces)
      .required()
      .quantities("Coefficients", "", dimension::none, range::positive, "\\mu_i",
                  "Friction force over normal force at these speeds.", 1, most_pieces)
      .required()
      .quantity(
          "Static coefficient", "", dimension::none, range::positive, "\\mu_s",
          "The same at which the sides begin to slip. Without it: the first of Coefficients.");
}

std::shared_ptr<const TangentialLaw> PiecewiseLinear::create(const parameters::Values &friction) {
  const parameters::Values law = friction.subsection(section_name);
  law.require("Speeds");
  law.require("Coefficients");
  std::vector<double> speeds = law.quantities("Speeds");
  std::vector<double> coefficients = law.quantities("Coefficients");
  if (speeds.front() != 0 ||
      std::adjacent_find(speeds.begin(), speeds.end(), std::greater_equal<>()) != speeds.end())
    law.reject("Speeds", "Speeds must begin with 0 and rise.");
  if (coefficients.size() != speeds.size())
    law.reject("Coefficients", "Coefficients must be as many as Speeds.");
  const double at_rest =
      law.has("Static coefficient") ? law.quantity("Static coefficient") : coefficients.front();
  if (at_rest < coefficients.front())
    law.reject("Static coefficient",
               "Static coefficient must not be less than the first of Coefficients.");
  return std::make_shared<PiecewiseLinear>(std::move(speeds), std::move(coefficients), at_rest);
}

PiecewiseLinear::Piece PiecewiseLinear::piece(std::size_t i) const {
  if (i + 1 == speeds_.size())
    return {.level = coefficients_[i]};
  const double slope = (coefficients_[i + 1] - coefficients_[i]) / (speeds_[i + 1] - speeds_[i]);
  return {.level = coefficients_[i] - slope * speeds_[i], .slope = slope};
}

// Stick, the pieces forward, the pieces backward.
int PiecewiseLinear::mode_of(double sigma, std::size_t piece) const {
  return 1 + static_cast<int>(piece + (sigma > 0 ? 0 : speeds_.size()));
}

TangentialMode PiecewiseLinear::slip(double sigma, std::size_t i,
                                     const AffineForm &normal_force) const {
  TangentialMode mode = slip_along(sigma, stick);
  const auto [level, slope] = piece(i);
  mode.evaluated = slope != 0 && !is_constant(normal_force);
  mode.force[0] = -sigma * level * normal_force;
  mode.force[0].tangential[0].rate -= slope * normal_force.constant;
  const AffineForm speed = mode.sliding_speed;
  if (i > 0)
    mode.guards = {{.indicator = speed + AffineForm{.constant = -speeds_[i]},
                    .target = mode_of(sigma, i - 1)}};
  if (i + 1 < speeds_.size())
    mode.guards.push_back({.indicator = -1.0 * speed + AffineForm{.constant = speeds_[i + 1]},
                           .target = mode_of(sigma, i + 1)});
  if (speeds_.size() > 1)
    mode.name += " " + std::to_string(i + 1);
  return mode;
}

std::vector<TangentialMode> PiecewiseLinear::modes(const AffineForm &normal_force,
                                                   std::size_t /*first_internal*/) const {
  std::vector<TangentialMode> modes = {
      stick_until(static_coefficient_ * normal_force, mode_of(1, 0), mode_of(-1, 0))};
  for (const double sigma : {1.0, -1.0})
    for (std::size_t i = 0; i < speeds_.size(); ++i)
      modes.push_back(slip(sigma, i, normal_force));
  return modes;
}

int PiecewiseLinear::mode_by_slip(int /*mode*/, const LocalState &state,
                                  std::size_t /*first_internal*/) const {
  const double slip_rate = state.tangential[0].slip_rate;
  if (slip_rate == 0)
    return stick;
  const auto above = std::upper_bound(speeds_.begin(), speeds_.end(), std::abs(slip_rate));
  return mode_of(slip_rate, static_cast<std::size_t>(above - speeds_.begin()) - 1);
}

void PiecewiseLinear::evaluate(int mode, const LocalState &state, std::size_t /*first_internal*/,
                               TangentialValues &values) const {
  const auto place = static_cast<std::size_t>(mode - 1);
  const double sigma = place < speeds_.size() ? 1 : -1;
  const auto [level, slope] = piece(place % speeds_.size());
  const double v = state.tangential[0].slip_rate;
  const double per_force = -sigma * level - slope * v;
  values.force[0].value = per_force * state.normal_force;
  values.force[0].by = {.normal_force = per_force};
  values.force[0].by.tangential[0].rate = -slope * state.normal_force;
  values.sliding_speed = sigma * v;
}

} // namespace vibroimpact::contact
