// A single pulse of force, base velocity or base acceleration; zero before and after.
//
//   rectangular   peak                               area  peak duration
//   half sine     peak sin(pi tau)                         2/pi peak duration
//   triangular    peak (1 - |2 tau - 1|)                   1/2 peak duration
//   versed sine   peak (1 - cos(2 pi tau)) / 2             1/2 peak duration
//
// with tau = (t - start) / duration from 0 to 1. After a pulse of base acceleration the base keeps
// the velocity that the pulse gave it.
#pragma once

#include "model/history.h"

namespace vibroimpact::model {

enum class PulseShape { rectangular, half_sine, triangular, versed_sine };

/// Derivatives of the pulse that exist everywhere as functions, without an impulse of their own:
/// 0 rectangular, 1 half sine and triangular, 2 versed sine.
int smoothness(PulseShape shape);

/// Area under the pulse, divided by peak and duration.
double area_factor(PulseShape shape);

/// peak [m, m/s, m/s^2, N], start [s], duration > 0 [s]
std::shared_ptr<const TimeFunction> make_pulse(Given given, PulseShape shape, double peak,
                                               double start, double duration);

void declare_pulse(parameters::Section &excitation);
TimeFunctionPointer create_pulse(const parameters::Values &excitation,
                                 const HistoryContext &context);

} // namespace vibroimpact::model
