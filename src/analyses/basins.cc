#include "analyses/basins.h"

#include "analyses/fields.h"
#include "analyses/swept_system.h"
#include "common/error.h"

#include <algorithm>

namespace vibroimpact::analyses {

using periodic::Decision;
using periodic::Outcome;

namespace {

constexpr const char *section_name = "Basins";
constexpr const char *first_axis = "First axis", *second_axis = "Second axis";
/// Rows are shared out in so many lines, each of which searches the coarse part by itself.
constexpr std::size_t most_lines = 16;

// What a cell is marked with that leads to none of the motions of the coarse part.
constexpr double undecided = -1, no_motion = -2, another = -3;

// So many of the values as evenly as they come.
std::vector<double> thinned(const std::vector<double> &values, long count) {
  const std::size_t wanted = std::min(values.size(), static_cast<std::size_t>(count));
  std::vector<double> some;
  for (std::size_t i = 0; i < wanted; ++i)
    some.push_back(values[(2 * i + 1) * values.size() / (2 * wanted)]);
  return some;
}

void add(std::vector<model::InitialState> &starts, const BasinRow &row,
         const std::vector<double> &values) {
  for (const double value : values)
    starts.push_back(row.start(value));
}

Field attractor_field(const std::string &name, std::vector<double> values, const std::string &unit,
                      const std::string &description) {
  return series_field("attractors/" + name, "attractor", std::move(values), unit, description);
}

void add_attractors(PointResult &result, const BasinSearch &search, std::size_t known) {
  std::vector<double> multiples, moduli, states;
  for (std::size_t a = 0; a < known; ++a) {
    const periodic::Attractor &attractor = search.attractors().list()[a];
    multiples.push_back(static_cast<double>(attractor.motion.multiple));
    moduli.push_back(attractor.multipliers.cwiseAbs().maxCoeff());
    const Vector state = search.state(attractor);
    states.insert(states.end(), state.begin(), state.end());
  }
  const std::size_t size = known > 0 ? states.size() / known : 0;
  result.fields.push_back(attractor_field("period_multiple", std::move(multiples), "1",
                                          "forcing periods after which the motion repeats itself"));
  result.fields.push_back(attractor_field("largest_multiplier", std::move(moduli), "1",
                                          "largest modulus of its multipliers"));
  result.fields.push_back({.label = {"attractors/state",
                                     "SI",
                                     "state of the motion at the forcing phase of time zero: "
                                     "coordinates, their rates, internal states of contacts",
                                     {"attractor", "state"}},
                           .shape = {known, size},
                           .values = std::move(states)});
}

} // namespace

/// The rows of a line with the system and the attractors that they share where they can.
class Basins::Rows {
public:
  Rows(const Settings &settings, LineContext &context)
      : settings_(settings), build_([&context](const std::vector<parameters::Override> &overrides) {
          return context.build(overrides);
        }) {}

  /// Moves to a row. InputError, NumericalError.
  void move_to(double value) {
    row_.emplace(basin_row(settings_.first, settings_.second, value, build_));
    const double size = std::max(row_->origin.cwiseAbs().maxCoeff(),
                                 (row_->slope * settings_.first.magnitude()).cwiseAbs().maxCoeff());
    if (search_ && same_motions(search_->system(), row_->system, size > 0 ? size : 1)) {
      search_->forget_after(known_);
      return;
    }
    search_ = std::make_unique<BasinSearch>(
        row_->system, sweep_source(row_->system, settings_.excitation, "An analysis of basins"),
        settings_.attractors);
    search_->search(coarse_part(size > 0 ? size : 1));
    known_ = search_->attractors().list().size();
  }
  const BasinRow &row() const { return *row_; }
  BasinSearch &search() { return *search_; }
  /// Attractors that the coarse part has found.
  std::size_t known() const { return known_; }

private:
  // Of the whole grid where the second axis is another initial condition, else of the row.
  std::vector<model::InitialState> coarse_part(double size) const {
    const std::vector<double> along = thinned(settings_.first.values, settings_.coarse);
    std::vector<model::InitialState> starts;
    for (const double value : thinned(settings_.second.values, settings_.coarse)) {
      const BasinRow other = basin_row(settings_.first, settings_.second, value, build_);
      if (same_motions(other.system, row_->system, size))
        add(starts, other, along);
    }
    if (starts.empty())
      add(starts, *row_, along);
    return starts;
  }

  const Settings &settings_;
  SystemSource build_;
  std::optional<BasinRow> row_;
  std::unique_ptr<BasinSearch> search_;
  std::size_t known_ = 0;
};

void Basins::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      section_name, "Which periodic motion each start of a grid of cells leads to.");
  declare_cell_axis(section, first_axis,
                    "An initial condition, by a key that changes nothing else.");
  declare_cell_axis(section, second_axis, "Another one, or any other key.");
  section
      .integer("Most periods", "2000", Range{.lower = 1, .upper = 1e9}, "",
               "Forcing periods after which a cell is left undecided.")
      .integer("Longest period", "16", Range{.lower = 1, .upper = 1000}, "",
               "Longest repetition of a motion that is looked for, in forcing periods.")
      .integer("Coarse cells", "20", Range{.lower = 1, .upper = 1000}, "",
               "Cells along each axis from which the periodic motions are found at first.")
      .text("Excitation", "",
            "Excitation whose period is that of the forcing; empty when there is only one with a "
            "period.");
}

std::shared_ptr<const Analysis> Basins::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(section_name);
  Settings settings{.first = read_cell_axis(values, first_axis),
                    .second = read_cell_axis(values, second_axis),
                    .attractors = {.most_periods = values.integer("Most periods"),
                                   .longest_multiple = values.integer("Longest period")},
                    .coarse = values.integer("Coarse cells"),
                    .excitation = values.text("Excitation")};
  if (settings.first.path == settings.second.path)
    values.subsection(second_axis).reject("Parameter", "another key than that of the first axis.");
  return std::make_shared<Basins>(std::move(settings));
}

std::size_t Basins::lines() const { return std::min(settings_.second.values.size(), most_lines); }

void Basins::check(const System &system) const {
  const std::size_t source = sweep_source(system, settings_.excitation, "An analysis of basins");
  const periodic::ForcedSystem forced(system.model, system.contacts, system.integration, source);
}

std::vector<std::vector<parameters::Override>> Basins::variants() const {
  std::vector<std::vector<parameters::Override>> overrides;
  for (const double value : settings_.second.values)
    overrides.push_back(
        {settings_.second.at(value), settings_.first.at(settings_.first.values[0])});
  return overrides;
}

void Basins::add_cells(PointResult &result, const std::vector<double> &cells,
                       const std::vector<double> &periods, std::size_t known) const {
  const std::string axis = settings_.first.axis_name();
  result.fields.push_back(series_field(axis, axis, settings_.first.values, settings_.first.unit,
                                       "centre of the cell, key " + settings_.first.path));
  result.fields.push_back(series_field(
      "cell/attractor", axis, cells, "1",
      "motion that the cell leads to, counted from 0 in the order of attractors/state; -1 undecided "
      "within the periods, -2 no motion, -3 a motion that Coarse cells have not met"));
  result.fields.push_back(series_field("cell/periods", axis, periods, "1",
                                       "forcing periods until the cell was decided"));
  const auto share = [&](double mark) {
    return static_cast<double>(std::count(cells.begin(), cells.end(), mark)) /
           static_cast<double>(cells.size());
  };
  std::vector<double> shares;
  for (std::size_t a = 0; a < known; ++a)
    shares.push_back(share(static_cast<double>(a)));
  result.fields.push_back(
      attractor_field("share", std::move(shares), "1", "of the cells of the row"));
  result.fields.push_back(
      scalar_field("undecided_share", share(undecided), "1", "of the cells of the row"));
  result.fields.push_back(scalar_field("no_motion_share", share(no_motion), "1",
                                       "of the cells of the row: no motion starts there, or it "
                                       "ends with a numerical failure"));
  result.fields.push_back(scalar_field("other_share", share(another), "1",
                                       "of the cells of the row: they lead to a motion that "
                                       "Coarse cells have not met"));
}

PointResult Basins::compute(std::size_t row, Rows &rows, LineContext &context) const {
  rows.move_to(settings_.second.values[row]);
  std::vector<double> cells, periods;
  for (const double value : settings_.first.values) {
    const Decision decision = rows.search().follow(rows.row().start(value));
    double mark = decision.outcome == Outcome::failed ? no_motion : undecided;
    if (decision.outcome == Outcome::decided)
      mark = decision.attractor < rows.known() ? static_cast<double>(decision.attractor) : another;
    cells.push_back(mark);
    periods.push_back(static_cast<double>(decision.periods));
    context.note_progress(static_cast<double>(cells.size()) /
                          static_cast<double>(settings_.first.values.size()));
  }
  PointResult result{.index = {row}};
  add_cells(result, cells, periods, rows.known());
  add_attractors(result, rows.search(), rows.known());
  return result;
}

// A line takes every n-th row. Motions found in one row do not count in the next, so that rows
// after a resumption are what they would have been.
void Basins::run_line(std::size_t line, System & /*system*/, LineContext &context) const {
  Rows rows(settings_, context);
  for (std::size_t row = line; row < settings_.second.values.size(); row += lines()) {
    if (context.find({row})) {
      context.skip();
      continue;
    }
    PointResult result;
    try {
      result = compute(row, rows, context);
    } catch (const NumericalError &error) {
      result = {.index = {row}, .status = Status::failed, .reason = error.what()};
    } catch (const InputError &error) {
      result = {.index = {row}, .status = Status::failed, .reason = error.what()};
    }
    context.store(std::move(result));
  }
}

} // namespace vibroimpact::analyses
