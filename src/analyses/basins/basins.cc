#include "analyses/basins/basins.h"

#include "analyses/basins/basin_fields.h"
#include "analyses/results/fields.h"
#include "common/error.h"
#include "common/scalar.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

using periodic::Decision;

namespace {

constexpr const char *basins_section = "Basins";
constexpr const char *first_axis = "First axis", *second_axis = "Second axis";
/// Rows are distributed over so many lines. Each rank searches the coarse part by itself, once.
constexpr std::size_t most_lines = 16;

void declare_cell_axis(parameters::Section &section, const std::string &name,
                       const std::string &description) {
  parameters::Section &axis = section.subsection(name, description);
  declare_key_range(axis, true);
  axis.integer("Cells", "200", parameters::Range{.lower = 1, .upper = 1e5}, "", "Number of cells.");
}

// The values are the centres of the cells between the ends.
SweptParameter read_cell_axis(const parameters::Values &section, const std::string &name) {
  const parameters::Values values = section.subsection(name);
  values.require("Parameter");
  SweptParameter axis = read_key_range(values, 2);
  const long cells = values.integer("Cells");
  const double first = axis.values.front();
  const double width = (axis.values.back() - first) / static_cast<double>(cells);
  axis.values.clear();
  for (long i = 0; i < cells; ++i)
    axis.values.push_back(first + (static_cast<double>(i) + 0.5) * width);
  return axis;
}

// Places of so many of a number of cells, as evenly as they come.
std::vector<std::size_t> thinned(std::size_t cells, long count) {
  const std::size_t wanted = std::min(cells, static_cast<std::size_t>(count));
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < wanted; ++i)
    places.push_back((2 * i + 1) * cells / (2 * wanted));
  return places;
}

} // namespace

/// The present row with the search that rows share where they can.
class Basins::Rows {
public:
  explicit Rows(const Settings &settings) : settings_(settings) {}

  /// Moves to a row, whose systems `context` builds. InputError, NumericalError.
  void move_to(std::size_t row, const LineContext &context) {
    context_ = &context;
    box_.emplace(box(row));
    if (search_ && same_motions(search_->system(), box_->system(), size())) {
      search_->forget_after(known_);
      return;
    }
    search_.reset(); // one that fails half-way must not serve the next row
    auto search = std::make_unique<BasinSearch>(box_->system(), settings_.search);
    const std::vector<model::InitialState> coarse = coarse_part();
    search->begin(coarse);
    for (const model::InitialState &start : coarse)
      search->follow(start);
    search->sort();
    if (!settings_.exactly)
      search->interpolate(settings_.nodes);
    search_ = std::move(search);
    known_ = search_->attractors().list().size();
    find_plane();
  }
  model::InitialState start(std::size_t cell) const { return start(*box_, cell); }
  BasinSearch &search() { return *search_; }
  Vector state(std::size_t attractor) const {
    return search_->state(search_->attractors().list()[attractor]);
  }
  /// Attractors that the coarse part has found.
  std::size_t known() const { return known_; }
  /// Both keys at which a motion would start like an attractor, in their units; NaN where the plane
  /// of the cells is not that of all states.
  Eigen::Vector2d place(const Vector &state) const {
    if (!whole_plane_)
      return {nan, nan};
    const Eigen::Vector2d shares = plane_.partialPivLu().solve(Eigen::Vector2d(state) - corner_);
    const auto value = [](const SweptParameter &key, double share) {
      return key.values.front() + share * (key.values.back() - key.values.front());
    };
    return {value(settings_.first, shares[0]), value(settings_.second, shares[1])};
  }

private:
  // The plane of states with the shares of both keys as coordinates.
  void find_plane() {
    whole_plane_ = false;
    const StartBox low = box(0), high = box(settings_.second.values.size() - 1);
    if (search_->states() != 2 || !same_motions(low.system(), high.system(), size()))
      return;
    const auto state = [](const model::InitialState &start) {
      return Eigen::Vector2d(start.displacement[0], start.velocity[0]);
    };
    corner_ = state(low.start(Vector::Zero(1)));
    plane_ << state(low.start(Vector::Ones(1))) - corner_,
        state(high.start(Vector::Zero(1))) - corner_;
    whole_plane_ = std::abs(plane_.determinant()) > 1e-12 * plane_.squaredNorm();
  }
  StartBox box(std::size_t row) const {
    return StartBox({settings_.first}, {settings_.second.at(settings_.second.values[row])},
                    [this](const std::vector<parameters::Override> &overrides) {
                      return context_->build(overrides);
                    });
  }
  double size() const { return box_->size() > 0 ? box_->size() : 1; }

  model::InitialState start(const StartBox &box, std::size_t cell) const {
    const std::size_t cells = settings_.first.values.size();
    const double share = cells > 1 ? static_cast<double>(cell) / static_cast<double>(cells - 1) : 0;
    return box.start(Vector::Constant(1, share));
  }

  // Of the whole grid where the second axis is another initial condition, else of the row.
  std::vector<model::InitialState> coarse_part() const {
    const auto cells = thinned(settings_.first.values.size(), settings_.coarse);
    std::vector<model::InitialState> starts;
    const auto add = [&](const StartBox &box) {
      for (const std::size_t cell : cells)
        starts.push_back(start(box, cell));
    };
    for (const std::size_t row : thinned(settings_.second.values.size(), settings_.coarse))
      if (const StartBox other = box(row); same_motions(other.system(), box_->system(), size()))
        add(other);
    if (starts.empty())
      add(*box_);
    return starts;
  }

  const Settings &settings_;
  const LineContext *context_ = nullptr; ///< of the present row
  std::optional<StartBox> box_;
  std::unique_ptr<BasinSearch> search_;
  std::size_t known_ = 0;
  bool whole_plane_ = false;
  Eigen::Vector2d corner_;
  Eigen::Matrix2d plane_;
};

void Basins::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      basins_section, "Which periodic motion each start of a grid of cells leads to.");
  declare_cell_axis(section, first_axis,
                    "An initial condition, by a key that changes nothing else.");
  declare_cell_axis(section, second_axis, "Another one, or any other key.");
  declare_basin_search(section);
  section
      .integer("Coarse cells", "20", Range{.lower = 1, .upper = 1000}, "",
               "Cells along each axis from which the periodic motions are found at first.")
      .choice("Method", "motions", {"motions", "interpolation"},
              "Follow the motions themselves, or, in models of one coordinate, a map that is "
              "interpolated between nodes: faster, with a share of wrong cells that is measured.")
      .integer("Nodes", "400", Range{.lower = 4, .upper = 1e4}, "",
               "Nodes along displacement and velocity, over 1.35 times the region of the cells.")
      .integer("Check every", "100", Range{.lower = 1, .upper = 1e9}, "",
               "One of so many interpolated cells is followed by the motion too.");
}

std::shared_ptr<const Analysis> Basins::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(basins_section);
  Settings settings{.first = read_cell_axis(values, first_axis),
                    .second = read_cell_axis(values, second_axis),
                    .search = read_basin_search(values),
                    .coarse = values.integer("Coarse cells"),
                    .exactly = values.choice("Method") == "motions",
                    .nodes = values.integer("Nodes"),
                    .checked_every = values.integer("Check every")};
  if (settings.first.path == settings.second.path)
    values.subsection(second_axis)
        .reject("Parameter", "must be another key than that of First axis");
  for (const char *key : {"Nodes", "Check every"})
    if (settings.exactly && values.given(key))
      values.reject(key, "must not be set when Method = motions");
  return std::make_shared<Basins>(std::move(settings));
}

// The nodes of an interpolation are for all rows.
std::size_t Basins::lines() const {
  return settings_.exactly ? std::min(settings_.second.values.size(), most_lines) : 1;
}

void Basins::check(const System &system) const {
  const BasinSearch search(system, settings_.search);
  if (!settings_.exactly && search.states() != 2)
    throw InputError("Method must be motions for a system of more than one coordinate or with "
                     "internal states of contacts; this one has " +
                     std::to_string(search.states()) + " states.");
}

void Basins::check_built(const SystemSource &build) const {
  const StartBox box({settings_.first}, {settings_.second.at(settings_.second.values[0])}, build);
}

std::vector<std::vector<parameters::Override>> Basins::variants() const {
  std::vector<std::vector<parameters::Override>> overrides;
  for (const double value : settings_.second.values)
    overrides.push_back(
        {settings_.second.at(value), settings_.first.at(settings_.first.values[0])});
  return overrides;
}

void Basins::add_cells(const FieldWriter &result, std::vector<double> marks,
                       std::vector<double> periods) const {
  const std::string axis = settings_.first.axis_name();
  result.series(axis, axis, settings_.first.values, settings_.first.unit,
                "centre of the cell, key " + settings_.first.path);
  result.series(
      "cell/attractor", axis, std::move(marks), "1",
      "motion that the cell leads to, counted from 0 in the order of attractors/state; -1 not "
      "caught within the periods, -2 no motion, -3 a motion that Coarse cells have not found");
  result.series("cell/periods", axis, std::move(periods), "1",
                "forcing periods until the cell was decided");
}

void Basins::add_places(const FieldWriter &result, const Rows &rows) const {
  std::vector<double> first, second;
  for (std::size_t a = 0; a < rows.known(); ++a) {
    const Eigen::Vector2d place = rows.place(rows.state(a));
    first.push_back(place[0]);
    second.push_back(place[1]);
  }
  const std::string description =
      "key at which a motion would start like it; NaN where the cells are not all states";
  result.series("attractors/first_axis", "attractor", std::move(first), settings_.first.unit,
                description);
  result.series("attractors/second_axis", "attractor", std::move(second), settings_.second.unit,
                description);
}

PointResult Basins::compute(std::size_t row, Rows &rows, LineContext &context) const {
  rows.move_to(row, context);
  BasinSearch &search = rows.search();
  const std::size_t cells = settings_.first.values.size();
  std::vector<double> marks, periods;
  double checked = 0, wrong = 0;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const model::InitialState start = rows.start(cell);
    const Decision decision = settings_.exactly ? search.follow(start) : search.approximate(start);
    marks.push_back(mark_of(decision, rows.known()));
    periods.push_back(static_cast<double>(decision.periods));
    if (!settings_.exactly &&
        (row * cells + cell) % static_cast<std::size_t>(settings_.checked_every) == 0) {
      ++checked;
      wrong += marks.back() != mark_of(search.follow(start), rows.known()) ? 1 : 0;
    }
    context.note_progress(static_cast<double>(cell + 1) / static_cast<double>(cells));
  }
  PointResult point{.index = {row}};
  const FieldWriter result(point);
  add_shares(result, marks, rows.known(), "the cells of the row");
  result.number(
      "other_share",
      static_cast<double>(std::count(marks.begin(), marks.end(), another)) /
          static_cast<double>(cells),
      "1", "share of the cells of the row that lead to a motion that Coarse cells have not met");
  if (!settings_.exactly) {
    result.number("checked_cells", checked, "1",
                  "interpolated cells that were followed by the motion too");
    result.number("wrong_cells", wrong, "1", "of these, those that lead elsewhere");
  }
  add_cells(result, std::move(marks), std::move(periods));
  add_attractors(result, search, rows.known());
  add_places(result, rows);
  return point;
}

// A line takes every n-th row. Motions found in one row do not count in the next, so that rows
// after a resumption, or after other lines of a rank, are what they would have been.
void Basins::run_line(std::size_t line, System & /*system*/, LineContext &context) const {
  if (!rows_)
    rows_ = std::make_shared<Rows>(settings_);
  for (std::size_t row = line; row < settings_.second.values.size(); row += lines()) {
    if (context.find({row})) {
      context.skip();
      continue;
    }
    PointResult result;
    try {
      result = compute(row, *rows_, context);
    } catch (const NumericalError &error) {
      result = {.index = {row}, .status = Status::failed, .reason = error.what()};
    } catch (const InputError &error) {
      result = {.index = {row}, .status = Status::failed, .reason = error.what()};
    }
    context.store(std::move(result));
  }
}

} // namespace vibroimpact::analyses
