// The list of time histories. A new one is a file pair and one line in histories.cc.
#pragma once

#include "model/history.h"

namespace vibroimpact::model {

/// Declares the choice `History` and the section of every history in an excitation section.
void declare_histories(parameters::Section &excitation);

/// The history an excitation section chooses. Throws InputError.
TimeFunctionPointer create_history(const parameters::Values &excitation,
                                   const HistoryContext &context);

} // namespace vibroimpact::model
