#include "integration/steppers.h"

namespace vibroimpact {

namespace {
const char *general_method(const IntegrationSettings &settings) {
  return settings.method == flight_type ? "rk" : settings.method.c_str();
}
} // namespace

Steppers::Steppers(Equations &equations, const IntegrationSettings &settings)
    : general_(equations, settings, general_method(settings)), present_(&general_) {
  if (settings.method == flight_type)
    flight_ = std::make_unique<FlightStepper>(equations, settings);
}

void Steppers::restart(double time, const Vector &x) {
  present_ = &general_;
  if (flight_ && flight_->handles(time))
    present_ = flight_.get();
  present_->restart(time, x);
}

void Steppers::place(double time, const Vector &x) {
  present_ = flight_.get();
  flight_->place(time, x);
}

void Steppers::forget() {
  general_.forget();
  if (flight_)
    flight_->forget();
}

} // namespace vibroimpact
