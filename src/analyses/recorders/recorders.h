// The list of recorders, and the key Record with which an analysis chooses among them.
#pragma once

#include "analyses/recorders/recorder.h"

#include <string>
#include <vector>

namespace vibroimpact::analyses {

/// Declares the key Record and the options of all recorders in the section of an analysis.
void declare_recorders(parameters::Section &analysis);

/// The recorders an analysis names, those called `fallback` when it names none, in the order of the
/// list. InputError for unknown names and options that cannot be used.
std::vector<RecorderFactory> read_recorders(const parameters::Values &analysis,
                                            const std::vector<std::string> &fallback);

/// Those of a sweep that names none: extreme values and impacts, all of them.
std::vector<RecorderFactory> default_recorders();

} // namespace vibroimpact::analyses
