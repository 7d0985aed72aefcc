// Results of a file with Units = dimensionless: analyses compute in SI, where a plain number of the
// file stands for itself; results are plain numbers again.
#pragma once

#include "derived/analysis_arrays.h"

#include <string>

namespace vibroimpact::derived {

/// What a value in `unit` is multiplied by: 2 pi for Hz, since frequencies of such a file are
/// angular; 1 for the coherent units of SI.
double plain_factor(const std::string &unit);

/// Without units in brackets: "displacement of a point" for "displacement [m] of a point".
std::string plain_description(std::string description);

void remove_units(AnalysisHeader &header);
void remove_units(AnalysisArrays &arrays);

} // namespace vibroimpact::derived
