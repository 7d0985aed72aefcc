// Excitations of the parameter file: forces, base motions and gravity.
#pragma once

#include "model/model.h"
#include "parameters/values.h"

#include <string>
#include <vector>

namespace vibroimpact::model {

void declare_excitations(parameters::Section &root);

/// Adds the excitations called `names` (instances of "Excitation") to the model.
void add_excitations(const parameters::Values &root, const std::vector<std::string> &names,
                     Model &model);

/// "NAME HASH" of every file that recorded histories read, for the key File checksums. Files
/// that cannot be read are left out. Local.
std::vector<std::string> record_checksums(const parameters::Values &root,
                                          const std::string &file_folder);

} // namespace vibroimpact::model
