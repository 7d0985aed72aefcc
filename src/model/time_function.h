// Scalar time histories s(t) with their first two derivatives.
#pragma once

#include "model/exponential_form.h"

#include <memory>
#include <optional>

namespace vibroimpact::model {

/// Smooth between its breaks. At a break every function returns the value from the right, the one
/// that holds in the piece that begins there.
class TimeFunction {
public:
  virtual ~TimeFunction() = default;

  virtual double value(double time) const = 0;
  virtual double rate(double time) const = 0;
  virtual double acceleration(double time) const = 0;

  /// Period [s]; 0 when there is none.
  virtual double period() const = 0;
  /// Highest angular frequency contained [rad/s], for the choice of a first time step.
  virtual double highest_frequency() const = 0;
  /// s = Im(S exp(i omega t)), with the period 2 pi / omega.
  virtual bool harmonic() const { return false; }
  /// The same function at another angular frequency [rad/s]; nullptr when it has no frequency.
  virtual std::shared_ptr<const TimeFunction> with_frequency(double angular_frequency) const = 0;

  /// First instant > time [s] at which s, s' or s'' is not smooth; +infinity when there is none.
  virtual double next_break(double time) const;
  /// The closed form with origin `time`, valid from there to next_break(time); nothing when the
  /// function has none, such as a sine sweep.
  virtual std::optional<ExponentialForm> exponential_form(double time) const;
};

/// Which of displacement, velocity and acceleration is given; the amplitude of that one stays
/// constant when the frequency is swept.
enum class Given { displacement, velocity, acceleration };

/// The given quantity is amplitude sin(omega t + phase); the others follow as its derivatives or
/// its integrals without constant.
class Harmonic : public TimeFunction {
public:
  /// amplitude [m, m/s, m/s^2, or that of a force], angular_frequency > 0 [rad/s], phase [rad]
  Harmonic(Given given, double amplitude, double angular_frequency, double phase);

  double value(double time) const override;
  double rate(double time) const override;
  double acceleration(double time) const override;
  double period() const override;
  double highest_frequency() const override { return angular_frequency_; }
  bool harmonic() const override { return true; }
  std::shared_ptr<const TimeFunction> with_frequency(double angular_frequency) const override;
  std::optional<ExponentialForm> exponential_form(double time) const override;

private:
  Given given_;
  double amplitude_;
  double angular_frequency_;
  double phase_;
  double displacement_amplitude_; ///< of s(t), with the phase shift below
  double shift_;
};

} // namespace vibroimpact::model
