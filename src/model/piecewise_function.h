// Time histories that have a closed form on each of several pieces: pulses, records, constants.
#pragma once

#include "model/time_function.h"

#include <array>
#include <cmath>
#include <vector>

namespace vibroimpact::model {

/// A closed form near its origin. There its terms may cancel: the displacement of a half-sine pulse
/// of acceleration begins like t^3, the difference of terms that begin like t. Its Taylor
/// polynomial is exact where those differences are rounding at most, and for |exponent t| <= 1/16
/// no worse than the closed form anywhere: the remainder after degree 11 is below (1/16)^12 / 12! =
/// 1e-23 of the terms.
class Onset {
public:
  explicit Onset(const ExponentialForm &form);

  bool covers(double time) const { return std::abs(time - origin_) <= length_; }
  /// s, s' or s''
  double derivative(int order, double time) const;

private:
  static constexpr int degree = 11;

  double origin_ = 0;
  double length_ = -1; ///< [s]; negative where the closed form cannot cancel
  std::array<double, degree + 1> coefficients_{};
};

/// A function and the instants at which one closed form gives way to the next.
struct Pieces {
  std::vector<double> breaks;         ///< increasing [s]
  std::vector<ExponentialForm> forms; ///< one more: forms[k] holds from breaks[k - 1] to breaks[k]

  std::size_t index(double time) const;
  const ExponentialForm &at(double time) const { return forms[index(time)]; }
  /// The continuous integral that is zero at the first break (at the origin of the only form
  /// without breaks). The origin of forms[k] must be breaks[k - 1], that of forms[0] breaks[0].
  Pieces integral() const;
};

class PiecewiseFunction : public TimeFunction {
public:
  /// `pieces` are those of s(t). highest_frequency [rad/s] as in TimeFunction.
  PiecewiseFunction(Pieces pieces, double highest_frequency);
  /// `given` are those of the displacement, velocity or acceleration; s(t) is their integral that
  /// is zero, with its rate, at the first break.
  PiecewiseFunction(Given quantity, Pieces given, double highest_frequency);

  double value(double time) const override;
  double rate(double time) const override;
  double acceleration(double time) const override;
  double period() const override { return 0; }
  double highest_frequency() const override { return highest_frequency_; }
  std::shared_ptr<const TimeFunction> with_frequency(double /*omega*/) const override {
    return nullptr;
  }
  double next_break(double time) const override;
  std::optional<ExponentialForm> exponential_form(double time) const override;

private:
  const Onset *onset(std::size_t piece, double time) const;

  Pieces pieces_;
  std::vector<Onset> onsets_; ///< of the pieces; empty where none can cancel
  double highest_frequency_;
};

/// The given quantity has the same value [m, m/s, m/s^2, N] at all times.
std::shared_ptr<const TimeFunction> make_constant(Given quantity, double value);

} // namespace vibroimpact::model
