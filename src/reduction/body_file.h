// A reduced body as bytes: for a file that saves the eigen-solution of the next run, and for the
// copy that every rank gets.
//
// Format: the line "vibroimpact reduced body 10", 16 hexadecimal digits (FNV-1a, 64 bits, of all
// that follows), the fingerprint and the members of the body as in common/bytes.h.
#pragma once

#include "reduction/reduced_body.h"

#include <cstdint>
#include <mpi.h>
#include <optional>
#include <string>
#include <string_view>

namespace vibroimpact::reduction {

/// FNV-1a hash as 16 hexadecimal digits.
std::string content_hash(std::string_view content);

/// `fingerprint` stands for everything the body was made from.
std::string to_bytes(const ReducedBody &body, const std::string &fingerprint);

/// Empty when the bytes are damaged or have another format or fingerprint; `reason` says which.
std::optional<ReducedBody> from_bytes(const std::string &bytes, const std::string &fingerprint,
                                      std::string &reason);

/// Writes a neighbour file and renames it, so that the file is complete at every moment. Throws
/// InputError when it cannot be written. Local.
void save_body(const std::string &file, const ReducedBody &body, const std::string &fingerprint);

/// The whole file; empty when it does not exist or cannot be read. Local.
std::optional<std::string> read_file(const std::string &file);

/// Rank 0's text on every rank. Collective.
std::string broadcast(std::string text, MPI_Comm communicator);
/// Rank 0's body on every rank, byte for byte. Collective.
ReducedBody broadcast(const ReducedBody &body, MPI_Comm communicator);

} // namespace vibroimpact::reduction
