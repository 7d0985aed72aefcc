// Files of numbers that the key File of a section names, and whether they are still what they were.
#pragma once

#include "parameters/values.h"

#include <string>
#include <vector>

namespace vibroimpact::reduction {

/// Where it is: the name is relative to `file_folder`.
std::string named_file(const parameters::Values &section, const std::string &file_folder);

/// Its whole content. reject()s a file that cannot be read or is empty, and one whose content
/// differs from the checksum ("NAME HASH") that was noted for it. Local.
std::string read_named_file(const parameters::Values &section, const std::string &file_folder,
                            const std::vector<std::string> &checksums);

/// "NAME HASH" of that file; "" where none is named or can be read. Local.
std::string file_checksum(const parameters::Values &section, const std::string &file_folder);

/// Is it an HDF5 file, by its suffix (.h5, .hdf5)?
bool is_hdf5(const std::string &file);

} // namespace vibroimpact::reduction
