// One line of one grid point, with the position in the grid before the indices of its points.
#pragma once

#include "analyses/results/field_writer.h"
#include "analyses/run/runner.h"

namespace vibroimpact::analyses {

class SharedMessages;

/// Who is to know how far a line is.
class LineProgress {
public:
  virtual ~LineProgress() = default;
  virtual void count() = 0;                  ///< a point is done
  virtual void note_share(double share) = 0; ///< of the point at hand, from 0 to 1
};

/// Puts the grid position before the point's own index and keeps count. The result file has one set
/// of axes, those of the first case: where a case has other values, its points say them.
class GridLine : public LineContext {
public:
  /// Keeps references.
  GridLine(ResultSink &sink, const std::vector<Axis> &axes, LineProgress &progress,
           RunSummary &summary, SharedMessages *notes = nullptr)
      : sink_(sink), shared_axes_(axes), progress_(progress), summary_(summary), notes_(notes) {}

  /// From now on lines of the case at this position of the grid, the first of which is number
  /// `first` of all.
  void use(const Case &work, std::vector<std::size_t> position, std::size_t first);

  const PointResult *find(const std::vector<std::size_t> &index) const override;
  void store(PointResult result) override;
  void note_progress(double share) override;
  std::unique_ptr<StepRecord> steps(const std::vector<std::size_t> &index) override;
  void skip() override { progress_.count(); }
  void leave_message(std::size_t line, const std::string &note) override;
  std::string message_of(std::size_t line) const override;
  System build(const std::vector<parameters::Override> &overrides) const override {
    return source_(overrides);
  }
  const Outcomes &outcomes() const override;

  /// Before a case that cannot be built.
  void move_to(std::vector<std::size_t> position);
  const std::vector<Axis> &shared_axes() const { return shared_axes_; }

private:
  std::vector<std::size_t> full(const std::vector<std::size_t> &index) const;
  void add_own_coordinates(PointResult &result) const;

  ResultSink &sink_;
  const std::vector<Axis> &shared_axes_;
  LineProgress &progress_;
  RunSummary &summary_;
  SharedMessages *notes_;
  std::size_t first_ = 0;
  std::vector<std::size_t> position_;
  std::vector<Axis> own_axes_;
  SystemSource source_;
  std::shared_ptr<const Outcomes> outcomes_;
};

/// Product of the lengths of the axes.
std::size_t points_of(const std::vector<Axis> &axes);

/// The analysis of a grid point, which may keep what its lines have in common.
struct KeptAnalysis {
  std::size_t point = 0;
  std::shared_ptr<const Analysis> analysis{};
};

/// Runs line `task` of all lines of all grid points, counted grid point by grid point. Where the
/// case cannot be used, its points are recorded as failed. Interrupted.
void run_task(std::size_t task, const std::vector<GridKey> &keys, std::size_t lines,
              const CaseFactory &factory, KeptAnalysis &kept, GridLine &context);

} // namespace vibroimpact::analyses
