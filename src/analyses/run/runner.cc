#include "analyses/run/runner.h"

#include "analyses/run/grid_line.h"
#include "analyses/run/shared_messages.h"
#include "common/error.h"
#include "common/log.h"
#include "common/progress.h"
#include "common/signals.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <numeric>
#include <thread>

namespace vibroimpact::analyses {

namespace {

// A counter on rank 0 that every rank can read and advance: the number of the next line to do, and
// of the points done.
class SharedCounters {
public:
  explicit SharedCounters(MPI_Comm communicator) {
    MPI_Comm_rank(communicator, &rank_);
    const MPI_Aint size = rank_ == 0 ? 2 * static_cast<MPI_Aint>(sizeof(long)) : 0;
    MPI_Win_allocate(size, sizeof(long), MPI_INFO_NULL, communicator, &memory_, &window_);
    if (rank_ == 0)
      memory_[0] = memory_[1] = 0;
    MPI_Barrier(communicator);
    MPI_Win_lock_all(0, window_);
  }
  ~SharedCounters() {
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
  }
  SharedCounters(const SharedCounters &) = delete;
  SharedCounters &operator=(const SharedCounters &) = delete;

  /// Adds to a counter and returns its value before.
  long add(int counter, long amount) {
    long before = 0;
    MPI_Fetch_and_op(&amount, &before, MPI_LONG, 0, counter, MPI_SUM, window_);
    MPI_Win_flush(0, window_);
    return before;
  }

private:
  int rank_ = 0;
  long *memory_ = nullptr;
  MPI_Win window_ = MPI_WIN_NULL;
};

enum : int { next_line = 0, points_done = 1 };

// Points done, reported to the others only now and then: a message for each would cost more than a
// cheap point itself. The clock decides when, for the display alone. Of the points at hand only
// the share of this rank's is known.
class PointCounter : public LineProgress {
public:
  PointCounter(SharedCounters &counters, Progress &progress)
      : counters_(counters), progress_(progress) {}

  void count() override {
    ++unreported_;
    if (Clock::now() - last_report_ >= std::chrono::milliseconds(100))
      report();
  }

  void note_share(double share) override {
    if (Clock::now() - last_report_ >= std::chrono::milliseconds(100))
      report(share);
  }

  void report(double share = 0) {
    const long before = counters_.add(points_done, unreported_);
    progress_.update(static_cast<std::size_t>(before + unreported_), share);
    unreported_ = 0;
    last_report_ = Clock::now();
  }

private:
  /// To some milliseconds, and many times as fast as an exact one: it is asked once a period.
  struct Clock {
    using time_point = std::chrono::milliseconds;
    static time_point now() {
      timespec time{};
      clock_gettime(CLOCK_MONOTONIC_COARSE, &time);
      return std::chrono::milliseconds(1000 * time.tv_sec + time.tv_nsec / 1000000);
    }
  };
  SharedCounters &counters_;
  Progress &progress_;
  long unreported_ = 0;
  Clock::time_point last_report_{};
};

// A rank that is done early waits here without burning its core, rank 0 with the progress in view.
void wait_for_all(PointCounter &counter, MPI_Comm communicator) {
  counter.report();
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(communicator, &request);
  int done = 0;
  for (MPI_Test(&request, &done, MPI_STATUS_IGNORE); done == 0;
       MPI_Test(&request, &done, MPI_STATUS_IGNORE)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    counter.report();
  }
  counter.report(); // what the last rank reported just before it came here
}

// Numbers that make up a physical state.
Index state_size(const System &system) {
  return 2 * system.model.size() + system.contacts.n_internal() + system.model.n_drive();
}

} // namespace

void check_case(const Case &work) {
  work.analysis->check(work.system);
  const Index size = state_size(work.system);
  const std::vector<std::vector<parameters::Override>> variants = work.analysis->variants();
  const std::size_t step = std::max<std::size_t>(1, variants.size() / 100); // see grid_probes()
  for (std::size_t v = 0; v < variants.size(); v += step)
    if (const auto &variant = variants[v]; state_size(work.source(variant)) != size)
      throw InputError("The swept key " + variant.front().path +
                       " must not change the number of coordinates or of internal states, but does "
                       "at the value " +
                       variant.front().value + "; a state cannot be carried over.");
  work.analysis->check_built(work.source);
  if (work.outcomes)
    work.analysis->check_outcomes(*work.outcomes);
}

RunSummary run_analysis(const std::string &name, const std::vector<GridKey> &keys,
                        const std::vector<Axis> &outer_axes, const CaseFactory &factory,
                        ResultSink &sink, MPI_Comm communicator) {
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  const Case first = factory(grid_overrides(keys, 0));
  check_case(first);
  const std::vector<Axis> inner_axes = first.analysis->axes();
  AnalysisHeader header{.name = name, .type = first.analysis->type(), .axes = outer_axes};
  for (const GridKey &key : keys)
    header.grid.push_back(key.path);
  header.axes.insert(header.axes.end(), inner_axes.begin(), inner_axes.end());
  sink.begin(header);

  RunSummary summary;
  const std::size_t lines = first.analysis->lines();
  const std::size_t notes_size = first.analysis->message_size();
  {
    SharedCounters counters(communicator);
    Progress progress(points_of(header.axes), name, rank == 0);
    PointCounter counter(counters, progress);
    const auto total = static_cast<long>(grid_size(keys) * lines);
    SharedMessages notes(notes_size > 0 ? grid_size(keys) * lines : 0, notes_size, communicator);
    GridLine context(sink, inner_axes, counter, summary, &notes);
    KeptAnalysis kept;
    try {
      for (long task = counters.add(next_line, 1); task < total && !stop_requested();
           task = counters.add(next_line, 1))
        run_task(static_cast<std::size_t>(task), keys, lines, factory, kept, context);
    } catch (const Interrupted &) {
      summary.interrupted = true;
    }
    if (summary.interrupted || stop_requested())
      notes.stop();
    wait_for_all(counter, communicator);
  }
  sink.end();
  long counts[5] = {static_cast<long>(summary.finished), static_cast<long>(summary.failed),
                    static_cast<long>(summary.unbalanced),
                    static_cast<long>(summary.steps_taken_over),
                    static_cast<long>(summary.steps_computed)};
  int interrupted = summary.interrupted || stop_requested() ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, counts, 5, MPI_LONG, MPI_SUM, communicator);
  MPI_Allreduce(MPI_IN_PLACE, &interrupted, 1, MPI_INT, MPI_MAX, communicator);
  if (counts[3] > 0)
    log::info("analysis " + name + ": " + std::to_string(counts[3]) +
              " steps towards a point were taken over from the interrupted run, " +
              std::to_string(counts[4]) + " were computed");
  return {.finished = static_cast<std::size_t>(counts[0]),
          .failed = static_cast<std::size_t>(counts[1]),
          .unbalanced = static_cast<std::size_t>(counts[2]),
          .steps_taken_over = static_cast<std::size_t>(counts[3]),
          .steps_computed = static_cast<std::size_t>(counts[4]),
          .interrupted = interrupted != 0};
}

} // namespace vibroimpact::analyses
