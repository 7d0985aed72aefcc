// Fields of the modes of the whole linear system, below system/.
#pragma once

#include "analyses/results/field_writer.h"
#include "common/result_sink.h"
#include "model/assembled_system.h"

namespace vibroimpact::analyses {

/// frequency, damping_ratio, participation, effective masses, shapes at points and connections, and
/// shares of bodies and connections in the energies along system_mode; eigenvalues and shapes of
/// the damped motions along damped_mode.
void add_assembled_modes(const FieldWriter &result, const model::Model &model,
                         const model::AssembledModes &modes);

/// The modes as the instants of a motion at their frequencies [Hz], each so that its largest
/// displacement is a tenth of the largest body's size.
Motion motion_of_modes(const model::Model &model, const model::AssembledModes &modes);

} // namespace vibroimpact::analyses
