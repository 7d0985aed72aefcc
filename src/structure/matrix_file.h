// A symmetric sparse matrix out of a text file that all ranks read together, each its part.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vibroimpact::structure {

/// Rows and columns from 0.
struct MatrixEntry {
  int row = 0;
  int column = 0;
  double value = 0;
  /// Half of what the entry exceeds its mirror image by; 0 where only one of the two is given.
  double skew = 0;
};

/// A file of the Matrix Market (coordinate, real or integer, symmetric or general; boisvert1996),
/// or lines ROW COLUMN VALUE without any header, as CalculiX writes them; numbers from 1. Of a file
/// without header and a symmetric one only one triangle may stand there. This rank's share of the
/// entries of the whole matrix: mirror images are added, those of a general file halved.
/// `size`: rows the matrix must have; `key` of Matrices: for messages. Collective. Throws the
/// DefinitionError of Matrices, the same on all ranks.
std::vector<MatrixEntry> read_matrix_file(const std::string &path, const std::string &key, int size,
                                          MPI_Comm communicator);

/// Throws the lowest rank's problem on all ranks, if there is one; empty: none. Collective.
void agree_on(const std::string &problem, const std::string &key, MPI_Comm communicator);

/// Of the bytes of a file, the same on any number of ranks; 0 when it cannot be read. Collective.
std::uint64_t file_hash(const std::string &path, MPI_Comm communicator);

} // namespace vibroimpact::structure
