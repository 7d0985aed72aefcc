// A component of a unit vector that turns with a spin, s = cos(angle(t) + phase). An unbalance U
// [kg m] acts with the force -U s'', which grows with the square of the speed and in a ramp has a
// tangential part besides.
#pragma once

#include "model/spin_speed.h"
#include "model/time_function.h"

namespace vibroimpact::model {

class TurningComponent : public TimeFunction {
public:
  TurningComponent(const SpinSpeed &speed, double phase) : speed_(speed), phase_(phase) {}

  double value(double time) const override;
  double rate(double time) const override;
  double acceleration(double time) const override;
  double period() const override;
  double highest_frequency() const override { return speed_.highest(); }
  /// It belongs to the spin, which has the speed.
  std::shared_ptr<const TimeFunction> with_frequency(double /*omega*/) const override {
    return nullptr;
  }
  double next_break(double time) const override { return speed_.next_break(time); }
  /// Outside of a ramp only.
  std::optional<ExponentialForm> exponential_form(double time) const override;

private:
  double angle(double time) const { return speed_.angle(time) + phase_; }

  SpinSpeed speed_;
  double phase_;
};

} // namespace vibroimpact::model
