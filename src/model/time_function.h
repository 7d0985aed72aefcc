// Scalar time histories s(t) with their first two derivatives.
#pragma once

#include <complex>
#include <memory>
#include <optional>
#include <vector>

namespace vibroimpact {

/// A function as exponentials and a polynomial, in closed form:
///   s(t) = Re sum_k amplitude_k exp(exponent_k (t - origin)) + sum_j polynomial_j (t - origin)^j
struct ExponentialForm {
  struct Term {
    std::complex<double> amplitude;
    std::complex<double> exponent; ///< [1/s]
  };
  double origin = 0; ///< [s]
  std::vector<Term> terms;
  std::vector<double> polynomial;

  double value(double time) const;
  double rate(double time) const;
  double acceleration(double time) const;

  /// The same function with another origin.
  ExponentialForm about(double new_origin) const;
  /// The integral that is `constant` at the origin. Exponents must not be zero.
  ExponentialForm integral(double constant) const;
};

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

} // namespace vibroimpact
