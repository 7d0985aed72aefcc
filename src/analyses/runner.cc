#include "analyses/runner.h"

#include "analyses/fields.h"
#include "common/error.h"
#include "common/progress.h"
#include "common/signals.h"

#include <algorithm>
#include <chrono>
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
class PointCounter {
public:
  PointCounter(SharedCounters &counters, Progress &progress)
      : counters_(counters), progress_(progress) {}

  void count() {
    ++untold_;
    if (Clock::now() - last_told_ >= std::chrono::milliseconds(100))
      tell();
  }

  void count_share(double share) {
    if (Clock::now() - last_told_ >= std::chrono::milliseconds(100))
      tell(share);
  }

  void tell(double share = 0) {
    const long before = counters_.add(points_done, untold_);
    progress_.update(static_cast<std::size_t>(before + untold_), share);
    untold_ = 0;
    last_told_ = Clock::now();
  }

private:
  using Clock = std::chrono::steady_clock;
  SharedCounters &counters_;
  Progress &progress_;
  long untold_ = 0;
  Clock::time_point last_told_{};
};

// Puts the grid position before the point's own index and keeps count. The result file has one set
// of axes, those of the first case: where a case has other values, its points tell them.
class GridLine : public LineContext {
public:
  GridLine(ResultSink &sink, const std::vector<Axis> &axes, PointCounter &counter,
           RunSummary &summary)
      : sink_(sink), shared_axes_(axes), counter_(counter), summary_(summary) {}

  void move_to(std::vector<std::size_t> position) {
    position_ = std::move(position);
    own_axes_.clear();
  }
  void use_axes(std::vector<Axis> axes) { own_axes_ = std::move(axes); }
  void build_from(SystemSource source) { source_ = std::move(source); }

  System build(const std::vector<parameters::Override> &overrides) const override {
    return source_(overrides);
  }

  const PointResult *find(const std::vector<std::size_t> &index) const override {
    return sink_.find(full(index));
  }

  void store(PointResult result) override {
    if (result.status == Status::finished)
      add_own_coordinates(result);
    result.index = full(result.index);
    sink_.store(result);
    ++(result.status == Status::failed ? summary_.failed : summary_.finished);
    summary_.unbalanced += unbalanced(result) ? 1 : 0;
    count();
    leave_if_stopped();
  }

  void note_progress(double share) override {
    counter_.count_share(share);
    leave_if_stopped();
  }

  void skip() override { count(); }

private:
  std::vector<std::size_t> full(const std::vector<std::size_t> &index) const {
    std::vector<std::size_t> whole = position_;
    whole.insert(whole.end(), index.begin(), index.end());
    return whole;
  }
  void count() { counter_.count(); }

  void add_own_coordinates(PointResult &result) const {
    for (std::size_t k = 0; k < own_axes_.size(); ++k)
      if (own_axes_[k].values != shared_axes_[k].values)
        result.fields.push_back(scalar_field(
            "own/" + own_axes_[k].name, own_axes_[k].values[result.index[k]], own_axes_[k].unit,
            "where the grid changes the values of that axis: its "
            "value at this point"));
  }

  ResultSink &sink_;
  const std::vector<Axis> &shared_axes_;
  PointCounter &counter_;
  RunSummary &summary_;
  std::vector<std::size_t> position_;
  std::vector<Axis> own_axes_;
  SystemSource source_;
};

std::size_t points_of(const std::vector<Axis> &axes) {
  return std::accumulate(axes.begin(), axes.end(), std::size_t{1},
                         [](std::size_t size, const Axis &axis) { return size * axis.size(); });
}

// Every point of the case that could not be built, recorded as failed.
void record_unusable(const std::vector<Axis> &axes, const std::string &reason, std::size_t line,
                     LineContext &context) {
  if (line > 0)
    return;
  for (std::size_t point = 0; point < points_of(axes); ++point) {
    std::vector<std::size_t> index(axes.size());
    std::size_t rest = point;
    for (std::size_t k = axes.size(); k-- > 0;) {
      index[k] = rest % axes[k].size();
      rest /= axes[k].size();
    }
    if (context.find(index))
      context.skip();
    else
      context.store({.index = index, .status = Status::failed, .reason = reason});
  }
}

// A rank that is done early waits here without burning its core, rank 0 with the progress in view.
void wait_for_all(PointCounter &counter, MPI_Comm communicator) {
  counter.tell();
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(communicator, &request);
  int done = 0;
  for (MPI_Test(&request, &done, MPI_STATUS_IGNORE); done == 0;
       MPI_Test(&request, &done, MPI_STATUS_IGNORE)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    counter.tell();
  }
  counter.tell(); // what the last rank told just before it came here
}

// Numbers that make up a physical state.
Index state_size(const System &system) {
  return 2 * system.model.size() + system.contacts.n_internal() + system.model.n_drive();
}

/// The analysis of a grid point, which may keep what its lines have in common.
struct KeptAnalysis {
  std::size_t point = 0;
  std::shared_ptr<const Analysis> analysis{};
};

// One line of one grid point.
void run_task(std::size_t task, const std::vector<GridKey> &keys, std::size_t lines,
              const std::vector<Axis> &axes, const CaseFactory &factory, KeptAnalysis &kept,
              GridLine &context) {
  const std::size_t point = task / lines;
  const std::size_t line = task % lines;
  context.move_to(grid_index(keys, point));
  try {
    Case work = factory(grid_overrides(keys, point));
    if (kept.analysis && kept.point == point)
      work.analysis = kept.analysis;
    kept = {.point = point, .analysis = work.analysis};
    if (work.analysis->axes().size() != axes.size() ||
        points_of(work.analysis->axes()) != points_of(axes))
      throw InputError("the swept key changes the number of points of the analysis");
    context.use_axes(work.analysis->axes());
    context.build_from(work.source);
    work.analysis->run_line(line, work.system, context);
  } catch (const InputError &error) {
    record_unusable(axes, error.what(), line, context);
  }
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
                       " changes the number of coordinates or of internal states at the value " +
                       variant.front().value + "; a state cannot be carried over.");
  work.analysis->check_built(work.source);
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
  {
    SharedCounters counters(communicator);
    Progress progress(points_of(header.axes), name, rank == 0);
    PointCounter counter(counters, progress);
    const auto total = static_cast<long>(grid_size(keys) * lines);
    GridLine context(sink, inner_axes, counter, summary);
    KeptAnalysis kept;
    try {
      for (long task = counters.add(next_line, 1); task < total && !stop_requested();
           task = counters.add(next_line, 1))
        run_task(static_cast<std::size_t>(task), keys, lines, inner_axes, factory, kept, context);
    } catch (const Interrupted &) {
      summary.interrupted = true;
    }
    wait_for_all(counter, communicator);
  }
  sink.end();
  long counts[3] = {static_cast<long>(summary.finished), static_cast<long>(summary.failed),
                    static_cast<long>(summary.unbalanced)};
  int interrupted = summary.interrupted || stop_requested() ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, counts, 3, MPI_LONG, MPI_SUM, communicator);
  MPI_Allreduce(MPI_IN_PLACE, &interrupted, 1, MPI_INT, MPI_MAX, communicator);
  return {.finished = static_cast<std::size_t>(counts[0]),
          .failed = static_cast<std::size_t>(counts[1]),
          .unbalanced = static_cast<std::size_t>(counts[2]),
          .interrupted = interrupted != 0};
}

} // namespace vibroimpact::analyses
