// Runs an analysis over MPI ranks, alone or at every point of a grid of parameter values.
//
// The work is distributed line by line: each rank, rank 0 included, takes the next line when it has
// finished one, because lines can differ a hundredfold in cost. Results do not depend on the rank
// that computed them.
#pragma once

#include "analyses/analysis.h"
#include "analyses/run/grid.h"
#include "analyses/run/outcomes.h"
#include "common/result_sink.h"

#include <functional>
#include <mpi.h>
#include <string>
#include <vector>

namespace vibroimpact::analyses {

/// An analysis with the system it works on, and how to build it with other values of some keys.
struct Case {
  std::shared_ptr<const Analysis> analysis;
  System system;
  SystemSource source;
  std::shared_ptr<const Outcomes> outcomes{}; ///< of the analysis that this one evaluates, if any
};

/// Everything that can be refused before the case runs, for all systems it will build. InputError.
void check_case(const Case &work);

/// Builds the case of one grid point from its overrides. Local, InputError allowed.
using CaseFactory = std::function<Case(const std::vector<parameters::Override> &)>;

struct RunSummary {
  std::size_t finished = 0; ///< points computed in this run, on all ranks
  std::size_t failed = 0;   ///< points recorded as failed in this run, on all ranks
  /// Points of this run, on all ranks, whose energy balance does not close.
  std::size_t unbalanced = 0;
  /// Steps towards points (common/step_record.h): those of an interrupted run that this one went
  /// on from, and its own.
  std::size_t steps_taken_over = 0;
  std::size_t steps_computed = 0;
  bool interrupted = false;
  /// What the result files lack because a derived quantity could not be computed; else empty.
  std::string left_out{};
};

/// Collective. Without keys the analysis runs once. In a grid, a point whose parameters cannot be
/// used is recorded as failed; without grid the InputError is thrown on every rank.
RunSummary run_analysis(const std::string &name, const std::vector<GridKey> &keys,
                        const std::vector<Axis> &outer_axes, const CaseFactory &factory,
                        ResultSink &sink, MPI_Comm communicator);

} // namespace vibroimpact::analyses
