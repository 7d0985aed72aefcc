#include "integration/steppers.h"

#include "integration/high_order_stepper.h"
#include "integration/ts_stepper.h"

namespace vibroimpact::integration {

Steppers::Steppers(Equations &equations, const Settings &settings) {
  if (settings.method == "flight") {
    flight_ = std::make_unique<FlightStepper>(equations, settings);
    general_ = std::make_unique<HighOrderStepper>(equations, settings);
  } else {
    general_ = std::make_unique<TsStepper>(equations, settings, settings.method);
  }
  present_ = general_.get();
}

void Steppers::restart(double time, const Vector &x) {
  present_ = general_.get();
  if (flight_ && flight_->handles(time))
    present_ = flight_.get();
  present_->restart(time, x);
}

void Steppers::place(double time, const Vector &x) {
  present_ = flight_.get();
  flight_->place(time, x);
}

void Steppers::forget() { general_->forget(); }

} // namespace vibroimpact::integration
