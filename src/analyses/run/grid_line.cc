#include "analyses/run/grid_line.h"

#include "analyses/results/fields.h"
#include "analyses/run/shared_messages.h"
#include "analyses/run/stored_steps.h"
#include "common/error.h"
#include "common/signals.h"

#include <numeric>

namespace vibroimpact::analyses {

void GridLine::move_to(std::vector<std::size_t> position) {
  position_ = std::move(position);
  own_axes_.clear();
}

void GridLine::use(const Case &work, std::vector<std::size_t> position, std::size_t first) {
  move_to(std::move(position));
  first_ = first;
  own_axes_ = work.analysis->axes();
  source_ = work.source;
  outcomes_ = work.outcomes;
}

const PointResult *GridLine::find(const std::vector<std::size_t> &index) const {
  return sink_.find(full(index));
}

void GridLine::store(PointResult result) {
  if (result.status == Status::finished)
    add_own_coordinates(result);
  result.index = full(result.index);
  sink_.store(result);
  ++(result.status == Status::failed ? summary_.failed : summary_.finished);
  summary_.unbalanced += unbalanced(result) ? 1 : 0;
  progress_.count();
  leave_if_stopped();
}

void GridLine::note_progress(double share) {
  progress_.note_share(share);
  leave_if_stopped();
}

void GridLine::leave_message(std::size_t line, const std::string &note) {
  if (notes_ != nullptr)
    notes_->leave(first_ + line, note);
}

std::string GridLine::message_of(std::size_t line) const {
  return notes_ != nullptr ? notes_->of(first_ + line) : std::string();
}

std::unique_ptr<StepRecord> GridLine::steps(const std::vector<std::size_t> &index) {
  return std::make_unique<StoredSteps>(sink_, full(index), summary_);
}

const Outcomes &GridLine::outcomes() const {
  return outcomes_ ? *outcomes_ : LineContext::outcomes();
}

std::vector<std::size_t> GridLine::full(const std::vector<std::size_t> &index) const {
  std::vector<std::size_t> whole = position_;
  whole.insert(whole.end(), index.begin(), index.end());
  return whole;
}

void GridLine::add_own_coordinates(PointResult &result) const {
  for (std::size_t k = 0; k < own_axes_.size(); ++k)
    if (own_axes_[k].values != shared_axes_[k].values)
      FieldWriter(result).number(
          "own/" + own_axes_[k].name, own_axes_[k].values[result.index[k]], own_axes_[k].unit,
          "where the grid changes the values of that axis: its value at this point");
}

std::size_t points_of(const std::vector<Axis> &axes) {
  return std::accumulate(axes.begin(), axes.end(), std::size_t{1},
                         [](std::size_t size, const Axis &axis) { return size * axis.size(); });
}

namespace {

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

} // namespace

void run_task(std::size_t task, const std::vector<GridKey> &keys, std::size_t lines,
              const CaseFactory &factory, KeptAnalysis &kept, GridLine &context) {
  const std::vector<Axis> &axes = context.shared_axes();
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
      throw InputError("the swept key must not change the number of points of the analysis");
    context.use(work, grid_index(keys, point), point * lines);
    work.analysis->run_line(line, work.system, context);
  } catch (const InputError &error) {
    record_unusable(axes, error.what(), line, context);
  }
}

} // namespace vibroimpact::analyses
