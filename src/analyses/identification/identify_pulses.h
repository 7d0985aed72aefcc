// The pulses of a measured force record.
#pragma once

#include "analyses/identification/identify_formulas.h"
#include "model/recorded_history.h"
#include "motion/event/impact_log.h"
#include "parameters/values.h"

#include <vector>

namespace vibroimpact::analyses {

/// Samples of a measured contact force, and the force from which on they are a pulse.
struct MeasuredForce {
  model::Samples samples; ///< time [s], force [N]; intervals may differ, as of a triggered recorder
  double threshold = 0;   ///< [N]
};

struct MeasuredPulse {
  double start = 0;    ///< first sample above the threshold [s]
  double duration = 0; ///< to the last one [s]; 0 for a single sample
  std::size_t samples = 0;
  PulseFigures figures;
};

/// Of samples above the threshold that follow each other; those that the ends of the record cut are
/// left out. The impulse is the trapezoidal sum from the sample before the first to that behind the
/// last, the peak force the largest sample.
std::vector<MeasuredPulse> pulses_of(const MeasuredForce &force);

/// Of an impact whose force is sampled at 0, T, 2 T, ...: largest sample and sum of samples times T
/// (the trapezoidal rule, as the force is zero at both ends) while it lasts. Both are zero when no
/// sample falls into it.
PulseFigures figures_of(const std::vector<double> &time, const std::vector<double> &force,
                        double interval, const motion::Impact &impact);

/// The keys File, Time column, ..., Threshold.
void declare_measured_force(parameters::Section &section);
/// Is there a File?
bool has_measured_force(const parameters::Values &section);
/// Reads the file. InputError.
MeasuredForce read_measured_force(const parameters::Values &section);

} // namespace vibroimpact::analyses
