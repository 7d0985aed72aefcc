#include "analyses/curves/orbit_branch.h"

#include "analyses/curves/branch_table.h"
#include "analyses/curves/orbit_rows.h"
#include "analyses/keys/keyed_system.h"
#include "analyses/recorders/window_recording.h"
#include "common/error.h"
#include "continuation/stored_steps.h"

#include <memory>

namespace vibroimpact::analyses {

using periodic::OrbitProblem;

namespace {

constexpr const char *orbit_branch_section = "Branch";

} // namespace

void OrbitBranch::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      orbit_branch_section,
      "Periodic motions, stable and unstable, along a key, from the one that the file "
      "describes: where they turn, double their period or lose their symmetry.");
  declare_branch_keys(section);
  section.integer(
      "Switching levels", "0", Range{.lower = 0, .upper = 20}, "",
      "Branches that begin at a period doubling or loss of symmetry are followed as well: "
      "those of the first branch with 1, those of these too with 2...");
  declare_orbit_start(section);
  section.text("Excitation", "",
               "Excitation whose period is that of the forcing, or whose frequency is the key; "
               "empty when there is only one with a period.");
}

std::shared_ptr<const Analysis> OrbitBranch::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(orbit_branch_section);
  const SweptParameter parameter = read_key_range(values);
  Settings settings{.parameter = parameter,
                    .start_value = read_start(parameter, values),
                    .start = read_orbit_start(values),
                    .directions = read_direction(values),
                    .continuation = read_continuation(values, parameter),
                    .levels = values.integer("Switching levels"),
                    .excitation = values.text("Excitation"),
                    .recorders = read_recorders(analysis, {"extreme values", "impacts"})};
  return std::make_shared<OrbitBranch>(std::move(settings));
}

void OrbitBranch::check(const System &system) const {
  check_start(settings_.parameter, settings_.start_value, system, settings_.excitation, "A branch");
  const auto source = period_source(system, settings_.excitation, "A branch");
  OrbitSearch search(system, source, settings_.start);
  search.forced().trajectory().start(0, system.initial.displacement, system.initial.velocity);
  const WindowRecording recording(settings_.recorders, system);
}

std::vector<std::vector<parameters::Override>> OrbitBranch::variants() const {
  return end_variants(settings_.parameter);
}

PointResult OrbitBranch::compute(System &system, LineContext &context) const {
  const double value = start_value(settings_.parameter, settings_.start_value, system,
                                   settings_.excitation, "A branch");
  OrbitSearch search(system, period_source(system, settings_.excitation, "A branch"),
                     settings_.start);
  const std::unique_ptr<StepRecord> steps = context.steps({});
  const periodic::Orbit orbit =
      search.run([&](long /*periods*/) { context.note_progress(0); }, steps.get());
  const double range = settings_.parameter.values.back() - settings_.parameter.values.front();
  const Vector sizes = problem_sizes(search.map(), orbit, Vector::Constant(1, range));
  KeyedMap maps({settings_.parameter}, settings_.excitation, system, context,
                orbit_accuracy(system, search.forced()), search.map().norm(orbit.point.state),
                search.free_period());
  const long halves = maps.symmetric() ? orbit.section.halves : 2 * orbit.multiple();
  const auto problem = std::make_shared<OrbitProblem>(maps, halves, sizes);
  const OrbitRows rows(maps, settings_.recorders);
  BranchTable table(key_label(settings_.parameter),
                    [&rows](const continuation::BranchPoint &point, long over) {
                      return rows.of(point.point.keys, {.phase = point.point.chart, .halves = over},
                                     point.point.state);
                    });
  BranchFollower follower(
      {settings_.directions, settings_.continuation, settings_.levels}, table,
      [&](double share) { context.note_progress(share); }, steps.get());
  const continuation::Point guess{
      .state = orbit.point.state, .keys = Vector::Constant(1, value), .chart = orbit.section.phase};
  follower.run(problem, halves, recorded(steps.get(), "start", [&] {
                 return continuation::solve(*problem, guess, settings_.continuation);
               }));
  PointResult result;
  table.add_fields(result);
  if (table.stuck())
    result.reason += rigid_body_cause(system);
  return result;
}

void OrbitBranch::run_line(std::size_t /*line*/, System &system, LineContext &context) const {
  run_orbit_point(system, context, [&] { return compute(system, context); });
}

} // namespace vibroimpact::analyses
