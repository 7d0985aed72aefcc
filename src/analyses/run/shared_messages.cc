#include "analyses/run/shared_messages.h"

#include "common/bytes.h"
#include "common/signals.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <thread>

namespace vibroimpact::analyses {

namespace {

constexpr std::size_t word = sizeof(double);
constexpr std::chrono::microseconds shortest_wait{50}, longest_wait{5000};

std::size_t whole_words(std::size_t bytes) { return (bytes + word - 1) / word * word; }

} // namespace

// A slot: whether the note is there, its length, its bytes. Before all slots: whether a rank has
// stopped.
SharedMessages::SharedMessages(std::size_t tasks, std::size_t size, MPI_Comm communicator)
    : slot_bytes_(2 * word + whole_words(size)) {
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  const MPI_Aint bytes = rank == 0 ? place(tasks) : 0;
  MPI_Win_allocate(bytes, 1, MPI_INFO_NULL, communicator, &memory_, &window_);
  if (rank == 0)
    std::memset(memory_, 0, static_cast<std::size_t>(bytes));
  MPI_Barrier(communicator);
  MPI_Win_lock_all(0, window_);
}

SharedMessages::~SharedMessages() {
  MPI_Win_unlock_all(window_);
  MPI_Win_free(&window_);
}

MPI_Aint SharedMessages::place(std::size_t task) const {
  return static_cast<MPI_Aint>(word + task * slot_bytes_);
}

long SharedMessages::flag(MPI_Aint place) {
  long value = 0;
  MPI_Fetch_and_op(nullptr, &value, MPI_LONG, 0, place, MPI_NO_OP, window_);
  MPI_Win_flush(0, window_);
  return value;
}

void SharedMessages::set_flag(MPI_Aint place) {
  const long set = 1;
  MPI_Accumulate(&set, 1, MPI_LONG, 0, place, 1, MPI_LONG, MPI_REPLACE, window_);
  MPI_Win_flush(0, window_);
}

void SharedMessages::leave(std::size_t task, const std::string &note) {
  const std::string bytes = packed(note);
  if (bytes.size() > slot_bytes_ - word)
    throw std::logic_error("the note of a line is longer than its room");
  const auto count = static_cast<int>(bytes.size());
  MPI_Put(bytes.data(), count, MPI_BYTE, 0, place(task) + static_cast<MPI_Aint>(word), count,
          MPI_BYTE, window_);
  MPI_Win_flush(0, window_);
  set_flag(place(task));
}

std::string SharedMessages::of(std::size_t task) {
  for (auto wait = shortest_wait; flag(place(task)) == 0; wait = std::min(2 * wait, longest_wait)) {
    if (flag(0) != 0)
      throw Interrupted{};
    leave_if_stopped();
    std::this_thread::sleep_for(wait);
  }
  std::string bytes(slot_bytes_ - word, '\0');
  const auto count = static_cast<int>(bytes.size());
  MPI_Get(bytes.data(), count, MPI_BYTE, 0, place(task) + static_cast<MPI_Aint>(word), count,
          MPI_BYTE, window_);
  MPI_Win_flush(0, window_);
  return Cursor(bytes).take<std::string>();
}

void SharedMessages::stop() { set_flag(0); }

} // namespace vibroimpact::analyses
