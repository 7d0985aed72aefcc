// A second way to the derivatives of a motion: its equations, laws and events written down again in
// dual numbers, for a few masses on a moving base. No Jacobian and no saltation is formed: the
// instant of an event is a dual number too, and what comes after starts from there.
//
//   M q'' + C q' + K q + cubic springs = -M 1 s''(t) + f(t) + contact forces
//   gap = clearance + row q + by_base s(t)
//
// Steps are those of Gragg's extrapolation of the midpoint rule (order 12), of fixed length. Forces
// of a contact with penetration u may have powers u^(1/4): while such a contact acts
// w = (u / u_0)^(1/4) is integrated beside the rest, by a variable sigma in which all is smooth,
//
//   dt/dsigma = 4 (u_0 / v_0) w^3,   dw/dsigma = u' / v_0
#pragma once

#include "support/dual.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace vibroimpact::testing {

using Duals = std::vector<Dual>;

/// What a law sees.
struct DualLocal {
  Dual gap, gap_rate, internal;
  Dual root; ///< u^(1/4) of contacts whose mode is rooted; negative once the overlap is over
  Dual force_of_rest; ///< that holds the gap, in modes that do
};
using DualFunction = std::function<Dual(const DualLocal &)>;

struct DualGuard {
  DualFunction indicator; ///< falls through zero where the mode ends
  int target = 0;
  DualFunction reset{}; ///< of the internal state; none: unchanged
  bool impact = false;
};

struct DualMode {
  DualFunction force{};         ///< none: 0
  DualFunction internal_rate{}; ///< none: 0
  std::vector<DualGuard> guards{};
  bool rooted = false; ///< the force has powers of u^(1/4)
  bool rests = false;  ///< holds the gap
};

struct DualContact {
  Duals row;
  Dual clearance, by_base;
  std::vector<DualMode> modes{};
  Dual restitution{};
  Dual internal{};
  int mode = 0;
};

/// A function of time and its first two derivatives.
struct DualMotionOfBase {
  Dual amplitude, frequency, phase;
  Dual operator()(const Dual &t, int derivative) const {
    const Dual angle = frequency * t + phase;
    const Dual s = amplitude * sin(angle);
    return derivative == 0   ? s
           : derivative == 1 ? amplitude * frequency * cos(angle)
                             : -(frequency * frequency * s);
  }
};

struct DualSystem {
  Duals mass;                            ///< n
  std::vector<Duals> stiffness, damping; ///< n x n
  DualMotionOfBase base{};
  Duals constant_force{}; ///< n, or none
  /// k3 (q_1 - q_0)^3 between the first two masses.
  Dual cubic_stiffness{};
  std::vector<DualContact> contacts{};
};

class DualMotion {
public:
  /// `step` [s] while no rooted contact acts, a fortieth of such a contact otherwise, divided by
  /// `refinement`. `penetration`: u_0 [m].
  DualMotion(DualSystem system, Duals q, Duals v, const Dual &time, double step, double penetration,
             double refinement)
      : system_(std::move(system)), n_(q.size()), time_(time), q_(std::move(q)), v_(std::move(v)),
        step_(step / refinement), root_step_(0.025 / refinement), penetration_(penetration) {}

  void advance(double end) {
    while (time_.value < end) {
      const Duals start = pack();
      const double length = rooted_ < 0 ? step_ : root_step_;
      Event next = first_event(start, length, end);
      unpack(step(start, next.instant));
      if (next.contact >= 0)
        pass(static_cast<std::size_t>(next.contact), next.guard);
      else if (next.at_end)
        return;
    }
  }
  /// q, v, and the internal states of the contacts that have one.
  Duals state(const std::vector<std::size_t> &with_internal) const {
    Duals all = q_;
    all.insert(all.end(), v_.begin(), v_.end());
    for (const std::size_t c : with_internal)
      all.push_back(system_.contacts[c].internal);
    return all;
  }
  int events() const { return events_; }

private:
  struct Event {
    int contact = -1; ///< none: the end, or a step without events
    std::size_t guard = 0;
    bool at_end = false;
    Dual instant{}; ///< from the start of the step, in its independent variable
  };

  std::size_t contacts() const { return system_.contacts.size(); }
  const DualMode &mode(std::size_t c) const {
    return system_.contacts[c].modes[static_cast<std::size_t>(system_.contacts[c].mode)];
  }

  // t, q, v, internal states, w
  Duals pack() const {
    Duals x = {time_};
    x.insert(x.end(), q_.begin(), q_.end());
    x.insert(x.end(), v_.begin(), v_.end());
    for (const DualContact &contact : system_.contacts)
      x.push_back(contact.internal);
    x.push_back(root_);
    return x;
  }
  void unpack(const Duals &x) {
    time_ = x[0];
    for (std::size_t i = 0; i < n_; ++i) {
      q_[i] = x[1 + i];
      v_[i] = x[1 + n_ + i];
    }
    for (std::size_t c = 0; c < contacts(); ++c)
      system_.contacts[c].internal = x[1 + 2 * n_ + c];
    root_ = x.back();
  }

  DualLocal local(std::size_t c, const Duals &x) const {
    const DualContact &contact = system_.contacts[c];
    DualLocal state;
    state.gap = contact.clearance + contact.by_base * system_.base(x[0], 0);
    state.gap_rate = contact.by_base * system_.base(x[0], 1);
    for (std::size_t i = 0; i < n_; ++i) {
      state.gap += contact.row[i] * x[1 + i];
      state.gap_rate += contact.row[i] * x[1 + n_ + i];
    }
    state.internal = x[1 + 2 * n_ + c];
    if (rooted_ == static_cast<int>(c))
      state.root = std::sqrt(std::sqrt(penetration_)) * x.back();
    if (mode(c).rests)
      state.force_of_rest = force_of_rest(c, x);
    return state;
  }

  // By all but the contacts that rest.
  Duals forces(const Duals &x) const {
    Duals force(n_);
    const Dual base = system_.base(x[0], 2);
    for (std::size_t i = 0; i < n_; ++i) {
      force[i] = -(system_.mass[i] * base);
      if (!system_.constant_force.empty())
        force[i] += system_.constant_force[i];
      for (std::size_t j = 0; j < n_; ++j)
        force[i] += -(system_.stiffness[i][j] * x[1 + j] + system_.damping[i][j] * x[1 + n_ + j]);
    }
    if (n_ > 1) {
      const Dual elongation = x[2] - x[1];
      const Dual cubic = system_.cubic_stiffness * elongation * elongation * elongation;
      force[0] += cubic;
      force[1] += -cubic;
    }
    for (std::size_t c = 0; c < contacts(); ++c)
      if (mode(c).force) {
        const Dual normal = mode(c).force(local(c, x));
        for (std::size_t i = 0; i < n_; ++i)
          force[i] += system_.contacts[c].row[i] * normal;
      }
    return force;
  }
  Dual inverse_mass(const DualContact &contact) const {
    Dual sum;
    for (std::size_t i = 0; i < n_; ++i)
      sum += contact.row[i] * contact.row[i] / system_.mass[i];
    return sum;
  }
  Dual force_of_rest(std::size_t c, const Duals &x) const {
    const DualContact &contact = system_.contacts[c];
    const Duals force = forces(x);
    Dual acceleration = contact.by_base * system_.base(x[0], 2);
    for (std::size_t i = 0; i < n_; ++i)
      acceleration += contact.row[i] * force[i] / system_.mass[i];
    return -(acceleration / inverse_mass(contact));
  }

  // dx/dsigma
  Duals rates(const Duals &x) const {
    Duals force = forces(x);
    for (std::size_t c = 0; c < contacts(); ++c)
      if (mode(c).rests) {
        const Dual normal = force_of_rest(c, x);
        for (std::size_t i = 0; i < n_; ++i)
          force[i] += system_.contacts[c].row[i] * normal;
      }
    const Dual &w = x.back();
    const Dual pace = rooted_ < 0 ? Dual(1) : Dual(4 * penetration_ / speed_) * w * w * w;
    Duals rate = {pace};
    for (std::size_t i = 0; i < n_; ++i)
      rate.push_back(pace * x[1 + n_ + i]);
    for (std::size_t i = 0; i < n_; ++i)
      rate.push_back(pace * force[i] / system_.mass[i]);
    for (std::size_t c = 0; c < contacts(); ++c)
      rate.push_back(mode(c).internal_rate ? pace * mode(c).internal_rate(local(c, x)) : Dual(0));
    rate.push_back(rooted_ < 0 ? Dual(0)
                               : -(local(static_cast<std::size_t>(rooted_), x).gap_rate / speed_));
    return rate;
  }

  Duals midpoint(const Duals &x, const Dual &length, int parts) const {
    const Dual h = length / parts;
    Duals before = x;
    Duals now = along(x, h, rates(x));
    for (int i = 1; i < parts; ++i) {
      Duals next = along(before, h + h, rates(now));
      before = std::exchange(now, std::move(next));
    }
    return now;
  }
  static Duals along(const Duals &x, const Dual &h, const Duals &rate) {
    Duals moved = x;
    for (std::size_t i = 0; i < x.size(); ++i)
      moved[i] += h * rate[i];
    return moved;
  }
  // With an even number of parts the error has even powers of their length alone.
  Duals step(const Duals &x, const Dual &length) const {
    constexpr int columns = 6;
    std::vector<Duals> before;
    for (int k = 1; k <= columns; ++k) {
      std::vector<Duals> row = {midpoint(x, length, 2 * k)};
      for (int j = 1; j < k; ++j) {
        const double ratio = static_cast<double>(k) / (k - j);
        Duals better = row.back();
        const Duals &coarse = before[static_cast<std::size_t>(j - 1)];
        for (std::size_t i = 0; i < x.size(); ++i)
          better[i] += (row.back()[i] - coarse[i]) / (ratio * ratio - 1);
        row.push_back(std::move(better));
      }
      before = std::move(row);
    }
    return before.back();
  }

  using Indicator = std::function<Dual(const Duals &)>;

  Event first_event(const Duals &start, double length, double end) const {
    Event first{.instant = length};
    const Duals after = step(start, length);
    const auto consider = [&](const Indicator &indicator, Event event) {
      if (indicator(after).value > 0)
        return;
      event.instant = zero(indicator, start, first.instant.value);
      if (event.instant.value < first.instant.value)
        first = event;
    };
    for (std::size_t c = 0; c < contacts(); ++c)
      for (std::size_t g = 0; g < mode(c).guards.size(); ++g)
        consider([&, c, g](const Duals &x) { return mode(c).guards[g].indicator(local(c, x)); },
                 {.contact = static_cast<int>(c), .guard = g});
    consider([&](const Duals &x) { return Dual(end) - x[0]; }, {.at_end = true});
    return first;
  }

  // By bisection and Newton's method, whose last steps bring the derivatives. A guard that is zero
  // at the start has just been passed.
  Dual zero(const Indicator &indicator, const Duals &start, double length) const {
    if (indicator(step(start, length)).value > 0)
      return 2 * length;
    double low = 0, high = length;
    for (int i = 0; i < 20; ++i) {
      const double middle = 0.5 * (low + high);
      (indicator(step(start, middle)).value > 0 ? low : high) = middle;
    }
    Dual place = 0.5 * (low + high);
    for (int i = 0; i < 3; ++i) {
      const Duals there = step(start, place.value);
      place = Dual(place.value) - indicator(there) / slope(indicator, there);
    }
    return place;
  }
  // Along the motion: the derivative by a direction of its own.
  double slope(const Indicator &indicator, const Duals &x) const {
    const Duals rate = rates(x);
    Duals moved;
    for (std::size_t i = 0; i < x.size(); ++i) {
      Dual entry(x[i].value);
      entry.by.back() = rate[i].value;
      moved.push_back(entry);
    }
    return indicator(moved).by.back();
  }

  void pass(std::size_t c, std::size_t g) {
    ++events_;
    DualContact &contact = system_.contacts[c];
    const DualGuard guard = mode(c).guards[g];
    const DualLocal before = local(c, pack());
    if (guard.impact)
      collide(contact, before.gap_rate);
    if (guard.reset)
      contact.internal = guard.reset(before);
    // Sides that nothing presses together part at once.
    const bool pressed = !contact.modes[static_cast<std::size_t>(guard.target)].rests ||
                         force_of_rest(c, pack()).value > 0;
    contact.mode = pressed ? guard.target : contact.mode;
    if (rooted_ == static_cast<int>(c) && !mode(c).rooted)
      rooted_ = -1;
    else if (mode(c).rooted)
      begin_root(c, before);
  }
  void collide(const DualContact &contact, const Dual &gap_rate) {
    const Dual impulse = -((Dual(1) + contact.restitution) * gap_rate / inverse_mass(contact));
    for (std::size_t i = 0; i < n_; ++i)
      v_[i] += contact.row[i] * impulse / system_.mass[i];
  }
  void begin_root(std::size_t c, const DualLocal &before) {
    if (rooted_ >= 0)
      throw std::logic_error("two contacts with roots act together");
    rooted_ = static_cast<int>(c);
    speed_ = std::abs(before.gap_rate.value);
    const bool touches = std::abs(before.gap.value) < 1e-9 * penetration_;
    root_ = touches ? Dual(0) : pow(-(before.gap / penetration_), 0.25);
  }

  DualSystem system_;
  std::size_t n_;
  Dual time_;
  Duals q_, v_;
  Dual root_;        ///< w
  int rooted_ = -1;  ///< the contact whose w it is; none
  double speed_ = 1; ///< v_0
  double step_, root_step_, penetration_;
  int events_ = 0;
};

} // namespace vibroimpact::testing
