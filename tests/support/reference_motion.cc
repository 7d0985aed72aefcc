#include "support/reference_motion.h"

#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/stepper/extrapolation_stepper.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

namespace vibroimpact::testing {

namespace {

enum class Mode { open, contact, separating };

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
constexpr long most_steps = 200000;

Real force(const ReferenceLaw &law, Real u, Real rate) {
  if (u <= 0)
    return 0;
  const Real k = law.stiffness, c = law.damping;
  switch (law.kind) {
  case ReferenceLaw::Kind::power:
    return k * std::pow(u, Real(law.exponent)) * (1 + c * rate);
  case ReferenceLaw::Kind::kuwabara_kono:
    return k * std::sqrt(u) * (u + 1.5L * c * rate);
  case ReferenceLaw::Kind::tsuji:
    return k * u * std::sqrt(u) + c * std::sqrt(std::sqrt(u)) * rate;
  }
  throw std::logic_error("unknown law");
}

// Has the sign of the force.
Real push(const ReferenceLaw &law, Real u, Real rate) {
  switch (law.kind) {
  case ReferenceLaw::Kind::power:
    return 1 + law.damping * rate;
  case ReferenceLaw::Kind::kuwabara_kono:
    return u + 1.5L * law.damping * rate;
  case ReferenceLaw::Kind::tsuji:
    return 1;
  }
  throw std::logic_error("unknown law");
}

Real product(const std::vector<double> &row, const Real *x) {
  Real sum = 0;
  for (std::size_t i = 0; i < row.size(); ++i)
    sum += row[i] * x[i];
  return sum;
}

// State: q, v, and of each contact impulse and work.
class Integration {
public:
  Integration(const ReferenceSystem &system, const ReferenceStart &start, double tolerance)
      : system_(system), n_(system.mass.size()), tolerance_(tolerance),
        state_(2 * (n_ + system.contacts.size())), modes_(system.contacts.size(), Mode::open),
        current_(system.contacts.size()) {
    std::copy(start.displacement.begin(), start.displacement.end(), state_.begin());
    std::copy(start.velocity.begin(), start.velocity.end(),
              state_.begin() + static_cast<std::ptrdiff_t>(n_));
    result_.impacts.resize(system.contacts.size());
    largest_.assign(2 * n_, 0);
    longest_ = longest_step();
    step_ = 1e-3L * longest_;
    message_sizes();
  }

  ReferenceResult run(Real end) {
    while (time_ < end)
      advance(end);
    result_.displacement.assign(state_.begin(), state_.begin() + static_cast<std::ptrdiff_t>(n_));
    result_.velocity.assign(state_.begin() + static_cast<std::ptrdiff_t>(n_),
                            state_.begin() + static_cast<std::ptrdiff_t>(2 * n_));
    result_.largest_displacement.assign(largest_.begin(),
                                        largest_.begin() + static_cast<std::ptrdiff_t>(n_));
    result_.largest_velocity.assign(largest_.begin() + static_cast<std::ptrdiff_t>(n_),
                                    largest_.end());
    return std::move(result_);
  }

private:
  enum class Cause { onset, release, cut_off, push_again };
  struct Guard {
    std::size_t contact = 0;
    Cause cause = Cause::onset;
  };
  struct Event {
    Guard guard;
    Real instant = 0; // after the start of the step
  };

  // A twentieth of the shortest period of the linear part (bound by Gershgorin) or of a source.
  Real longest_step() const {
    Real squared = 0;
    const auto count = [&](const ReferenceHarmonic &source) {
      squared = std::max(squared, Real(source.frequency) * source.frequency);
    };
    for (const auto &source : system_.forces)
      if (source)
        count(*source);
    if (system_.base)
      count(*system_.base);
    for (std::size_t i = 0; i < n_; ++i) {
      Real sum = system_.stiffness[i] / system_.mass[i] +
                 std::pow(system_.damping[i] / system_.mass[i], 2);
      for (const ReferenceSpring &spring : system_.springs)
        for (std::size_t j = 0; j < n_; ++j)
          sum += std::abs(spring.row[i] * spring.row[j]) * (spring.stiffness + spring.cubic) /
                 std::min(system_.mass[i], system_.mass[j]);
      squared = std::max(squared, sum);
    }
    return squared > 0 ? 0.3L / std::sqrt(squared) : 1;
  }

  static Real value(const ReferenceHarmonic &source, Real time, int derivative) {
    const Real w = source.frequency;
    const Real angle = w * time + source.phase + derivative * std::acos(Real(0));
    return std::pow(w, derivative) * source.amplitude * std::sin(angle);
  }

  Real gap(std::size_t c, const Reals &x, Real time) const {
    const ReferenceContact &contact = system_.contacts[c];
    Real sum = contact.clearance + product(contact.row, x.data());
    if (contact.by_base != 0)
      sum += contact.by_base * value(*system_.base, time, 0);
    return sum;
  }
  Real gap_rate(std::size_t c, const Reals &x, Real time) const {
    const ReferenceContact &contact = system_.contacts[c];
    Real sum = product(contact.row, x.data() + n_);
    if (contact.by_base != 0)
      sum += contact.by_base * value(*system_.base, time, 1);
    return sum;
  }

  void rates(const Reals &x, Reals &dxdt, Real time) const {
    const Real base = system_.base ? value(*system_.base, time, 2) : 0;
    for (std::size_t i = 0; i < n_; ++i) {
      dxdt[i] = x[n_ + i];
      dxdt[n_ + i] =
          -system_.stiffness[i] * x[i] - system_.damping[i] * x[n_ + i] - system_.mass[i] * base;
      if (i < system_.forces.size() && system_.forces[i])
        dxdt[n_ + i] += value(*system_.forces[i], time, 0);
    }
    for (const ReferenceSpring &spring : system_.springs) {
      const Real e = product(spring.row, x.data());
      const Real tension = spring.stiffness * e + spring.cubic * e * e * e +
                           spring.damping * product(spring.row, x.data() + n_);
      for (std::size_t i = 0; i < n_; ++i)
        dxdt[n_ + i] -= spring.row[i] * tension;
    }
    for (std::size_t c = 0; c < modes_.size(); ++c) {
      const Real rate = -gap_rate(c, x, time);
      const Real normal =
          modes_[c] == Mode::contact ? force(system_.contacts[c].law, -gap(c, x, time), rate) : 0;
      dxdt[2 * n_ + 2 * c] = normal;
      dxdt[2 * n_ + 2 * c + 1] = normal * rate;
      for (std::size_t i = 0; i < n_; ++i)
        dxdt[n_ + i] += system_.contacts[c].row[i] * normal;
    }
    for (std::size_t i = 0; i < n_; ++i)
      dxdt[n_ + i] /= system_.mass[i];
  }

  Reals after(Real length, Reals *error = nullptr) {
    Reals end(state_.size()), unused(state_.size());
    stepper_.do_step([this](const Reals &x, Reals &dxdt, Real time) { rates(x, dxdt, time); },
                     state_, time_, end, length, error ? *error : unused);
    return end;
  }

  // Error over tolerance.
  Real size(const Reals &end, const Reals &error, Real length) const {
    Real worst = size_of_coordinates(end, error, length);
    for (std::size_t c = 0; c < modes_.size(); ++c)
      if (modes_[c] == Mode::contact)
        worst = std::max(
            {worst, size_of_penetration(c, end, error, length), size_of_integrals(c, end, error)});
    return worst;
  }

  Real size_of_coordinates(const Reals &end, const Reals &error, Real length) const {
    const Real speed =
        *std::max_element(largest_.begin() + static_cast<std::ptrdiff_t>(n_), largest_.end());
    Real worst = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      const Real v = std::max({largest_[n_ + i], std::abs(end[n_ + i]), 1e-3L * speed});
      const Real q = std::max({largest_[i], std::abs(end[i]), v * length});
      worst = std::max({worst, std::abs(error[i]) / q, std::abs(error[n_ + i]) / v});
    }
    return worst / tolerance_;
  }

  // What rounding makes of the gap is no error.
  Real size_of_penetration(std::size_t c, const Reals &end, const Reals &error, Real length) const {
    const std::vector<double> &row = system_.contacts[c].row;
    Real rounding = std::abs(system_.contacts[c].clearance);
    for (std::size_t i = 0; i < n_; ++i)
      rounding += std::abs(row[i] * end[i]);
    const Real u = std::max(current_[c].deepest, -gap(c, end, time_ + length));
    return std::abs(product(row, error.data())) / (tolerance_ * u + 128 * epsilon * rounding);
  }

  // Impulse and work beside momentum and energy of what meets.
  Real size_of_integrals(std::size_t c, const Reals &end, const Reals &error) const {
    Real inverse_mass = 0, rate = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      const Real weight = system_.contacts[c].row[i];
      inverse_mass += weight * weight / system_.mass[i];
      rate += std::abs(weight) * largest_[n_ + i];
    }
    const std::size_t impulse = 2 * n_ + 2 * c, work = impulse + 1;
    const Real momentum = std::max(rate / inverse_mass, std::abs(end[impulse]));
    const Real energy = std::max(rate * rate / inverse_mass, std::abs(end[work]));
    return std::max(std::abs(error[impulse]) / momentum, std::abs(error[work]) / energy) /
           tolerance_;
  }

  void advance(Real end) {
    Reals error(state_.size());
    const Real left = end - time_;
    Real length = std::min({step_, longest_, left});
    if (++tried_ > most_steps)
      throw std::runtime_error("the reference takes too many steps");
    Reals x = after(length, &error);
    const Real excess = size(x, error, length);
    if (!(excess <= 1)) {
      step_ = length * std::max(0.1L, 0.8L * std::pow(excess, -1 / 15.0L));
      return;
    }
    if (hides_crossing(x, length)) {
      step_ = length / 2;
      return;
    }
    std::optional<Event> event = first_event(x, length);
    step_ = event ? 1e-3L * length
                  : length * std::min(4.0L, 0.8L * std::pow(excess + 1e-9L, -1 / 15.0L));
    if (event) {
      length = event->instant;
      x = after(length);
    }
    note_deepest(x, length);
    time_ = !event && length == left ? end : time_ + length;
    state_ = x;
    ++result_.steps;
    message_sizes();
    if (event)
      pass(event->guard);
  }

  void message_sizes() {
    for (std::size_t i = 0; i < 2 * n_; ++i)
      largest_[i] = std::max(largest_[i], std::abs(state_[i]));
  }

  std::vector<Guard> guards() const {
    std::vector<Guard> list;
    for (std::size_t c = 0; c < modes_.size(); ++c) {
      if (modes_[c] == Mode::open)
        list.push_back({c, Cause::onset});
      else
        list.push_back({c, Cause::release});
      if (modes_[c] == Mode::contact)
        list.push_back({c, Cause::cut_off});
      if (modes_[c] == Mode::separating)
        list.push_back({c, Cause::push_again});
    }
    return list;
  }
  Real indicator(const Guard &guard, const Reals &x, Real time) const {
    const Real u = -gap(guard.contact, x, time);
    const Real pushes =
        push(system_.contacts[guard.contact].law, u, -gap_rate(guard.contact, x, time));
    switch (guard.cause) {
    case Cause::onset:
      return -u;
    case Cause::release:
      return u;
    case Cause::cut_off:
      return pushes;
    case Cause::push_again:
      return -pushes;
    }
    throw std::logic_error("unknown guard");
  }

  // The cubic through values and slopes of a gap at both ends has an extreme value beyond zero
  // between them.
  bool hides_crossing(const Reals &x, Real length) const {
    if (length < 1e-7L * longest_)
      return false;
    for (std::size_t c = 0; c < modes_.size(); ++c) {
      const Real sign = modes_[c] == Mode::open ? 1 : -1;
      const Real g0 = sign * gap(c, state_, time_), g1 = sign * gap(c, x, time_ + length);
      const Real d0 = sign * length * gap_rate(c, state_, time_);
      const Real d1 = sign * length * gap_rate(c, x, time_ + length);
      if (g1 < 0 || !(d0 < 0 && d1 > 0))
        continue;
      for (int i = 1; i < 32; ++i) {
        const Real s = i / 32.0L;
        const Real cubic =
            g0 + s * (d0 + s * (3 * (g1 - g0) - 2 * d0 - d1 + s * (2 * (g0 - g1) + d0 + d1)));
        if (cubic < 0)
          return true;
      }
    }
    return false;
  }

  std::optional<Event> first_event(const Reals &x, Real length) {
    std::optional<Event> first;
    for (const Guard &guard : guards()) {
      if (indicator(guard, x, time_ + length) >= 0)
        continue;
      const Real instant = zero(guard, length);
      if (!first || instant < first->instant)
        first = Event{guard, instant};
    }
    return first;
  }

  // A guard that has just been passed is zero at the start of the step.
  Real zero(const Guard &guard, Real length) {
    const auto function = [&](Real s) { return indicator(guard, after(s), time_ + s); };
    Real low = indicator(guard, state_, time_) > 0 ? 0 : length / 2;
    while (low > 1e-12L * length && !(function(low) > 0))
      low /= 2;
    if (!(function(low) > 0))
      return low;
    std::uintmax_t iterations = 100;
    const auto close = [&](Real a, Real b) { return b - a < 4 * epsilon * b; };
    return boost::math::tools::toms748_solve(function, low, length, close, iterations).second;
  }

  void note_deepest(const Reals &x, Real length) {
    for (std::size_t c = 0; c < modes_.size(); ++c) {
      if (modes_[c] != Mode::contact)
        continue;
      current_[c].deepest = std::max(current_[c].deepest, -gap(c, x, time_ + length));
      const Real before = -gap_rate(c, state_, time_), behind = -gap_rate(c, x, time_ + length);
      if (!(before > 0 && behind < 0))
        continue;
      ++current_[c].humps;
      const auto rate = [&](Real s) { return -gap_rate(c, after(s), time_ + s); };
      std::uintmax_t iterations = 100;
      const auto close = [&](Real a, Real b) { return b - a < 1e-12L * length; };
      const Real s = boost::math::tools::toms748_solve(rate, Real(0), length, before, behind, close,
                                                       iterations)
                         .first;
      current_[c].deepest = std::max(current_[c].deepest, -gap(c, after(s), time_ + s));
    }
  }

  void pass(const Guard &guard) {
    const std::size_t c = guard.contact;
    ReferenceImpact &impact = current_[c];
    Real &impulse = state_[2 * n_ + 2 * c];
    Real &work = state_[2 * n_ + 2 * c + 1];
    const Real rate = gap_rate(c, state_, time_);
    if (guard.cause == Cause::onset) {
      impact = {.start = time_, .approach_speed = -rate};
      impulse = work = 0;
      modes_[c] = Mode::contact;
    } else if (guard.cause == Cause::release) {
      impact.duration = time_ - impact.start;
      impact.separation_speed = rate;
      impact.impulse = impulse;
      impact.dissipated = work;
      result_.impacts[c].push_back(impact);
      modes_[c] = Mode::open;
    } else {
      modes_[c] = guard.cause == Cause::cut_off ? Mode::separating : Mode::contact;
    }
  }

  const ReferenceSystem &system_;
  std::size_t n_;
  Real tolerance_;
  boost::numeric::odeint::extrapolation_stepper<16, Reals, Real> stepper_;
  long tried_ = 0; ///< steps, refused ones too
  Real time_ = 0, step_ = 0, longest_ = 0;
  Reals state_, largest_;
  std::vector<Mode> modes_;
  std::vector<ReferenceImpact> current_;
  ReferenceResult result_;
};

} // namespace

ReferenceResult reference_motion(const ReferenceSystem &system, const ReferenceStart &start,
                                 double end, double tolerance) {
  return Integration(system, start, tolerance).run(end);
}

} // namespace vibroimpact::testing
