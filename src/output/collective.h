// One decision for all ranks: an error on any of them becomes the same error on every one.
#pragma once

#include <functional>
#include <mpi.h>

namespace vibroimpact::output {

/// Collective. Runs `work` on every rank and waits for all. If it threw on some, every rank throws
/// the error of the lowest of these: an InputError stays one, anything else becomes a
/// std::runtime_error with the same message.
void run_on_all_ranks(MPI_Comm communicator, const std::function<void()> &work);

/// Collective. The same for work that rank 0 alone does.
void run_on_first_rank(MPI_Comm communicator, const std::function<void()> &work);

int rank_in(MPI_Comm communicator);

} // namespace vibroimpact::output
