// The notes of all lines, in the memory of rank 0, which the others read and write.
#pragma once

#include "analyses/line_note.h"

#include <mpi.h>

namespace vibroimpact::analyses {

class SharedNotes {
public:
  /// Collective. Room for the notes of `tasks` lines.
  SharedNotes(std::size_t tasks, NoteSize size, MPI_Comm communicator);
  ~SharedNotes();
  SharedNotes(const SharedNotes &) = delete;
  SharedNotes &operator=(const SharedNotes &) = delete;

  void leave(std::size_t task, const LineNote &note);
  /// Waits for it. Lines are drawn in their order and ask for those before them only: the first
  /// line that is not done waits for none, so that no two ranks wait for each other. Interrupted
  /// when a rank has stopped.
  LineNote of(std::size_t task);
  /// No rank waits any longer.
  void stop();

private:
  MPI_Aint place(std::size_t task) const;
  long flag(MPI_Aint place);
  void set_flag(MPI_Aint place);

  NoteSize size_;
  std::size_t slot_bytes_;
  char *memory_ = nullptr;
  MPI_Win window_ = MPI_WIN_NULL;
};

} // namespace vibroimpact::analyses
