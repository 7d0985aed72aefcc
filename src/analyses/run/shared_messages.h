// The notes of all lines, in the memory of rank 0, which the others read and write.
#pragma once

#include <mpi.h>
#include <string>

namespace vibroimpact::analyses {

class SharedMessages {
public:
  /// Collective. Room for the notes of `tasks` lines, each of `size` bytes at most.
  SharedMessages(std::size_t tasks, std::size_t size, MPI_Comm communicator);
  ~SharedMessages();
  SharedMessages(const SharedMessages &) = delete;
  SharedMessages &operator=(const SharedMessages &) = delete;

  void leave(std::size_t task, const std::string &note);
  /// Waits for it. Lines are drawn in their order and ask for those before them only: the first
  /// line that is not done waits for none, so that no two ranks wait for each other. Interrupted
  /// when a rank has stopped.
  std::string of(std::size_t task);
  /// No rank waits any longer.
  void stop();

private:
  MPI_Aint place(std::size_t task) const;
  long flag(MPI_Aint place);
  void set_flag(MPI_Aint place);

  std::size_t slot_bytes_;
  char *memory_ = nullptr;
  MPI_Win window_ = MPI_WIN_NULL;
};

} // namespace vibroimpact::analyses
