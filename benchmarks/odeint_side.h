// Boost.odeint's Dormand-Prince method with dense output, and contact changes located on it: the
// signs of the guards are looked at after every step, a change is bisected on the dense output, and
// the method restarts there. Turning points of the recorded displacement are located on the dense
// output too.
#pragma once

#include "measurement.h"

#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <functional>
#include <limits>

namespace vibroimpact::benchmarks {

template <class System> class OdeintMotion {
public:
  using State = typename System::State;

  OdeintMotion(const System &system, const State &start, double end, double event_tolerance,
               const Tolerance &tolerance, bool records)
      : system_(system), begin_(system), start_(start), end_(end),
        event_tolerance_(event_tolerance), records_(records),
        stepper_(boost::numeric::odeint::make_dense_output(
            tolerance.absolute, tolerance.relative,
            boost::numeric::odeint::runge_kutta_dopri5<State>())) {}

  Outcome operator()() {
    begin();
    while (stepper_.current_time() < end_) {
      if (stepper_.current_time() + stepper_.current_time_step() > end_)
        restart(stepper_.current_state(), stepper_.current_time(), end_ - stepper_.current_time());
      if (stepper_.current_time_step() > longest_step())
        restart(stepper_.current_state(), stepper_.current_time(), longest_step());
      stepper_.do_step(std::ref(system_));
      ++steps_;
      // What the step ends with, before a contact change cuts it short.
      const double until = changed(stepper_.current_state(), stepper_.current_time())
                               ? locate()
                               : stepper_.current_time();
      if (records_)
        record(until);
      if (until < stepper_.current_time() ||
          changed(stepper_.current_state(), stepper_.current_time()))
        change(until);
    }
    return outcome();
  }

  /// Behind the motion.
  const State &end_state() const { return stepper_.current_state(); }

private:
  void begin() {
    system_ = begin_;
    steps_ = 0;
    lowest_ = std::numeric_limits<double>::infinity();
    highest_ = -lowest_;
    const double first = 0.01 / system_.highest_frequency();
    contact_step_ = free_step_ = first;
    last_rate_ = system_.recorded_rate(start_, 0);
    restart(start_, 0, first);
  }

  void restart(State state, double time, double step) { stepper_.initialize(state, time, step); }

  // Where nothing moves the error control lets steps go beyond all guards.
  double longest_step() const {
    if constexpr (requires { system_.longest_step(); })
      return system_.longest_step();
    else
      return std::numeric_limits<double>::infinity();
  }

  // Guards and changes of some systems depend on the time too.
  double guard(std::size_t i, const State &x, double time) const {
    if constexpr (requires { system_.guard(i, x, time); })
      return system_.guard(i, x, time);
    else
      return system_.guard(i, x);
  }
  void pass(std::size_t i, State &x, double time) {
    if constexpr (requires { system_.pass(i, x, time); })
      system_.pass(i, x, time);
    else
      system_.pass(i, x);
  }

  bool changed(const State &x, double time) const {
    for (std::size_t i = 0; i < System::contacts; ++i)
      if (guard(i, x, time) < 0)
        return true;
    return false;
  }

  // The earliest change of the step.
  double locate() {
    double lower = stepper_.previous_time();
    double upper = stepper_.current_time();
    State x;
    while (upper - lower > event_tolerance_) {
      const double middle = 0.5 * (lower + upper);
      if (middle <= lower || middle >= upper)
        break;
      stepper_.calc_state(middle, x);
      (changed(x, middle) ? upper : lower) = middle;
    }
    return upper;
  }

  void record(double until) {
    State x;
    stepper_.calc_state(until, x);
    const double rate = system_.recorded_rate(x, until);
    if (rate * last_rate_ < 0)
      include(turning_point(until, rate));
    last_rate_ = rate;
  }

  // Regula falsi (Illinois); at a turning point the displacement hardly depends on the instant.
  double turning_point(double until, double rate) {
    double a = stepper_.previous_time(), b = until;
    double rate_a = last_rate_, rate_b = rate;
    const double enough = 1e-6 * (b - a);
    const double small = 1e-7 * std::abs(rate - last_rate_);
    int last_moved = 0;
    State x;
    double middle = b;
    while (b - a > enough) {
      middle = (a * rate_b - b * rate_a) / (rate_b - rate_a);
      stepper_.calc_state(middle, x);
      const double value = system_.recorded_rate(x, middle);
      if (std::abs(value) <= small)
        break;
      const int moved = value * rate_b > 0 ? 1 : -1;
      (moved > 0 ? b : a) = middle;
      (moved > 0 ? rate_b : rate_a) = value;
      if (moved == last_moved)
        (moved > 0 ? rate_a : rate_b) *= 0.5;
      last_moved = moved;
    }
    stepper_.calc_state(middle, x);
    return system_.recorded(x, middle);
  }

  void include(double value) {
    lowest_ = std::min(lowest_, value);
    highest_ = std::max(highest_, value);
  }

  bool in_contact() const {
    for (std::size_t i = 0; i < System::contacts; ++i)
      if (system_.is_touching(i))
        return true;
    return false;
  }

  // The trial step that suited flight and contact last time is kept for the next one.
  void change(double time) {
    State x;
    stepper_.calc_state(time, x);
    (in_contact() ? contact_step_ : free_step_) = stepper_.current_time_step();
    for (std::size_t i = 0; i < System::contacts; ++i)
      if (guard(i, x, time) < 0)
        pass(i, x, time);
    restart(x, time, in_contact() ? contact_step_ : free_step_);
  }

  Outcome outcome() const {
    return {.excursion = records_ ? highest_ - lowest_ : 0,
            .contacts = {system_.begun.begin(), system_.begun.end()},
            .steps = steps_,
            .evaluations = system_.evaluations};
  }

  using Stepper = typename boost::numeric::odeint::result_of::make_dense_output<
      boost::numeric::odeint::runge_kutta_dopri5<State>>::type;
  System system_, begin_;
  State start_;
  double end_;
  double event_tolerance_;
  bool records_;
  Stepper stepper_;
  double contact_step_ = 0, free_step_ = 0;
  double last_rate_ = 0, lowest_ = 0, highest_ = 0;
  long steps_ = 0;
};

template <class System>
Side odeint_side(const System &system, const typename System::State &start, double end,
                 double event_tolerance) {
  return {.name = "odeint dopri5", .prepare = [=](const Tolerance &tolerance, bool records) {
            return Motion(
                OdeintMotion<System>(system, start, end, event_tolerance, tolerance, records));
          }};
}

} // namespace vibroimpact::benchmarks
