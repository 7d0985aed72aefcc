#include "motion/steps/error_measure.h"

#include "motion/system/tolerances.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vibroimpact::motion {

using contact::ContactPair;

namespace {

// Of what was large, with each step: after ten of them a third is left. It and part_of_energy are
// no bounds but found by trial: Hertz impacts from 0.1 nm to 0.1 m err by less than twice the
// relative tolerance with them (tests/motion/scales.cc).
constexpr double fading = 0.9;
constexpr double step_epsilon = std::numeric_limits<double>::epsilon();
// A coordinate is followed to the relative tolerance of its own size where it holds more than the
// square of that part of its body's energy.
constexpr double part_of_energy = 1e-3;
// An error estimate is the difference to a result of lower order, far above the error itself; that
// of a gap may be as many tolerances.
constexpr double contact_part = 4;
// Of sums and differences in the stages of a step.
constexpr double step_rounding_factor = 16;

double ratio(double error, double tolerance) {
  return error > 0 ? std::abs(error) / tolerance : 0; // infinite where the tolerance is zero
}

// What contacts push along: their normals, or all directions across the axis of a circular gap.
int n_pushed(const ContactPair &pair) { return pair.circle ? pair.n_directions() : 1; }

double largest_entry(const ContactPair &pair, Index coordinate) {
  double largest = 0;
  for (int d = 0; d < n_pushed(pair); ++d)
    largest = std::max(largest, std::abs(pair.along(d).projection->row[coordinate]));
  return largest;
}

bool is_carried(const ContactPair &pair) {
  bool carried = false;
  for (int d = 0; d < n_pushed(pair); ++d)
    for (const double factor : pair.along(d).projection->base_coefficients)
      carried = carried || factor != 0;
  return carried;
}

} // namespace

ErrorMeasure::ErrorMeasure(const Equations &equations, double relative, double absolute)
    : equations_(equations), relative_(relative),
      absolute_(absolute_tolerances(equations, absolute)), absolute_gap_(absolute),
      internal_scale_by_gap_(Vector::Zero(equations.layout().n_internal)),
      contact_of_internal_(static_cast<std::size_t>(equations.layout().n_internal)) {
  const model::Model &model = equations.model();
  body_.resize(static_cast<std::size_t>(model.size()));
  for (std::size_t b = 0; b < model.bodies().size(); ++b)
    std::fill_n(body_.begin() + model.offset(b), model.bodies()[b]->size(), static_cast<Index>(b));
  const std::vector<ContactPair> &pairs = equations.contacts().pairs();
  for (std::size_t c = 0; c < pairs.size(); ++c) {
    const double mass = equations.contacts().effective_mass(c, model);
    mass_.push_back(std::isfinite(mass) ? mass : 0);
    std::vector<Index> bodies;
    for (Index j = 0; j < model.size(); ++j)
      if (largest_entry(pairs[c], j) != 0 && (bodies.empty() || bodies.back() != body_[j]))
        bodies.push_back(body_[j]);
    bodies_.push_back(std::move(bodies));
    carried_.push_back(is_carried(pairs[c]));
    const std::vector<contact::InternalState> states = pairs[c].law->internal_states();
    for (std::size_t i = 0; i < states.size(); ++i) {
      const Index place = pairs[c].internal_offset + static_cast<Index>(i);
      internal_scale_by_gap_[place] = states[i].unit == "m" ? 1 : 0;
      contact_of_internal_[static_cast<std::size_t>(place)] = c;
    }
  }
}

bool ErrorMeasure::acts(std::size_t contact) const {
  const contact::Mode &mode = equations_.mode(contact);
  return mode.in_contact && !mode.holds_gap && !equations_.inactive(contact);
}

void ErrorMeasure::read_contact(std::size_t contact, const EndPoint &point, Scales &scales) const {
  OfContact &of = scales.of[contact];
  const ConstVectorView x(point.state.data(), point.state.size());
  const contact::LocalState local = equations_.local_state(contact, point.time, x);
  of.gap = std::abs(local.gap);
  of.gap_rate = std::abs(local.gap_rate);
  const StateLayout &layout = equations_.layout();
  of.gap_acceleration = std::abs(equations_.gap_acceleration(
      contact, point.time, x, ConstVectorView(point.rates.data() + layout.velocity(), layout.n)));
  if (!acts(contact))
    return;
  // The potential of a force that does not end with the gap has any sign: below zero it is no size.
  const double stored =
      std::max(0.0, equations_.contact_energy(contact, equations_.modes()[contact], local));
  const double kinetic = mass_[contact] * local.gap_rate * local.gap_rate / 2;
  of.energy = stored + kinetic;
  of.force = std::abs(point.rates[layout.impulse(static_cast<Index>(contact))]);
  for (const contact::TangentialState &along : local.tangential)
    of.sticking += std::abs(along.force);
  of.rounding = step_epsilon * equations_.magnitude(contact, {.gap = 1}, point.time, point.state);
  for (const Index body : bodies_[contact])
    scales.energy[body] += stored;
  scales.turnover += stored;
}

void ErrorMeasure::read(const EndPoint &point, Scales &scales) const {
  const model::Model &model = equations_.model();
  const StateLayout &layout = equations_.layout();
  scales.values = point.state.head(layout.physical_size()).cwiseAbs();
  scales.energy.setZero(static_cast<Index>(model.bodies().size()));
  scales.of.assign(mass_.size(), {});
  for (Index j = 0; j < layout.n; ++j) {
    const double q = point.state[j];
    const double v = point.state[layout.velocity() + j];
    scales.energy[body_[static_cast<std::size_t>(j)]] +=
        0.5 * (model.mass()[j] * v * v + model.stiffness().diagonal[j] * q * q);
  }
  scales.turnover = scales.energy.sum();
  for (std::size_t c = 0; c < mass_.size(); ++c)
    if (equations_.mode(c).holds_gap)
      scales.of[c].force = std::abs(point.rates[layout.impulse(static_cast<Index>(c))]);
    else if (acts(c) || carried_[c])
      read_contact(c, point, scales);
}

void ErrorMeasure::begin(const EndPoint &start) {
  read(start, recent_);
  largest_turnover_ = std::max(largest_turnover_, recent_.turnover);
  present_ = at_end_ = recent_;
  length_ = 0;
}

void ErrorMeasure::set_step(const EndPoint &start, const EndPoint &end) {
  const StateLayout &layout = equations_.layout();
  length_ = end.time - start.time;
  read(end, at_end_);
  present_.values = recent_.values.cwiseMax(at_end_.values);
  present_.energy = recent_.energy.cwiseMax(at_end_.energy);
  const double work =
      end.state[layout.absolute_input_work()] - start.state[layout.absolute_input_work()];
  possible_ = possible(end, recent_.turnover + work);
  present_.turnover = std::max(recent_.turnover, at_end_.turnover) + work;
  at_end_.turnover += work;
  for (std::size_t c = 0; c < mass_.size(); ++c) {
    OfContact &now = present_.of[c];
    OfContact &there = at_end_.of[c];
    const OfContact &before = recent_.of[c];
    const Index place = layout.impulse(static_cast<Index>(c));
    there.impulse = fading * before.impulse + std::abs(end.state[place] - start.state[place]);
    const Index work_place = layout.contact_work(static_cast<Index>(c));
    there.work = fading * before.work + std::abs(end.state[work_place] - start.state[work_place]);
    now = {.gap = std::max(before.gap, there.gap),
           .gap_rate = std::max(before.gap_rate, there.gap_rate),
           .energy = std::max(before.energy, there.energy),
           .force = std::max(before.force, there.force),
           .impulse = there.impulse,
           .sticking = std::max(before.sticking, there.sticking),
           .work = there.work,
           .rounding = std::max(before.rounding, there.rounding)};
    now.speed = mass_[c] > 0 ? std::sqrt(2 * std::max(now.energy, 0.0) / mass_[c]) : 0;
  }
  find_speed_tolerances();
}

void ErrorMeasure::accept() {
  recent_.values = (fading * recent_.values).cwiseMax(at_end_.values);
  recent_.energy = (fading * recent_.energy).cwiseMax(at_end_.energy);
  recent_.turnover = std::max(fading * recent_.turnover, at_end_.turnover);
  largest_turnover_ = std::max(largest_turnover_, recent_.turnover);
  for (std::size_t c = 0; c < mass_.size(); ++c) {
    OfContact &of = recent_.of[c];
    const OfContact &there = at_end_.of[c];
    of = {.gap = std::max(fading * of.gap, there.gap),
          .gap_rate = std::max(fading * of.gap_rate, there.gap_rate),
          .gap_acceleration = there.gap_acceleration,
          .energy = std::max(fading * of.energy, there.energy),
          .force = std::max(fading * of.force, there.force),
          .impulse = there.impulse,
          .sticking = std::max(fading * of.sticking, there.sticking),
          .work = there.work,
          .rounding = there.rounding};
  }
}

// What the energy of its body could make of a coordinate.
double ErrorMeasure::speed(Index coordinate) const {
  const double energy = present_.energy[body_[static_cast<std::size_t>(coordinate)]];
  return std::sqrt(2 * std::max(energy, 0.0) / equations_.model().mass()[coordinate]);
}

// Rounding of a contact's force: its own, and that of its gap, amplified by dF/dg ~ 2 F / u.
double ErrorMeasure::noise(std::size_t contact) const {
  const OfContact &of = present_.of[contact];
  return step_rounding_factor * of.force *
         (step_epsilon + (of.gap > 0 ? 2 * of.rounding / of.gap : 0));
}

double ErrorMeasure::gap_tolerance(std::size_t contact, double length) const {
  const OfContact &of = present_.of[contact];
  return absolute_gap_ + contact_part * relative_ * (of.gap + length * of.speed) +
         step_rounding_factor * of.rounding + length * rounding_of_speed(mass_[contact]);
}

double ErrorMeasure::gap_rate_tolerance(std::size_t contact, double length) const {
  const OfContact &of = present_.of[contact];
  return relative_ * (of.gap_rate + of.speed) + length * noise(contact) / mass_[contact] +
         rounding_of_speed(mass_[contact]);
}

// Below that of the largest energy that the motion has had nothing counts.
double ErrorMeasure::rounding_of_speed(double mass) const {
  return step_rounding_factor * step_epsilon *
         std::sqrt(2 * std::max(present_.turnover, largest_turnover_) / mass);
}

double ErrorMeasure::displacement_tolerance(Index coordinate) const {
  return absolute_[coordinate] + relative_ * present_.values[coordinate] +
         length_ * speed_tolerances_[coordinate];
}

double ErrorMeasure::speed_tolerance(Index coordinate) const {
  return absolute_[equations_.layout().velocity() + coordinate] + speed_tolerances_[coordinate];
}

// By its own speed; by what the contacts that act can make of it, sqrt(2 E m_c) being the momentum
// of the mass m_c that meets with their energy; by a small part of what its body's energy could, or
// each of the forces alone, which may cancel; and by the rounding of the forces.
void ErrorMeasure::find_speed_tolerances() {
  const StateLayout &layout = equations_.layout();
  const Vector &mass = equations_.model().mass();
  speed_tolerances_.resize(layout.n);
  for (Index j = 0; j < layout.n; ++j)
    speed_tolerances_[j] =
        relative_ * (present_.values[layout.velocity() + j] + part_of_energy * speed(j)) +
        rounding_of_speed(mass[j]);
  for (std::size_t c = 0; c < mass_.size(); ++c) {
    const OfContact &of = present_.of[c];
    if (of.force == 0 && of.energy == 0)
      continue;
    const double factor = relative_ * mass_[c] * of.speed +
                          length_ * (noise(c) + part_of_energy * relative_ * of.force);
    const ContactPair &pair = equations_.contacts().pairs()[c];
    for (Index j = 0; j < layout.n; ++j)
      speed_tolerances_[j] += factor * largest_entry(pair, j) / mass[j];
  }
}

// Of the bodies that meet there.
double ErrorMeasure::energy_at(std::size_t contact) const {
  double sum = present_.of[contact].energy;
  for (const Index body : bodies_[contact])
    sum += present_.energy[body];
  return sum;
}

double ErrorMeasure::of_contacts(const Vector &error) const {
  const StateLayout &layout = equations_.layout();
  double largest = 0;
  for (std::size_t c = 0; c < mass_.size(); ++c) {
    if (!acts(c))
      continue;
    const ContactPair &pair = equations_.contacts().pairs()[c];
    for (int d = 0; d < n_pushed(pair); ++d) {
      const RowVector &row = pair.along(d).projection->row;
      const double gap = std::abs(row.dot(error.head(layout.n)));
      const double rate = std::abs(row.dot(error.segment(layout.velocity(), layout.n)));
      largest = std::max({largest, ratio(gap, gap_tolerance(c, length_)),
                          ratio(rate, gap_rate_tolerance(c, length_))});
    }
  }
  return largest;
}

// The work of loads on a body that a contact holds, by a rigid side or where it sticks: as large as
// the force that does so, at a speed that is nothing but error, and what the rounding of that force
// makes of it.
double ErrorMeasure::work_at_rest() const {
  const ActiveConstraints &holding = equations_.holding();
  const Vector &mass = equations_.model().mass();
  double sum = 0;
  for (Index k = 0; k < holding.size(); ++k) {
    const HeldDirection &held = holding.held(k);
    const double push = length_ * (held.direction == 0 ? present_.of[held.contact].force
                                                       : present_.of[held.contact].sticking);
    for (Index j = 0; j < mass.size(); ++j) {
      const double momentum = push * std::abs(holding.rows()(k, j));
      sum += momentum *
             (speed_tolerances_[j] + step_rounding_factor * step_epsilon * momentum / mass[j]);
    }
  }
  return sum;
}

// What the absolute tolerance of all velocities makes of the energy.
double ErrorMeasure::negligible_work() const {
  if (absolute_gap_ == 0)
    return 0;
  const StateLayout &layout = equations_.layout();
  const auto speeds = absolute_.segment(layout.velocity(), layout.n);
  return equations_.model().mass().dot(
      speeds.cwiseProduct(present_.values.segment(layout.velocity(), layout.n) + speeds));
}

double ErrorMeasure::negligible_impulse(std::size_t contact) const {
  const double mass = 2 * mass_[contact];
  return std::sqrt(mass * negligible_work()) +
         step_rounding_factor * step_epsilon * std::sqrt(mass * largest_turnover_);
}

double ErrorMeasure::of_work(const Vector &error) const {
  const StateLayout &layout = equations_.layout();
  const double negligible = negligible_work() + work_at_rest() + step_epsilon * largest_turnover_;
  // With the energy of the contacts that act: where a base meets a body at rest nothing has been
  // turned over yet, and the relative error of the work, which goes with a power of the time since
  // then, is the same for steps of every length.
  double turnover = present_.turnover;
  for (const OfContact &of : present_.of)
    turnover += of.energy;
  const double allowed = relative_ * turnover + negligible;
  double largest = std::max(ratio(std::abs(error[layout.input_work()]), allowed),
                            ratio(std::abs(error[layout.damping_work()]), allowed));
  for (std::size_t c = 0; c < mass_.size(); ++c) {
    if (!acts(c))
      continue;
    const OfContact &of = present_.of[c];
    const auto contact = static_cast<Index>(c);
    const double momentum = mass_[c] * of.speed;
    largest = std::max({largest,
                        ratio(std::abs(error[layout.contact_work(contact)]),
                              relative_ * (energy_at(c) + of.work) +
                                  length_ * noise(c) * of.gap_rate + negligible),
                        ratio(std::abs(error[layout.impulse(contact)]),
                              contact_part * relative_ * std::max(of.impulse, momentum) +
                                  length_ * noise(c) + negligible_impulse(c))});
  }
  return largest;
}

// Where a step is far beyond its stability, the energy of a contact, which grows like u^(n+1), does
// so faster than its error, and overflows before the state does: measured against it any error
// would be none. No contact holds more than there was, was put in, and moves. The elastic energy
// q^T K q / 2 of n coordinates is at most n times the sum of the k_jj q_j^2 / 2 that are counted;
// the rest of the factor leaves room for what is not counted, such as cubic springs.
bool ErrorMeasure::possible(const EndPoint &end, double available) const {
  const StateLayout &layout = equations_.layout();
  const auto velocity = end.state.segment(layout.velocity(), layout.n);
  const double kinetic = velocity.cwiseAbs2().dot(equations_.model().mass()) / 2;
  constexpr double room = 1000;
  const double most = room * static_cast<double>(layout.n) * (available + kinetic);
  bool possible = std::isfinite(at_end_.turnover) && std::isfinite(most);
  for (std::size_t c = 0; c < mass_.size(); ++c) {
    const OfContact &of = at_end_.of[c];
    const double relative = mass_[c] * of.gap_rate * of.gap_rate / 2; // part of of.energy
    possible = possible && of.energy <= most + 2 * relative && std::isfinite(of.force);
  }
  return possible;
}

double ErrorMeasure::of_step(const Vector &error) const {
  if (!possible_ || !error.allFinite())
    return std::numeric_limits<double>::infinity();
  const StateLayout &layout = equations_.layout();
  double largest = 0;
  for (Index j = 0; j < layout.n; ++j) {
    const Index v = layout.velocity() + j;
    largest = std::max({largest, ratio(std::abs(error[j]), displacement_tolerance(j)),
                        ratio(std::abs(error[v]), speed_tolerance(j))});
  }
  for (Index i = layout.internal(); i < layout.physical_size(); ++i) {
    double allowed = absolute_[i] + relative_ * present_.values[i];
    if (i < layout.drive()) {
      const Index k = i - layout.internal();
      const std::size_t c = contact_of_internal_[static_cast<std::size_t>(k)];
      allowed += internal_scale_by_gap_[k] * gap_tolerance(c, length_);
    }
    largest = std::max(largest, ratio(std::abs(error[i]), allowed));
  }
  return std::max({largest, of_contacts(error), of_work(error)});
}

double ErrorMeasure::of_dense(const Vector &error) const {
  if (!possible_ || !error.allFinite())
    return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (Index j = 0; j < error.size(); ++j)
    largest = std::max(largest, ratio(std::abs(error[j]), displacement_tolerance(j)));
  for (std::size_t c = 0; c < mass_.size(); ++c) {
    const ContactPair &pair = equations_.contacts().pairs()[c];
    for (int d = 0; acts(c) && d < n_pushed(pair); ++d)
      largest = std::max(largest, ratio(std::abs(pair.along(d).projection->row.dot(error)),
                                        gap_tolerance(c, length_)));
  }
  return largest;
}

// The gap's size, or what it will be after a step where a contact has only begun.
double ErrorMeasure::reached(std::size_t contact, double length) const {
  const OfContact &of = recent_.of[contact];
  return std::max({of.gap, length * of.gap_rate, length * length / 2 * of.gap_acceleration});
}

const Vector &ErrorMeasure::source_tolerances(double length) {
  const std::vector<ContactPair> &pairs = equations_.contacts().pairs();
  source_tolerances_.setConstant(static_cast<Index>(equations_.model().sources().size()),
                                 std::numeric_limits<double>::infinity());
  for (std::size_t c = 0; c < mass_.size(); ++c) {
    if (!carried_[c] || equations_.mode(c).holds_gap)
      continue;
    const double allowed = absolute_gap_ + relative_ * reached(c, length);
    for (int d = 0; d < n_pushed(pairs[c]); ++d) {
      const std::vector<double> &factors = pairs[c].along(d).projection->base_coefficients;
      for (std::size_t k = 0; k < factors.size(); ++k)
        if (const double factor = std::abs(factors[k]); factor > 0)
          source_tolerances_[static_cast<Index>(k)] =
              std::min(source_tolerances_[static_cast<Index>(k)], allowed / factor);
    }
  }
  return source_tolerances_;
}

} // namespace vibroimpact::motion
