#include "motion/event/contact_scales.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

namespace {
constexpr double rounding_factor = Equations::rounding_factor;
// Of the integration. No bound but found by trial: it must lie above the error that integration
// leaves of what is held, and below any gap that matters (tests/motion/scaled_models.cc).
constexpr double share = 1e-11;
} // namespace

void ContactScales::Sizes::include(const Sizes &other) {
  gap = std::max(gap, other.gap);
  gap_rate = std::max(gap_rate, other.gap_rate);
}

ContactScales::ContactScales(const Equations &equations, const Settings &settings)
    : equations_(equations), highest_(equations.model().highest_frequency()),
      absolute_(settings.absolute_tolerance), absolute_speed_(absolute_ * highest_),
      turning_time_((equations.model().mass().array() /
                     equations.model().stiffness().diagonal.array().max(0.0))
                        .sqrt()),
      of_(equations.contacts().size()), slopes_(equations.contacts().size()),
      margins_(equations.contacts().size()) {}

void ContactScales::begin(double time, const Vector &state) {
  time_ = time;
  of_.assign(of_.size(), {});
  slopes_.assign(of_.size(), {});
  for (std::size_t c = 0; c < of_.size(); ++c)
    margins_[c].assign(equations_.contacts().pairs()[c].law->modes().size(), 0.0);
  largest_ = {};
  acceleration_ = 0;
  note(time, state, true);
}

void ContactScales::note(double time, const Vector &state, bool with_forces) {
  const double elapsed = time - time_;
  time_ = time;
  for (std::size_t c = 0; c < of_.size(); ++c) {
    of_[c].include(terms(c, time, state, elapsed));
    largest_.include(of_[c]);
    if (equations_.sees_normal_force(c))
      include_slopes(c, time, state);
    if (with_forces)
      include_forces(c, time, state);
    if (equations_.mode(c).sees_margin)
      include_margin(c, time, state);
  }
}

// A coordinate that does not oscillate counts with its way since the last look.
ContactScales::Sizes ContactScales::terms(std::size_t contact, double time, const Vector &state,
                                          double elapsed) const {
  const contact::ContactPair &pair = equations_.contacts().pairs()[contact];
  Sizes largest{};
  for (int d = 0; d < pair.n_directions(); ++d)
    largest.include(terms(pair.along(d), time, state, elapsed));
  return largest;
}

ContactScales::Sizes ContactScales::terms(const contact::Direction &along, double time,
                                          const Vector &state, double elapsed) const {
  const StateLayout &layout = equations_.layout();
  const model::Projection &projection = *along.projection;
  Sizes terms{.gap = std::abs(along.offset), .gap_rate = std::abs(along.speed)};
  for (Index j = 0; j < layout.n; ++j) {
    const double row = std::abs(projection.row[j]);
    const double q = std::abs(state[j]);
    const double v = std::abs(state[layout.velocity() + j]);
    terms.gap += row * (q + v * std::min(elapsed, turning_time_[j]));
    terms.gap_rate += row * (v + q / turning_time_[j]);
  }
  for (std::size_t k = 0; k < projection.base_coefficients.size(); ++k) {
    const double factor = projection.base_coefficients[k];
    if (factor == 0)
      continue;
    const model::TimeFunction &function = *equations_.model().sources()[k].function;
    terms.gap += std::abs(factor * function.value(equations_.source_time(time)));
    terms.gap_rate += std::abs(factor * function.rate(equations_.source_time(time)));
  }
  return terms;
}

void ContactScales::include_forces(std::size_t contact, double time, const Vector &state) {
  const int directions = equations_.contacts().pairs()[contact].n_directions();
  for (int d = 0; d < directions; ++d)
    acceleration_ = std::max(
        acceleration_, equations_.acceleration_rounding(contact, time, state, d) / rounding_factor);
  if (highest_ > 0 && std::isfinite(acceleration_))
    largest_.include(
        {.gap = acceleration_ / (highest_ * highest_), .gap_rate = acceleration_ / highest_});
}

void ContactScales::include_slopes(std::size_t contact, double time, const Vector &state) {
  contact::LawResponse response;
  equations_.contacts().pairs()[contact].law->evaluate(
      equations_.modes()[contact],
      equations_.local_state(contact, time, ConstVectorView(state.data(), state.size())), response);
  slopes_[contact].include(
      {.gap = std::abs(response.force_by_gap), .gap_rate = std::abs(response.force_by_gap_rate)});
}

void ContactScales::include_margin(std::size_t contact, double time, const Vector &state) {
  double &largest = margins_[contact][static_cast<std::size_t>(equations_.modes()[contact])];
  largest = std::max(
      largest, error(contact, equations_.margin_gradient(
                                  contact, time, ConstVectorView(state.data(), state.size()))));
}

// What a form has of the normal force by value and of its rate, for errors of gap, gap rate and gap
// acceleration.
double ContactScales::of_normal_force(std::size_t contact, const contact::AffineForm &form,
                                      double length, double speed, double acceleration) const {
  const Sizes &slopes = slopes_[contact];
  return std::abs(form.normal_force) * (slopes.gap * length + slopes.gap_rate * speed) +
         std::abs(form.normal_force_rate) * (slopes.gap * speed + slopes.gap_rate * acceleration);
}

double ContactScales::rounding(std::size_t contact) const {
  return rounding_factor * of_[contact].gap;
}

double ContactScales::length(std::size_t contact) const {
  return rounding(contact) + share * largest_.gap + absolute_;
}

double ContactScales::speed(std::size_t contact) const {
  return rounding_factor * of_[contact].gap_rate + share * largest_.gap_rate + absolute_speed_;
}

// In a circular gap the contact acts along any direction across its axis.
double ContactScales::mass_along(std::size_t contact, int direction) const {
  const contact::ContactSet &contacts = equations_.contacts();
  const auto mass = [&](int d) { return contacts.effective_mass(contact, equations_.model(), d); };
  return contacts.pairs()[contact].circle ? std::min(mass(0), mass(1)) : mass(direction);
}

double ContactScales::error(std::size_t contact, const contact::AffineForm &form) const {
  double sum = 0;
  const int directions = equations_.contacts().pairs()[contact].n_directions();
  for (int d = 0; d < directions; ++d) {
    const contact::DirectionForm of = form.along(d);
    sum += std::abs(of.position) * length(contact) + std::abs(of.rate) * speed(contact);
  }
  for (const double coefficient : form.internal)
    sum += std::abs(coefficient) * length(contact);
  const double of_forces = share * acceleration_ + absolute_speed_ * highest_;
  const bool by_value = equations_.sees_normal_force(contact);
  if (by_value)
    sum += of_normal_force(contact, form, length(contact), speed(contact), of_forces);
  for (int d = by_value ? 1 : 0; d < directions; ++d)
    if (const double factor = form.along(d).force; factor != 0)
      sum += std::abs(factor) * mass_along(contact, d) * of_forces;
  if (form.margin != 0)
    sum += std::abs(form.margin) *
           margins_[contact][static_cast<std::size_t>(equations_.modes()[contact])];
  return sum;
}

double ContactScales::error_of_step(std::size_t contact, const contact::AffineForm &form,
                                    double end, const Vector &state) const {
  const contact::ContactPair &pair = equations_.contacts().pairs()[contact];
  double sum = 0;
  for (int d = 0; d < pair.n_directions(); ++d) {
    const Sizes sizes = terms(pair.along(d), end, state, 0);
    const contact::DirectionForm of = form.along(d);
    sum += share * (std::abs(of.position) * sizes.gap + std::abs(of.rate) * sizes.gap_rate);
    if (d == 0 && equations_.sees_normal_force(contact))
      sum += of_normal_force(contact, form, share * sizes.gap, share * sizes.gap_rate,
                             share * acceleration_);
  }
  if (form.margin != 0)
    sum += std::abs(form.margin) *
           error_of_step(contact,
                         equations_.margin_gradient(contact, end,
                                                    ConstVectorView(state.data(), state.size())),
                         end, state);
  return sum;
}

} // namespace vibroimpact::motion
