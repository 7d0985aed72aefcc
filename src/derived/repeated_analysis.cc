#include "derived/repeated_analysis.h"

#include "analyses/results/fields.h"
#include "analyses/run/grid_line.h"
#include "common/error.h"
#include "common/signals.h"
#include "common/work_limit.h"
#include "derived/analysis_arrays.h"
#include "derived/derived_quantities.h"
#include "derived/dimensionless.h"
#include "derived/units_of_fields.h"
#include "parameters/text.h"

#include <algorithm>

namespace vibroimpact::derived {

using analyses::Evaluated;
using analyses::Outcome;
using parameters::Override;

namespace {

class PointsInMemory : public ResultSink {
public:
  void begin(const AnalysisHeader & /*header*/) override {}
  const PointResult *find(const std::vector<std::size_t> & /*index*/) const override {
    return nullptr;
  }
  void store(const PointResult &result) override { points_.push_back(result); }
  void end() override {
    std::sort(points_.begin(), points_.end(),
              [](const PointResult &a, const PointResult &b) { return a.index < b.index; });
  }
  const std::vector<PointResult> &points() const { return points_; }
  PointSequence sequence() const {
    return [this](const auto &visit) { std::for_each(points_.begin(), points_.end(), visit); };
  }

private:
  std::vector<PointResult> points_;
};

class FirstPoint : public PointsInMemory {
public:
  void store(const PointResult &result) override {
    PointsInMemory::store(result);
    throw Interrupted{}; // the others are not needed
  }
};

class ShareOfPoints : public analyses::LineProgress {
public:
  ShareOfPoints(std::size_t total, const std::function<void(double)> &progress)
      : total_(static_cast<double>(total)), progress_(progress) {}
  void count() override { progress_(++done_ / total_); }
  void note_share(double share) override { progress_((done_ + share) / total_); }

private:
  double total_, done_ = 0;
  const std::function<void(double)> &progress_;
};

DerivedQuantities quantities_of(const Repetition &repetition, const analyses::Case &first) {
  std::vector<Axis> axes = repetition.outer_axes;
  for (const Axis &axis : first.analysis->axes())
    axes.push_back(axis);
  DerivedQuantities quantities;
  quantities.add(repetition.root, repetition.analysis, axes, repetition.keys);
  return quantities;
}

// InputError becomes NumericalError: these values of keys cannot be used, others can.
template <class Work> auto numerical(Work work) {
  try {
    return work();
  } catch (const InputError &error) {
    throw NumericalError(error.what());
  }
}

AnalysisHeader header_of(const Repetition &repetition, const analyses::Case &first) {
  const std::vector<Axis> inner = first.analysis->axes();
  AnalysisHeader header{
      .name = repetition.analysis, .type = first.analysis->type(), .axes = repetition.outer_axes};
  header.axes.insert(header.axes.end(), inner.begin(), inner.end());
  return header;
}

void run(const Repetition &repetition, const analyses::Case &first,
         const std::function<void(double)> &progress, PointsInMemory &sink) {
  const std::vector<Axis> inner = first.analysis->axes();
  ShareOfPoints share(analyses::points_of(header_of(repetition, first).axes), progress);
  analyses::RunSummary summary;
  analyses::GridLine context(sink, inner, share, summary);
  analyses::KeptAnalysis kept;
  const std::size_t lines = first.analysis->lines();
  for (std::size_t task = 0; task < analyses::grid_size(repetition.keys) * lines; ++task)
    analyses::run_task(task, repetition.keys, lines, repetition.factory, kept, context);
  sink.end();
}

// An extreme value over the points that are left would be better than the whole deserves.
void refuse_failed_points(const std::vector<PointResult> &points) {
  const auto failed = [](const PointResult &point) { return point.status == Status::failed; };
  const auto first = std::find_if(points.begin(), points.end(), failed);
  if (first == points.end())
    return;
  throw NumericalError(points.size() == 1
                           ? first->reason
                           : std::to_string(std::count_if(points.begin(), points.end(), failed)) +
                                 " of " + std::to_string(points.size()) +
                                 " points failed: " + first->reason);
}

Axis dimension_of(const std::string &name, const Source &source, const std::vector<Axis> &own) {
  for (const std::vector<Axis> *axes : {&source.dimensions, &own})
    for (const Axis &axis : *axes)
      if (axis.name == name)
        return axis;
  throw std::logic_error("no dimension " + name);
}

Outcome outcome_of(const LabelledArray &array, const Source &source,
                   const std::vector<Axis> &own = {}) {
  Outcome outcome{.unit = array.unit,
                  .one = one(array.unit),
                  .description = array.description,
                  .axes = {},
                  .axis_ones = {},
                  .values = {array.values, array.values + number_of_values(array.shape)}};
  for (const std::string &name : array.dimensions) {
    outcome.axes.push_back(dimension_of(name, source, own));
    outcome.axis_ones.push_back(one(outcome.axes.back().unit));
  }
  return outcome;
}

Outcome find_outcome(const std::string &name, const std::string &analysis, const Source &source,
                     const DerivedQuantities::Result &derived) {
  std::vector<std::string> known;
  for (const DerivedArray &array : derived.arrays) {
    if (array.name == name)
      return outcome_of(array.view(), source, array.own_dimensions);
    known.push_back(array.name);
  }
  for (const LabelledArray &array : source.arrays) {
    if (array.name == name)
      return outcome_of(array, source);
    known.push_back(array.name);
  }
  const std::string near = parameters::suggestion(name, known);
  std::string message = "'" + name + "' is no field of the analysis " + analysis +
                        " and no quantity derived from it" + (near.empty() ? "." : near) +
                        " There are: " + parameters::join(known, ", ") + ".";
  for (const std::string &problem : derived.problems)
    message += "\n" + problem;
  throw InputError(message);
}

std::vector<Outcome> find_outcomes(const std::vector<std::string> &names,
                                   const Repetition &repetition, const analyses::Case &first,
                                   const PointsInMemory &points) {
  AnalysisHeader header = header_of(repetition, first);
  AnalysisArrays arrays = assemble(header, points.sequence());
  if (repetition.root.parameters().dimensionless()) {
    remove_units(header);
    remove_units(arrays);
  }
  const Source source = derivation_source(header, arrays);
  const auto derived = quantities_of(repetition, first).evaluate(repetition.analysis, source);
  std::vector<Outcome> outcomes;
  for (const std::string &name : names)
    outcomes.push_back(find_outcome(name, repetition.analysis, source, derived));
  return outcomes;
}

} // namespace

void RepeatedAnalysis::check(const std::string &analysis,
                             const std::vector<Override> &overrides) const {
  const Repetition repetition = source_(analysis, overrides);
  const analyses::Case first = repetition.factory(analyses::grid_overrides(repetition.keys, 0));
  std::vector<std::string> changed = analyses::grid_paths(repetition.keys);
  for (const std::string &path : first.analysis->changed_keys())
    changed.push_back(path);
  const parameters::ParameterSet &set = repetition.root.parameters();
  for (const Override &change : overrides)
    for (const std::string &path : changed)
      if (!path.empty() && set.key_path(path) == set.key_path(change.path))
        throw InputError(change.origin + " " + change.path +
                         " must not be changed here, since the analysis " + repetition.analysis +
                         " changes it itself.");
  analyses::check_case(first);
  quantities_of(repetition, first);
}

Evaluated RepeatedAnalysis::evaluate(const std::string &analysis,
                                     const std::vector<Override> &overrides,
                                     const std::vector<std::string> &names,
                                     const std::function<void(double share)> &progress) const {
  const Repetition repetition = numerical([&] { return source_(analysis, overrides); });
  const analyses::Case first =
      numerical([&] { return repetition.factory(analyses::grid_overrides(repetition.keys, 0)); });
  PointsInMemory sink;
  run(repetition, first, progress, sink);
  refuse_failed_points(sink.points());
  Evaluated evaluated{.outcomes = find_outcomes(names, repetition, first, sink)};
  for (const PointResult &point : sink.points()) {
    evaluated.unbalanced += analyses::unbalanced(point) ? 1 : 0;
    evaluated.unsettled += analyses::recorded_unsettled(point) ? 1 : 0;
  }
  return evaluated;
}

std::optional<Evaluated> RepeatedAnalysis::try_first_point(const std::string &analysis,
                                                           const std::vector<Override> &overrides,
                                                           const std::vector<std::string> &names,
                                                           double seconds) const {
  const WorkLimit limit(seconds);
  const Repetition repetition = source_(analysis, overrides);
  const analyses::Case first = repetition.factory(analyses::grid_overrides(repetition.keys, 0));
  FirstPoint sink;
  try {
    run(
        repetition, first, [](double) {}, sink);
  } catch (const Interrupted &) {
    if (sink.points().empty() || sink.points().front().status == Status::failed)
      return std::nullopt;
  }
  try {
    return Evaluated{.outcomes = find_outcomes(names, repetition, first, sink)};
  } catch (const InputError &) { // a field may be missing from this point alone
  }
  try {
    return evaluate(analysis, overrides, names, [](double) {});
  } catch (const NumericalError &) {
  } catch (const Interrupted &) {
  }
  return std::nullopt;
}

} // namespace vibroimpact::derived
