#include "motion/steps/steppers.h"

#include "common/error.h"
#include "motion/steps/high_order_stepper.h"
#include "motion/steps/ts_stepper.h"

namespace vibroimpact::motion {

namespace {

// With the decay l of the stiff damping a velocity error d is a force error m l d. The steps of an
// explicit method, which are no longer than 6/l, keep d far below the tolerance; longer ones have
// to be asked for it. Much less than this is the rounding of creeping bodies, at which no step
// ends.
Settings for_stiff_phases(Settings settings) {
  constexpr double share_of_tolerance = 1e-2;
  settings.absolute_tolerance *= share_of_tolerance;
  return settings;
}

// At the tolerances of a motion, 1e-9 and less, steps of order 3 would hardly be longer than those
// that stability leaves to the explicit method.
constexpr int implicit_order = 5;

} // namespace

Steppers::Steppers(Equations &equations, const Settings &settings)
    : equations_(equations), settings_(settings) {
  if (settings.method == "exact" || settings.method == "moments") {
    exact_ = std::make_unique<ExactStepper>(equations, settings);
    general_ = std::make_unique<HighOrderStepper>(equations, settings);
  } else {
    general_ = std::make_unique<TsStepper>(equations, settings, settings.method);
  }
  present_ = general_.get();
}

void Steppers::restart(double time, const Vector &x) {
  present_ = general_.get();
  if (exact_ && exact_->handles(time))
    present_ = exact_.get();
  present_->restart(time, x);
  stiffness_.begin();
}

// In the same phase, from where the present stepper has led.
void Steppers::go_on_with(Stepper &stepper) {
  const double time = present_->time();
  const Vector state = present_->state();
  present_ = &stepper;
  present_->restart(time, state);
}

// The step before tells whether another method is due.
void Steppers::choose() {
  const double length = present_->time() - present_->previous_time();
  if (length <= 0)
    return;
  if (present_ == implicit_.get()) {
    if (stiffness_.implicit_step(equations_, present_->time(), present_->state(), length))
      go_on_with(*general_);
  } else if (stiffness_.explicit_step(equations_, present_->time(), present_->state(), length)) {
    if (!implicit_)
      implicit_ = std::make_unique<TsStepper>(equations_, for_stiff_phases(settings_), "arkimex",
                                              implicit_order);
    go_on_with(*implicit_);
  }
}

void Steppers::step(double limit) {
  if (exact_ && present_ != exact_.get())
    choose();
  if (present_ == implicit_.get())
    step_implicitly(limit);
  else
    present_->step(limit);
}

// Where Newton's method does not converge, the explicit one goes on.
void Steppers::step_implicitly(double limit) {
  const double time = present_->time();
  const Vector state = present_->state();
  try {
    present_->step(limit);
  } catch (const NumericalError &) {
    stiffness_.give_up();
    present_ = general_.get();
    present_->restart(time, state);
    present_->step(limit);
  }
}

void Steppers::place(double time, const Vector &x) {
  present_ = exact_.get();
  exact_->place(time, x);
}

void Steppers::forget() {
  general_->forget();
  if (implicit_)
    implicit_->forget();
}

long Steppers::rejected_steps() const {
  return general_->rejected_steps() + (implicit_ ? implicit_->rejected_steps() : 0);
}

} // namespace vibroimpact::motion
