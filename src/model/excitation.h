// Excitations of the parameter file: forces and base motions.
#pragma once

#include "model/model.h"
#include "parameters/values.h"

#include <string>
#include <vector>

namespace vibroimpact {

void declare_excitations(parameters::Section &root);

/// Adds the excitations called `names` (instances of "Excitation") to the model.
void add_excitations(const parameters::Values &root, const std::vector<std::string> &names,
                     Model &model);

} // namespace vibroimpact
