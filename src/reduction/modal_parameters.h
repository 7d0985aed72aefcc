// The section of a body that is given by its modes.
#pragma once

#include "parameters/values.h"
#include "reduction/modal_definition.h"

namespace vibroimpact::reduction {

/// Declares the subsection Modal data of a body.
void declare_modal_data(parameters::Section &body);
/// Declares what only points of such a body have.
void declare_modal_point(parameters::Section &point);
/// The keys of declare_modal_point().
std::vector<std::string> modal_point_keys();

/// `folder` is that of the parameter file. Throws InputError.
ModalDefinition read_modal_definition(const parameters::Values &body, const std::string &folder);

/// "FILE HASH" of the file of such a body, to be kept in File checksums; "" for others. Local.
std::string modal_file_checksum(const parameters::Values &body, const std::string &folder);
/// reject()s such a body whose file is not what it was when its checksum was noted. Local.
void check_modal_file(const parameters::Values &body, const std::string &folder,
                      const std::vector<std::string> &checksums);

} // namespace vibroimpact::reduction
