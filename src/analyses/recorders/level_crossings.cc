#include "analyses/recorders/level_crossings.h"

#include "analyses/signals/zeros.h"
#include "common/scalar.h"
#include "parameters/expression.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace vibroimpact::analyses {

namespace {

constexpr const char *level_section = "Level crossings";
constexpr const char *level_dimension = "crossing_level";

std::vector<Observable> observed_points(const parameters::Values &values, const System &system) {
  const std::string quantity = values.choice("Quantity");
  const int order = quantity == "displacement" ? 0 : quantity == "velocity" ? 1 : 2;
  std::vector<Observable> observed = chosen_points(values, system, {order});
  if (observed.empty())
    values.reject("Points", "must name at least one point, or Connections at least one");
  for (const Observable &one : observed)
    if (one.unit != observed.front().unit)
      values.reject("Points", "must be such that all quantities have one unit, that of Levels, but "
                              "there are " +
                                  observed.front().unit + " and " + one.unit);
  return observed;
}

std::vector<double> read_levels(const parameters::Values &values, const std::string &unit) {
  values.require("Levels");
  values.require_dimension("Levels", parameters::evaluate("1 " + unit, {}).dimension);
  std::vector<double> levels = values.quantities("Levels");
  if (std::ranges::adjacent_find(levels, std::greater_equal<>()) != levels.end())
    values.reject("Levels", "must increase from value to value");
  return levels;
}

} // namespace

LevelCrossings::Labels::Labels(const Observable &observed)
    : rises(observed.path + "/up_crossings", "1", "how often a level is passed upwards",
            {level_dimension}),
      rate(observed.path + "/up_crossing_rate", "1/s", "how often per time", {level_dimension}),
      rate_error(observed.path + "/up_crossing_rate_error", "1/s", "its standard error",
                 {level_dimension}),
      fraction(observed.path + "/fraction_above", "1",
               "part of the window above a level, " + observed.description(), {level_dimension}),
      fraction_error(observed.path + "/fraction_above_error", "1", "its standard error",
                     {level_dimension}),
      passage(observed.path + "/first_passage", "s",
              "from the start of the window until a level is first passed, up or down",
              {level_dimension}) {}

void LevelCrossings::Level::add(bool is_above, double since_start, double length) {
  if (above && *above != is_above) {
    rises += is_above ? 1 : 0;
    passage = passage.value_or(since_start);
  }
  above = is_above;
  time_above += is_above ? length : 0;
}

LevelCrossings::LevelCrossings(LevelSettings settings, std::vector<Observable> observables)
    : settings_(std::move(settings)), observables_(std::move(observables)),
      labels_(observables_.begin(), observables_.end()) {}

void LevelCrossings::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      level_section, "The recorder of how often levels are passed, and for how long.");
  declare_points(section);
  section
      .choice("Quantity", "displacement", {"displacement", "velocity", "acceleration"},
              "What is compared with the levels: displacement or velocity relative to the base, or "
              "absolute acceleration, of masses that turn the rotation and its derivatives, of "
              "connections the elongation and its derivatives.")
      .quantities("Levels", "", dimension::any, range::any, "",
                  "Increasing, in the unit of the quantity.", 1, 1000)
      .required();
  WindowBlocks::declare(section, "the standard errors");
}

RecorderFactory LevelCrossings::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(level_section);
  return [values](const System &system) {
    std::vector<Observable> observed = observed_points(values, system);
    return std::make_unique<LevelCrossings>(
        LevelSettings{.levels = read_levels(values, observed.front().unit),
                      .blocks = values.integer("Blocks")},
        std::move(observed));
  };
}

void LevelCrossings::begin(const Window &window, const motion::Trajectory & /*trajectory*/) {
  window_ = window;
  levels_.assign(observables_.size() * settings_.levels.size(), {});
  blocks_.begin(window, settings_.blocks, totals());
}

void LevelCrossings::step(const motion::StepView &view) {
  auto level = levels_.begin();
  for (const Observable &observed : observables_) {
    const motion::Bernstein along_step = curve(observed.form, view);
    for (const double value : settings_.levels) {
      motion::Bernstein distance = along_step;
      distance += -value;
      add(*level++, value, distance, view);
    }
  }
  if (blocks_.ends_with(view))
    blocks_.end_block(view.end(), totals());
}

// Where it is zero but for rounding it stays on its side: a step that ends where a contact closes
// at that level may end just beyond it, and the next one begin just before.
void LevelCrossings::add(Level &level, double value, const motion::Bernstein &distance,
                         const motion::StepView &view) const {
  constexpr double rounding = 1e-12; // of the largest distance and the level
  const double start = view.start() - window_.start;
  if (distance.lower_bound() > 0 || distance.upper_bound() < 0)
    return level.add(distance.lower_bound() > 0, start, view.length());
  std::vector<double> ends = sign_changes(distance);
  if (ends.empty() || ends.back() < 1)
    ends.push_back(1);
  const double least =
      rounding * (std::max(-distance.lower_bound(), distance.upper_bound()) + std::abs(value));
  double from = 0;
  for (const double to : ends) {
    const double between = distance((from + to) / 2);
    const bool stays = std::abs(between) <= least && level.above.has_value();
    const bool above = stays ? *level.above : between > 0;
    level.add(above, start + from * view.length(), (to - from) * view.length());
    from = to;
  }
}

void LevelCrossings::period_end(long cycle, const motion::Trajectory &trajectory) {
  if (blocks_.ends_with_period(cycle))
    blocks_.end_block(trajectory.time(), totals());
}

void LevelCrossings::end(const motion::Trajectory &trajectory) {
  blocks_.end_block(trajectory.time(), totals());
}

// How often each level has been passed upwards, then the times above each.
Vector LevelCrossings::totals() const {
  const auto size = static_cast<Index>(levels_.size());
  Vector totals(2 * size);
  for (Index i = 0; i < size; ++i) {
    totals[i] = static_cast<double>(levels_[static_cast<std::size_t>(i)].rises);
    totals[size + i] = levels_[static_cast<std::size_t>(i)].time_above;
  }
  return totals;
}

template <typename Of>
std::vector<double> LevelCrossings::of_levels(std::size_t observable, Of of) const {
  const std::size_t count = settings_.levels.size();
  std::vector<double> values;
  for (std::size_t i = observable * count; i < (observable + 1) * count; ++i)
    values.push_back(of(i));
  return values;
}

void LevelCrossings::add_fields(const FieldWriter &result) const {
  const std::size_t count = settings_.levels.size();
  const Vector errors = blocks_.standard_errors();
  result.series(level_dimension, level_dimension, settings_.levels, observables_.front().unit,
                "level that is passed");
  for (std::size_t k = 0; k < observables_.size(); ++k) {
    const auto add = [&](const Label &label, auto of) {
      result.array(label, {count}, of_levels(k, of));
    };
    const auto rises = [&](std::size_t i) { return static_cast<double>(levels_[i].rises); };
    const auto error = [&](std::size_t i) { return errors[static_cast<Index>(i)]; };
    const Labels &labels = labels_[k];
    add(labels.rises, rises);
    add(labels.rate, [&](std::size_t i) { return rises(i) / window_.length(); });
    add(labels.rate_error, error);
    add(labels.fraction, [&](std::size_t i) { return levels_[i].time_above / window_.length(); });
    add(labels.fraction_error, [&](std::size_t i) { return error(levels_.size() + i); });
    add(labels.passage, [&](std::size_t i) { return levels_[i].passage.value_or(nan); });
  }
}

} // namespace vibroimpact::analyses
