// Boost.odeint's Dormand-Prince method with dense output, and contact changes located on it: the
// sign of the gap is looked at after every step, a change is bisected on the dense output, and the
// method restarts there.
#pragma once

#include "measurement.h"

#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <functional>

namespace vibroimpact::benchmarks {

template <class System> class OdeintMotion {
public:
  using State = typename System::State;

  OdeintMotion(const System &system, const State &start, double end, double event_tolerance,
               const Tolerance &tolerance)
      : system_(system), start_(start), end_(end), event_tolerance_(event_tolerance),
        stepper_(boost::numeric::odeint::make_dense_output(
            tolerance.absolute, tolerance.relative,
            boost::numeric::odeint::runge_kutta_dopri5<State>())) {}

  Outcome operator()() {
    begin();
    while (stepper_.current_time() < end_) {
      if (stepper_.current_time() + stepper_.current_time_step() > end_)
        restart(stepper_.current_state(), stepper_.current_time(), end_ - stepper_.current_time());
      stepper_.do_step(std::ref(system_));
      ++steps_;
      if (changed(stepper_.current_state()))
        change();
    }
    return outcome();
  }

private:
  void begin() {
    system_.touching = false;
    system_.evaluations = steps_ = restarts_ = impacts_ = 0;
    const double first = 0.01 / system_.highest_frequency();
    step_of_mode_ = {first, first};
    restart(start_, 0, first);
  }

  void restart(State state, double time, double step) {
    stepper_.initialize(state, time, step);
    ++restarts_;
  }

  bool changed(const State &x) const {
    return system_.touching ? system_.gap(x) > 0 : system_.gap(x) < 0;
  }

  void change() {
    double lower = stepper_.previous_time();
    double upper = stepper_.current_time();
    State x;
    while (upper - lower > event_tolerance_) {
      const double middle = 0.5 * (lower + upper);
      if (middle <= lower || middle >= upper)
        break;
      stepper_.calc_state(middle, x);
      (changed(x) ? upper : lower) = middle;
    }
    stepper_.calc_state(upper, x);
    // The trial step that suited the mode last time.
    step_of_mode_[system_.touching] = stepper_.current_time_step();
    system_.touching = !system_.touching;
    impacts_ += system_.touching;
    restart(x, upper, step_of_mode_[system_.touching]);
  }

  // odeint does not tell rejections; every trial takes six evaluations, every restart one more.
  Outcome outcome() const {
    const State &x = stepper_.current_state();
    return {.state = Eigen::Map<const Vector>(x.data(), static_cast<Index>(x.size())),
            .steps = steps_,
            .rejected = (system_.evaluations - restarts_) / 6 - steps_,
            .impacts = impacts_,
            .evaluations = system_.evaluations};
  }

  using Stepper = typename boost::numeric::odeint::result_of::make_dense_output<
      boost::numeric::odeint::runge_kutta_dopri5<State>>::type;
  System system_;
  State start_;
  double end_;
  double event_tolerance_;
  Stepper stepper_;
  std::array<double, 2> step_of_mode_{};
  long steps_ = 0, restarts_ = 0, impacts_ = 0;
};

template <class System>
Side odeint_side(const System &system, const typename System::State &start, double end,
                 double event_tolerance) {
  return {.name = "odeint", .prepare = [=](const Tolerance &tolerance, bool) {
            return Motion(OdeintMotion<System>(system, start, end, event_tolerance, tolerance));
          }};
}

} // namespace vibroimpact::benchmarks
