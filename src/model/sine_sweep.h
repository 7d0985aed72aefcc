// A sine whose frequency runs from one value to another, continuous in phase:
//
//   amplitude w(t) sin(phase(t)),   phase' = omega(t)   for 0 <= t <= duration,   zero before.
//
//   linear        omega = from + (to - from) t / duration
//   logarithmic   omega = from (to / from)^(t / duration)
//
// The envelope w rises within `fade_in` and falls within `fade_out` before the end by the quintic
// u^3 (10 - 15 u + 6 u^2), so that two derivatives stay continuous; otherwise it is 1. After the
// end the sine goes on at the last frequency, or the given quantity is zero.
//
// A given displacement is differentiated. A given velocity or acceleration is integrated by Gauss
// quadrature over at most an eighth of a period at a time, to rounding: no closed form holds for
// all envelopes and laws. The constants of integration are those without drift:
//   velocity      at the end the displacement is that of the harmonic, -w a cos(phase) / omega;
//   acceleration  at both ends it is that of the harmonic, -w a sin(phase) / omega^2.
// Before the start, and after the end of a sweep that stops, the base keeps the velocity it has.
#pragma once

#include "model/history.h"

#include <vector>

namespace vibroimpact::model {

struct SweepDefinition {
  Given given = Given::displacement;
  double amplitude = 0; ///< of the given quantity
  double phase = 0;     ///< at t = 0 [rad]
  double from = 0;      ///< > 0 [rad/s]
  double to = 0;        ///< > 0 [rad/s]
  double duration = 0;  ///< > 0 [s]
  bool logarithmic = false;
  bool hold = true;    ///< go on at the last frequency
  double fade_in = 0;  ///< [s], with fade_out at most the duration
  double fade_out = 0; ///< [s], 0 with hold
};

class SineSweep : public TimeFunction {
public:
  explicit SineSweep(const SweepDefinition &definition);

  static void declare(parameters::Section &excitation);
  static TimeFunctionPointer create(const parameters::Values &excitation,
                                    const HistoryContext &context);

  double value(double time) const override { return derivative(0, time); }
  double rate(double time) const override { return derivative(1, time); }
  double acceleration(double time) const override { return derivative(2, time); }
  double period() const override { return 0; }
  double highest_frequency() const override;
  std::shared_ptr<const TimeFunction> with_frequency(double /*omega*/) const override {
    return nullptr;
  }
  double next_break(double time) const override;
  /// Before and after the sweep only.
  std::optional<ExponentialForm> exponential_form(double time) const override;

  /// During the sweep: angular frequency [rad/s] and phase [rad].
  double frequency(double time) const;
  double phase(double time) const;

private:
  double time_of_advance(double advance) const;
  double derivative(int order, double time) const;
  double during(int order, double time) const;
  double given(int order, double time) const;
  double integral(int times, double time) const;
  double harmonic_displacement(double time) const;
  void make_cells();
  void choose_constants();
  void continue_outside();

  SweepDefinition definition_;
  double growth_; ///< rate of the frequency [rad/s^2], or of its logarithm [1/s]
  std::vector<double> breaks_;
  std::vector<double> cells_;    ///< edges of the cells of quadrature, 0 to duration
  std::vector<double> first_;    ///< integral of the given quantity up to each edge
  std::vector<double> second_;   ///< integral of that
  double velocity_constant_ = 0; ///< added to the first integral when there are two
  double constant_ = 0;          ///< added to the last integral
  ExponentialForm before_;
  ExponentialForm after_;
};

} // namespace vibroimpact::model
