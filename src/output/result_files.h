// The sink that keeps every finished point in a journal and builds the result files from it.
#pragma once

#include "common/result_sink.h"
#include "contact/truncation.h"
#include "derived/derived_quantities.h"
#include "output/hdf5_results.h"
#include "output/point_totals.h"
#include "output/record.h"
#include "output/run_folder.h"
#include "output/summary_list.h"
#include "reduction/reduced_body.h"

#include <chrono>
#include <functional>
#include <memory>
#include <mpi.h>
#include <vector>

namespace vibroimpact::output {

class FileSink : public ResultSink {
public:
  /// Collective. `folder` must live as long as the sink. While an analysis runs, rank 0 rebuilds
  /// the files when this much time has passed since the last time. `outlines`: see vtu_writer.h.
  /// Throws std::runtime_error when a journal cannot be opened.
  FileSink(MPI_Comm communicator, RunFolder &folder, RunInformation information,
           std::vector<reduction::ReducedBody> bodies,
           std::chrono::duration<double> rebuild_interval = std::chrono::seconds(60),
           derived::DerivedQuantities derived = {},
           std::vector<contact::ContactFigures> contacts = {},
           std::vector<std::vector<Matrix>> outlines = {}, YieldStresses yield_stresses = {});

  /// Throws std::logic_error when the analysis was begun before in this run, and InputError when a
  /// resumed folder holds the analysis with other axes.
  void begin(const AnalysisHeader &header) override;
  const PointResult *find(const std::vector<std::size_t> &index) const override;
  /// Throws std::runtime_error, on this rank alone, when the journal cannot be written.
  void store(const PointResult &result) override;
  std::vector<std::string> find_steps(const std::vector<std::size_t> &index) const override;
  /// As store().
  void store_steps(const std::vector<std::size_t> &index, std::size_t first,
                   const std::vector<std::string> &steps) override;
  /// Also writes the fields of points that recorded the motion (see vtu_writer.h), and warns of
  /// points that failed or are doubtful. Files that cannot be written are a warning: the journals
  /// keep every point.
  void end() override;

  /// Rank 0: replaces results.h5, summary.txt and summary.json by what all journals hold now. Warns
  /// of derived quantities that cannot be computed from the fields there are.
  void rebuild() { replace_files(); }

  /// Collective, behind the last end(). The derived quantities that the files lack, and why; empty
  /// when they lack none.
  std::string missing_derived() const;
  /// Collective, behind the last end(). Throws std::runtime_error when a file could not be written
  /// in the end.
  void check_written() const;

private:
  /// Whether `write` failed is for check_written() to say.
  void try_to_write(const std::function<void()> &write);
  void register_header(const AnalysisHeader &header);
  /// Returns what all journals hold now.
  std::vector<StoredAnalysis> replace_files();
  /// What the summary says of derived quantities, for each analysis.
  std::vector<SummaryList> write_results(const std::filesystem::path &file,
                                         const std::vector<StoredAnalysis> &analyses);
  SummaryList summary(const std::vector<StoredAnalysis> &analyses,
                      const std::vector<SummaryList> &derived);
  void note_problems(const std::vector<std::string> &problems);
  void write_motion(const StoredPoints &points);
  void tell_totals() const;

  MPI_Comm communicator_;
  RunFolder &folder_;
  RunInformation information_;
  std::vector<reduction::ReducedBody> bodies_;
  derived::DerivedQuantities derived_;
  std::vector<contact::ContactFigures> contacts_;
  std::vector<std::vector<Matrix>> outlines_; ///< of the cross-sections of each body
  YieldStresses yield_stresses_;
  std::vector<std::string> problems_; ///< of derived quantities, on rank 0
  std::string unwritten_;             ///< why the last files could not be written, on rank 0
  std::unique_ptr<RecordWriter> record_writer_;
  std::set<std::string> begun_;
  AnalysisHeader header_;
  PointTotals totals_;  ///< of that analysis, as summary.txt has them, on rank 0
  StoredPoints stored_; ///< points of the analysis from an earlier run
  StoredSteps steps_;   ///< towards those that it did not get to

  using Clock = std::chrono::steady_clock;
  std::chrono::duration<double> rebuild_interval_;
  Clock::time_point next_rebuild_;
};

} // namespace vibroimpact::output
