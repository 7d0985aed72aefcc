#include "modes/block_lanczos.h"

#include "common/signals.h"
#include "modes/krylov_space.h"

#include <algorithm>
#include <limits>
#include <string>

namespace vibroimpact::modes {

namespace {

// Of the vectors that are wanted. Their eigenvalues are as good as its square, relative to the gap.
constexpr double residual_tolerance = 1e-8;
constexpr int most_lanczos_restarts = 100;

Index count_converged(const RitzPairs &pairs) {
  return std::find_if(pairs.residuals.begin(), pairs.residuals.end(),
                      [](double residual) { return !(residual <= residual_tolerance); }) -
         pairs.residuals.begin();
}

/// A gap of ten times the residual behind it: the angle between the vectors in front of it and the
/// invariant subspace is then below residual / gap = 0.1 at most (Davis and Kahan's sine theorem),
/// so that no eigenvalue stands on the wrong side of it.
/// Number of converged pairs in front of the first gap at or after number `count`; 0 when there is
/// none yet.
Index converged_group(const RitzPairs &pairs, Index count) {
  const Index last = std::min(count_converged(pairs), pairs.values.size() - 1);
  for (Index end = count; end <= last; ++end) {
    const double gap = 1 - pairs.values[end] / pairs.values[end - 1];
    if (gap > std::max(least_relative_gap, 10 * pairs.residuals[end]))
      return end;
  }
  return 0;
}

void leave_together_if_stopped(MPI_Comm communicator) {
  int stop = stop_requested() ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &stop, 1, MPI_INT, MPI_MAX, communicator);
  if (stop != 0)
    throw Interrupted();
}

/// Columns with which a search of `count` pairs as a rule needs no restart.
Index room(Index count, Index mass_rank) {
  return std::min(4 * count + 60, mass_rank) + 2 * KrylovSpace::block_size;
}

/// Half of the pairs are kept; all of them, in a larger space, where half of them have converged
/// and the gap is yet to come.
void restart(KrylovSpace &space, const RitzPairs &pairs) {
  const bool enlarge = 2 * count_converged(pairs) >= space.size();
  space.condense(pairs, enlarge ? space.size() : space.size() / 2,
                 enlarge ? 2 * space.capacity() : space.capacity());
}

/// When OP has nothing more to offer: every eigenvalue there is, or every one that is not hidden
/// behind a multiple one.
LowestVectors all_vectors(const KrylovSpace &space, const RitzPairs &pairs, double shift, int count,
                          int mass_rank) {
  const Index size = pairs.values.size();
  if (size < count)
    throw NumericalError("The eigen-solution found only " + std::to_string(size) + " of " +
                         std::to_string(count) + " modes");
  return {space.vectors(pairs.coefficients), size >= mass_rank
                                                 ? std::numeric_limits<double>::infinity()
                                                 : shift + 2 / pairs.values[size - 1]};
}

} // namespace

LowestVectors lowest_eigenvectors(const Factorisation &shifted, Mat mass, int count, int mass_rank,
                                  const Block &known) {
  const Layout layout(mass);
  KrylovSpace space(shifted, mass, known.cols() + room(count, mass_rank), known);
  for (int restarts = 0; restarts <= most_lanczos_restarts;) {
    leave_together_if_stopped(layout.communicator);
    space.advance();
    const bool all = space.exhausted() || space.size() >= mass_rank;
    if (space.size() <= count && !all)
      continue;
    const RitzPairs pairs = space.ritz_pairs();
    if (const Index end = converged_group(pairs, count); end > 0)
      return {space.vectors(pairs.coefficients.leftCols(end)),
              shifted.shift() + 1 / pairs.values[end]};
    if (all)
      return all_vectors(space, pairs, shifted.shift(), count, mass_rank);
    if (space.full()) {
      restart(space, pairs);
      ++restarts;
    }
  }
  throw NumericalError("The eigen-solution did not converge");
}

} // namespace vibroimpact::modes
