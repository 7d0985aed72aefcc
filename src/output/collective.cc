#include "output/collective.h"

#include "common/error.h"

#include <string>

namespace vibroimpact::output {

namespace {

enum class Outcome : int { fine, input_error, other_error };

Outcome outcome_of(const std::function<void()> &work, std::string &message) {
  try {
    work();
  } catch (const InputError &error) {
    message = error.what();
    return Outcome::input_error;
  } catch (const std::exception &error) {
    message = error.what();
    return Outcome::other_error;
  }
  return Outcome::fine;
}

/// The number of ranks when all went well.
int first_failing_rank(MPI_Comm communicator, Outcome outcome) {
  int size = 0;
  MPI_Comm_size(communicator, &size);
  const int mine = outcome == Outcome::fine ? size : rank_in(communicator);
  int first = size;
  MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, communicator);
  return first;
}

} // namespace

int rank_in(MPI_Comm communicator) {
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  return rank;
}

void run_on_all_ranks(MPI_Comm communicator, const std::function<void()> &work) {
  std::string message;
  const Outcome outcome = outcome_of(work, message);
  int size = 0;
  MPI_Comm_size(communicator, &size);
  const int source = first_failing_rank(communicator, outcome);
  if (source == size)
    return;
  int description[2] = {static_cast<int>(outcome), static_cast<int>(message.size())};
  MPI_Bcast(description, 2, MPI_INT, source, communicator);
  message.resize(static_cast<std::size_t>(description[1]));
  MPI_Bcast(message.data(), description[1], MPI_CHAR, source, communicator);
  if (description[0] == static_cast<int>(Outcome::input_error))
    throw InputError(message);
  throw std::runtime_error(message);
}

void run_on_first_rank(MPI_Comm communicator, const std::function<void()> &work) {
  run_on_all_ranks(communicator, [&] {
    if (rank_in(communicator) == 0)
      work();
  });
}

} // namespace vibroimpact::output
