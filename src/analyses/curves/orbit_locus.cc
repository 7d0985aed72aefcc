#include "analyses/curves/orbit_locus.h"

#include "analyses/keys/keyed_system.h"
#include "analyses/recorders/window_recording.h"
#include "common/error.h"
#include "continuation/stored_steps.h"
#include "parameters/text.h"

#include <algorithm>

namespace vibroimpact::analyses {

using periodic::OrbitProblem;

namespace {

constexpr const char *orbit_locus_section = "Locus";
constexpr const char *key_sections[] = {"First key", "Second key"};
constexpr const char *locus_subject = "A locus";

// In the order of LocusOf.
const std::vector<std::string> &locus_kind_names() {
  static const std::vector<std::string> names = {"fold", "period doubling", "loss of symmetry",
                                                 "Neimark-Sacker", "graze"};
  return names;
}

std::vector<LocusOf> read_kinds(const parameters::Values &values) {
  std::vector<LocusOf> kinds;
  if (values.names("Kinds").empty())
    values.reject("Kinds",
                  "must name at least one of " + parameters::join(locus_kind_names(), ", ") + ".");
  for (const std::string &name : values.names("Kinds")) {
    values.require_known("Kinds", name, locus_kind_names());
    const auto place = std::find(locus_kind_names().begin(), locus_kind_names().end(), name);
    kinds.push_back(static_cast<LocusOf>(place - locus_kind_names().begin()));
  }
  return kinds;
}

// At the corners of the plane; a frequency needs no other system.
std::vector<std::vector<parameters::Override>>
key_corners(const std::vector<SweptParameter> &keys) {
  std::vector<std::vector<parameters::Override>> key_corners{{}};
  for (const SweptParameter &key : keys) {
    if (key.is_frequency())
      continue;
    std::vector<std::vector<parameters::Override>> more;
    for (const std::vector<parameters::Override> &corner : key_corners)
      for (const double end : {key.values.front(), key.values.back()}) {
        more.push_back(corner);
        more.back().push_back(key.at(end));
      }
    key_corners = std::move(more);
  }
  return key_corners;
}

} // namespace

void OrbitLocus::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      orbit_locus_section,
      "Special points of periodic motions followed in the plane of two keys: where a "
      "fold, a period "
      "doubling or the first touch of a contact goes when a second key changes.");
  section.names("Kinds", "fold",
                "Which special points are followed: fold, period doubling, loss of symmetry, "
                "Neimark-Sacker, graze. They are located on the branch along the first key, "
                "at the value that the file gives to the second one.");
  declare_key_range(section.subsection(
      key_sections[0], "Key along which the branch is followed that has the special points."));
  declare_key_range(section.subsection(key_sections[1], "The other key."));
  declare_steps(section, "branch or locus");
  section.integer("Switching levels", "0", Range{.lower = 0, .upper = 20}, "",
                  "Special points of branches that begin at a period doubling or loss of symmetry "
                  "count as well: those of branches that begin at the first one with 1, those of "
                  "branches that begin at these too with 2...");
  declare_orbit_start(section);
  section.text("Excitation", "",
               "Excitation whose period is that of the forcing, or whose frequency is a key; "
               "empty when there is only one with a period.");
}

std::shared_ptr<const Analysis> OrbitLocus::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(orbit_locus_section);
  Settings settings{.keys = {},
                    .start_values = {},
                    .kinds = read_kinds(values),
                    .start = read_orbit_start(values),
                    .continuation = read_steps(values),
                    .levels = values.integer("Switching levels"),
                    .excitation = values.text("Excitation"),
                    .recorders = read_recorders(analysis, {"extreme values", "impacts"})};
  for (const char *name : key_sections) {
    const parameters::Values key = values.subsection(name);
    settings.keys.push_back(read_key_range(key));
    settings.start_values.push_back(read_start(settings.keys.back(), key));
  }
  const parameters::Values second = values.subsection(key_sections[1]);
  if (settings.keys[0].path == settings.keys[1].path ||
      (!settings.keys[0].is_frequency() && !settings.keys[1].is_frequency() &&
       values.subsection(key_sections[0]).key_path("Parameter") == second.key_path("Parameter")))
    second.reject("Parameter", "must be another key than that of First key");
  settings.continuation.first_key = range_of(settings.keys[0]);
  settings.continuation.second_key = range_of(settings.keys[1]);
  return std::make_shared<OrbitLocus>(std::move(settings));
}

Vector OrbitLocus::start_values(const System &system) const {
  Vector values(2);
  for (std::size_t k = 0; k < 2; ++k)
    values[static_cast<Index>(k)] = start_value(settings_.keys[k], settings_.start_values[k],
                                                system, settings_.excitation, locus_subject);
  return values;
}

void OrbitLocus::check(const System &system) const {
  for (std::size_t k = 0; k < 2; ++k)
    check_start(settings_.keys[k], settings_.start_values[k], system, settings_.excitation,
                locus_subject);
  OrbitSearch search(system, period_source(system, settings_.excitation, locus_subject),
                     settings_.start);
  search.forced().trajectory().start(0, system.initial.displacement, system.initial.velocity);
  const WindowRecording recording(settings_.recorders, system);
}

std::vector<std::vector<parameters::Override>> OrbitLocus::variants() const {
  return key_corners(settings_.keys);
}

OrbitLocus::Motion OrbitLocus::first_motion(System &system, LineContext &context,
                                            StepRecord *steps) const {
  OrbitSearch search(system, period_source(system, settings_.excitation, locus_subject),
                     settings_.start);
  Motion motion{.orbit = search.run([&](long /*periods*/) { context.note_progress(0); }, steps)};
  Vector ranges(2);
  for (std::size_t k = 0; k < 2; ++k)
    ranges[static_cast<Index>(k)] =
        settings_.keys[k].values.back() - settings_.keys[k].values.front();
  motion.sizes = problem_sizes(search.map(), motion.orbit, ranges);
  motion.accuracy = orbit_accuracy(system, search.forced());
  motion.size = search.map().norm(motion.orbit.point.state);
  motion.period = search.free_period();
  return motion;
}

KeyedMap OrbitLocus::maps(std::vector<SweptParameter> keys, const Motion &motion, System &system,
                          LineContext &context) const {
  return {std::move(keys), settings_.excitation, system,       context,
          motion.accuracy, motion.size,          motion.period};
}

// At the second key's value in the file.
std::vector<LocusOrigin> OrbitLocus::find_origins(const Motion &motion, double first,
                                                  bool symmetric, System &system,
                                                  LineContext &context, StepRecord *steps) const {
  KeyedMap along = maps({settings_.keys[0]}, motion, system, context);
  const bool half = symmetric && along.symmetric();
  const auto problem = std::make_shared<OrbitProblem>(
      along, half ? motion.orbit.section.halves : 2 * motion.orbit.multiple(),
      Vector(motion.sizes.head(motion.sizes.size() - 1)));
  LocusOrigins origins(settings_.kinds);
  BranchFollower branch(
      {Directions::both, settings_.continuation, settings_.levels}, origins,
      [&](double share) { context.note_progress(share / 10); }, steps);
  const continuation::Point guess{.state = motion.orbit.point.state,
                                  .keys = Vector::Constant(1, first),
                                  .chart = motion.orbit.section.phase};
  branch.run(problem, problem->halves(), recorded(steps, "start", [&] {
               return continuation::solve(*problem, guess, settings_.continuation);
             }));
  return origins.in_order();
}

PointResult OrbitLocus::compute(System &system, LineContext &context) const {
  const Vector values = start_values(system);
  const std::unique_ptr<StepRecord> steps = context.steps({});
  const Motion motion = first_motion(system, context, steps.get());
  KeyedMap plane = maps(settings_.keys, motion, system, context);
  const std::vector<LocusOrigin> origins =
      find_origins(motion, values[0], plane.symmetric(), system, context, steps.get());
  if (origins.empty())
    throw NumericalError("the branch along the first key has no special point of the kinds that "
                         "are wanted");
  LocusTable table(settings_.keys, plane, settings_.recorders);
  const auto note = [&](double share) { context.note_progress(0.1 + 0.9 * share); };
  LocusFollower follower(plane, motion.sizes, values[1], settings_.continuation, table,
                         origins.size(), note, steps.get());
  for (const LocusOrigin &origin : origins)
    follower.follow(origin);
  PointResult result;
  table.add_fields(result);
  return result;
}

void OrbitLocus::run_line(std::size_t /*line*/, System &system, LineContext &context) const {
  run_orbit_point(system, context, [&] { return compute(system, context); });
}

} // namespace vibroimpact::analyses
