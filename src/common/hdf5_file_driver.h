// How the HDF5 library writes the files of this program.
//
// Writes go to the file at once, so that a file of any size takes no memory, but a write that fails
// is kept from the library: it would end in a segmentation fault later on. What could not be
// written then stays in memory, large arrays apart, which the library does not read again, and the
// reason waits until the file is to be complete.
#pragma once

#include <cstdint>

namespace vibroimpact {

/// The first failure in writing a file.
struct WriteFailure {
  int error = 0; ///< errno; 0: none
};

/// Makes a file access property list (hid_t) for H5Fcreate(), to be closed by H5Pclose(). `failure`
/// must live until the file is closed.
std::int64_t access_noting_failures(WriteFailure &failure);

} // namespace vibroimpact
