// Values of keys that hold for one analysis: "set With = Variables/gap = 0.7 mm, ...".
#pragma once

#include "parameters/values.h"

#include <memory>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

/// Declares the key With.
void declare_constants(parameters::Section &analysis);

/// Of one section "Analysis NAME". InputError for a path that leads nowhere, a key that no analysis
/// may change, and one that stands there twice.
std::vector<parameters::Override> read_constants(const parameters::Values &analysis);

/// The file with the values of the analyses `names`, one after the other. InputError.
std::shared_ptr<const parameters::ParameterSet>
with_constants(const std::shared_ptr<const parameters::ParameterSet> &parameters,
               const std::vector<std::string> &names);

} // namespace vibroimpact::analyses
