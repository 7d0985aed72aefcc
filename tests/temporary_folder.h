// A folder that is empty at the start of a test and gone at its end; the same one on all ranks.
#pragma once

#include <array>
#include <cstdlib>
#include <filesystem>
#include <mpi.h>
#include <stdexcept>
#include <string>

namespace vibroimpact::testing {

class TemporaryFolder {
public:
  explicit TemporaryFolder(MPI_Comm communicator = MPI_COMM_SELF) : communicator_(communicator) {
    std::array<char, 256> name{};
    const std::string pattern = std::filesystem::temp_directory_path() / "vibroimpact-XXXXXX";
    pattern.copy(name.data(), name.size() - 1);
    if (rank() == 0 && ::mkdtemp(name.data()) == nullptr)
      throw std::runtime_error("cannot make a temporary folder");
    MPI_Bcast(name.data(), static_cast<int>(name.size()), MPI_CHAR, 0, communicator);
    path_ = name.data();
  }
  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder &operator=(const TemporaryFolder &) = delete;
  ~TemporaryFolder() {
    MPI_Barrier(communicator_);
    std::error_code ignored;
    if (rank() == 0)
      std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path &path() const { return path_; }

private:
  int rank() const {
    int rank = 0;
    MPI_Comm_rank(communicator_, &rank);
    return rank;
  }

  MPI_Comm communicator_;
  std::filesystem::path path_;
};

} // namespace vibroimpact::testing
