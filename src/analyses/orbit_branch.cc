#include "analyses/orbit_branch.h"

#include "analyses/branch_table.h"
#include "analyses/single_point.h"
#include "analyses/swept_system.h"
#include "common/error.h"

#include <algorithm>
#include <cmath>
#include <list>
#include <memory>
#include <numbers>

namespace vibroimpact::analyses {

using continuation::Branch;
using continuation::BranchPoint;
using continuation::SpecialPoint;
using continuation::Start;
using periodic::OrbitProblem;

namespace {

constexpr const char *section_name = "Branch";

/// A branch that is still to be followed.
struct Task {
  std::shared_ptr<OrbitProblem> problem;
  Start start;
  long number = 0, level = 0;
  double sign = 1;
  double key = 0; ///< of the special point where it begins
};

/// Follows one branch after the other.
class Follower {
public:
  Follower(const OrbitBranch::Settings &settings, BranchTable &table, LineContext &context)
      : settings_(settings), table_(table), context_(context) {}

  void start(const std::shared_ptr<OrbitProblem> &problem, const BranchPoint &first) {
    if (settings_.directions != Directions::backward)
      tasks_.push_back({.problem = problem, .start = {.point = first.point, .direction = {}}});
    if (settings_.directions != Directions::forward)
      tasks_.push_back({.problem = problem,
                        .start = {.point = first.point, .direction = {}, .forward = false},
                        .sign = -1});
  }

  void run() {
    bool closed = false;
    for (; !tasks_.empty() && tasks_.front().level == 0; tasks_.pop_front())
      if (!closed)
        closed = follow(tasks_.front()) == continuation::End::closed;
    for (; !tasks_.empty(); tasks_.pop_front())
      enter(tasks_.front());
  }

private:
  // A branch whose first point is not found is left out with its reason.
  void enter(Task &task) {
    task.number = branches_ + 1;
    try {
      follow(task);
      ++branches_;
    } catch (const NumericalError &error) {
      table_.drop(task.number);
      table_.note_missing(task.key, error.what());
    }
  }

  continuation::End follow(const Task &task) {
    table_.begin(task.number, task.problem->halves(), task.sign);
    bool first = task.sign > 0 || settings_.directions == Directions::backward;
    const Branch branch = continuation::follow(
        *task.problem, task.start, settings_.continuation,
        {.point =
             [&](const BranchPoint &point) {
               note(task, point.point.keys[0]);
               if (first)
                 table_.add(point);
               first = true; // the start of the second direction is there already
             },
         .special = [&](const SpecialPoint &special) { table_.add(special); }});
    table_.end(branch);
    ++finished_;
    reached_ = 0;
    if (branch.end == continuation::End::shorter_return)
      forget(task, branch.points.back().point.keys[0]);
    if (task.level < settings_.levels)
      for (const SpecialPoint &special : branch.special)
        switch_at(task, special);
    return branch.end;
  }

  // A branch that begins at one special point and ends at another need not be followed from there.
  void forget(const Task &done, double key) {
    constexpr double same = 1e-6; // of the range; where a branch ends the key turns
    const continuation::Range &range = settings_.continuation.first_key;
    std::erase_if(tasks_, [&](const Task &task) {
      return &task != &done && task.level > 0 && task.level == done.level &&
             std::abs(task.key - key) < same * (range.upper - range.lower);
    });
  }

  // A branch that cannot be entered is left out with its reason; the special point stays.
  void switch_at(const Task &task, const SpecialPoint &special) {
    if (special.kind != continuation::Special::flip)
      return;
    const auto doubled = std::make_shared<OrbitProblem>(task.problem->doubled_orbits());
    try {
      const Start start = branch_from(*doubled, special, settings_.continuation);
      tasks_.push_back({.problem = doubled,
                        .start = start,
                        .level = task.level + 1,
                        .key = special.at.point.keys[0]});
    } catch (const NumericalError &error) {
      table_.note_missing(special.at.point.keys[0], error.what());
    }
  }

  // How far a branch has come from its start to the end of the key ahead; folds are not known
  // beforehand.
  void note(const Task &task, double key) {
    const continuation::Range &range = settings_.continuation.first_key;
    const double from = task.start.point.keys[0];
    const double ahead = key > from ? range.upper - from : from - range.lower;
    if (ahead > 0)
      reached_ = std::max(reached_, std::min(1.0, std::abs(key - from) / ahead));
    share_ =
        std::max(share_, (finished_ + reached_) / (finished_ + static_cast<double>(tasks_.size())));
    context_.note_progress(share_);
  }

  const OrbitBranch::Settings &settings_;
  BranchTable &table_;
  LineContext &context_;
  std::list<Task> tasks_;
  long branches_ = 0;
  double finished_ = 0, reached_ = 0, share_ = 0; ///< parts of branches, for the progress
};

} // namespace

void OrbitBranch::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      section_name,
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
  const parameters::Values values = analysis.subsection(section_name);
  const SweptParameter parameter = read_key_range(values);
  Settings settings{.parameter = parameter,
                    .start_value = read_start(parameter, values),
                    .start = read_orbit_start(values),
                    .directions = read_direction(values),
                    .continuation = read_continuation(values, parameter),
                    .levels = values.integer("Switching levels"),
                    .excitation = values.text("Excitation"),
                    .recorders = read_recorders(analysis, {"excursions", "impacts"})};
  return std::make_shared<OrbitBranch>(std::move(settings));
}

void OrbitBranch::check(const System &system) const {
  check_start(settings_.parameter, settings_.start_value, system, settings_.excitation, "A branch");
  const std::size_t source = sweep_source(system, settings_.excitation, "A branch");
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
  OrbitSearch search(system, sweep_source(system, settings_.excitation, "A branch"),
                     settings_.start);
  const periodic::Orbit orbit = search.run([&](long /*periods*/) { context.note_progress(0); });
  const double range = settings_.parameter.values.back() - settings_.parameter.values.front();
  const Vector sizes = problem_sizes(search.map(), orbit, range);
  KeyedMap maps(settings_.parameter, settings_.excitation, system, context,
                orbit_accuracy(system, search.forced()), search.map().norm(orbit.point.state));
  const long halves = maps.symmetric() ? orbit.section.halves : 2 * orbit.multiple();
  const auto problem = std::make_shared<OrbitProblem>(maps, halves, sizes);
  BranchTable table(settings_.parameter, maps, settings_.recorders);
  Follower follower(settings_, table, context);
  follower.start(problem, continuation::solve(*problem,
                                              {.state = orbit.point.state,
                                               .keys = Vector::Constant(1, value),
                                               .chart = orbit.section.phase},
                                              settings_.continuation));
  follower.run();
  PointResult result;
  table.add_fields(result);
  return result;
}

void OrbitBranch::run_line(std::size_t /*line*/, System &system, LineContext &context) const {
  run_single_point(context, [&] { return compute(system, context); });
}

} // namespace vibroimpact::analyses
