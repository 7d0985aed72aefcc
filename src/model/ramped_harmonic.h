// A harmonic that grows from nothing: the given quantity is
//
//   amplitude (1 - exp(-ramp_rate t)) sin(omega t + phase)   for t >= 0,   zero before.
//
// With C = -i amplitude exp(i phase) that is Re C [exp(i omega t) - exp((i omega - ramp_rate) t)].
// A given velocity or acceleration is integrated term by term, each integration a division by the
// exponent and no constant added: in the end the base swings about zero as it does without ramp,
// and at t = 0 the displacement (and for a given acceleration the velocity) is not zero, as it is
// not without ramp. Before t = 0 the base moves with the velocity it has there.
#pragma once

#include "model/history.h"
#include "model/piecewise_function.h"

namespace vibroimpact::model {

class RampedHarmonic : public PiecewiseFunction {
public:
  /// amplitude of the given quantity, angular_frequency > 0 [rad/s], phase [rad], ramp_rate > 0
  /// [1/s]
  RampedHarmonic(Given given, double amplitude, double angular_frequency, double phase,
                 double ramp_rate);

  static void declare(parameters::Section &excitation);
  static TimeFunctionPointer create(const parameters::Values &excitation,
                                    const HistoryContext &context);

  /// Of the harmonic it grows into.
  double period() const override;
  std::shared_ptr<const TimeFunction> with_frequency(double angular_frequency) const override;

private:
  Given given_;
  double amplitude_;
  double phase_;
  double ramp_rate_;
};

} // namespace vibroimpact::model
