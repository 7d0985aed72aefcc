#include "analyses/basins/basin_shares.h"

#include "analyses/basins/basin_fields.h"
#include "analyses/results/fields.h"
#include "analyses/run/single_point.h"
#include "common/error.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace vibroimpact::analyses {

namespace {

constexpr const char *basin_shares_section = "Basin shares";
constexpr const char *kind = "Range";

} // namespace

void BasinShares::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      basin_shares_section, "How many of random starts in a box lead to which periodic motion.");
  declare_key_range(
      section.named_subsection(
          kind, "An initial condition of the box, by a key that changes nothing else."),
      true);
  section
      .integer("Starts", "1000", Range{.lower = 1, .upper = 1e9}, "N",
               "Number of starts, uniformly distributed between the ends of all ranges.")
      .integer("Seed", "1", Range{.lower = 0, .upper = 1e9}, "",
               "Of the random numbers: the same one gives the same starts.");
  declare_basin_search(section);
}

std::shared_ptr<const Analysis> BasinShares::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(basin_shares_section);
  Settings settings{.keys = {},
                    .starts = values.integer("Starts"),
                    .seed = values.integer("Seed"),
                    .search = read_basin_search(values)};
  for (const std::string &name : values.instances(kind)) {
    const parameters::Values range = values.instance(kind, name);
    range.require("Parameter");
    settings.keys.push_back(read_key_range(range, 2));
    for (std::size_t k = 0; k + 1 < settings.keys.size(); ++k)
      if (settings.keys[k].path == settings.keys.back().path)
        range.reject("Parameter", "must be another key than that of the other sections Range");
  }
  if (settings.keys.empty())
    values.reject_section("at least one subsection Range NAME must be given");
  return std::make_shared<BasinShares>(std::move(settings));
}

void BasinShares::check(const System &system) const {
  const BasinSearch search(system, settings_.search);
}

void BasinShares::check_built(const SystemSource &build) const {
  const StartBox box(settings_.keys, {}, build);
}

std::vector<model::InitialState> BasinShares::draw(const StartBox &box) const {
  std::mt19937_64 random(static_cast<std::uint64_t>(settings_.seed));
  std::vector<model::InitialState> starts;
  Vector shares(static_cast<Index>(settings_.keys.size()));
  for (long i = 0; i < settings_.starts; ++i) {
    for (double &share : shares)
      share = static_cast<double>(random() >> 11) * 0x1p-53;
    starts.push_back(box.start(shares));
  }
  return starts;
}

PointResult BasinShares::compute(LineContext &context) const {
  const StartBox box(settings_.keys, {}, [&](const std::vector<parameters::Override> &overrides) {
    return context.build(overrides);
  });
  BasinSearch search(box.system(), settings_.search);
  const std::vector<model::InitialState> starts = draw(box);
  search.begin(starts);
  std::vector<double> marks;
  for (const model::InitialState &start : starts) {
    const periodic::Decision decision = search.follow(start);
    marks.push_back(mark_of(decision, search.attractors().list().size()));
    context.note_progress(static_cast<double>(marks.size()) / static_cast<double>(starts.size()));
  }
  const std::vector<std::size_t> places = search.sort();
  for (double &mark : marks)
    if (mark >= 0)
      mark = static_cast<double>(places[static_cast<std::size_t>(mark)]);
  PointResult point;
  const FieldWriter result(point);
  add_shares(result, marks, places.size(), "the starts");
  std::vector<double> errors;
  for (std::size_t a = 0; a < places.size(); ++a) {
    const double share =
        static_cast<double>(std::count(marks.begin(), marks.end(), static_cast<double>(a))) /
        static_cast<double>(marks.size());
    errors.push_back(std::sqrt(share * (1 - share) / static_cast<double>(marks.size())));
    result.line("attractors/share[" + std::to_string(a + 1) + "]", share, "1");
  }
  result.series("attractors/share_error", "attractor", std::move(errors), "1",
                "standard error of the share");
  add_attractors(result, search, places.size());
  return point;
}

void BasinShares::run_line(std::size_t /*line*/, System & /*system*/, LineContext &context) const {
  run_single_point(context, [&] { return compute(context); });
}

} // namespace vibroimpact::analyses
