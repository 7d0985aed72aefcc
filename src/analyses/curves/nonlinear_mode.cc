#include "analyses/curves/nonlinear_mode.h"

#include "analyses/curves/branch_table.h"
#include "analyses/curves/frequency_folds.h"
#include "analyses/curves/mode_family.h"
#include "analyses/keys/branch_keys.h"
#include "analyses/recorders/window_recording.h"
#include "analyses/run/single_point.h"
#include "common/error.h"
#include "continuation/stored_steps.h"

#include <utility>

namespace vibroimpact::analyses {

using continuation::BranchPoint;
using periodic::EnergyOrbits;
using periodic::Losses;

namespace {

constexpr const char *nonlinear_mode_section = "Nonlinear mode";

/// Adds where the frequency turns.
class ModeTable : public BranchTable {
public:
  ModeTable(ModeFamily &family, const continuation::Settings &settings)
      : BranchTable(
            {"energy", "J", "kinetic and stored energy above that at rest"},
            [&family](const BranchPoint &point, long halves) { return family.row(point, halves); }),
        family_(family), folds_(settings) {}

  void begin(long number, long halves, double sign) override {
    BranchTable::begin(number, halves, sign);
    halves_ = halves;
    folds_.begin();
  }
  using BranchTable::add;
  void add(const BranchPoint &point) override {
    BranchTable::add(point);
    if (const auto fold = folds_.next(family_.recorded(halves_), point))
      add_frequency_fold(*fold);
  }

private:
  ModeFamily &family_;
  FrequencyFolds folds_;
  long halves_ = 2;
};

} // namespace

void NonlinearMode::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      nonlinear_mode_section,
      "Periodic motions without excitation, from a linear mode on, by their energy.");
  section
      .integer("Mode", "1", Range{.lower = 1, .upper = 1e6}, "",
               "Linear mode at which it begins: of the whole system with open contacts, "
               "rigid-body modes included, by rising frequency.")
      .choice("Damping", "left out", {"left out", "balanced"},
              "Left out: motions of the undamped system; contacts must not take energy. Balanced: "
              "a force that pushes each mass along its velocity makes good what damping and "
              "contacts take in a period, so that the motion is that at phase resonance.")
      .quantity("First energy", "", dimension::torque, range::positive, "E_1",
                "Kinetic and stored energy, above that at rest, with which it begins: small "
                "enough that no contact is reached which is open at rest.")
      .required()
      .quantity("Last energy", "", dimension::torque, range::positive, "E_2", "With which it ends.")
      .required();
  declare_steps(section, "branch", "0.03"); // longer ones pass narrow resonances by
  section.integer("Switching levels", "0", Range{.lower = 0, .upper = 20}, "",
                  "Branches that begin at a period doubling or loss of symmetry are followed as "
                  "well: those of the mode with 1, those of these too with 2...");
}

std::shared_ptr<const Analysis> NonlinearMode::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(nonlinear_mode_section);
  values.require("First energy");
  values.require("Last energy");
  Settings settings{.start = {.mode = values.integer("Mode"),
                              .energy = values.quantity("First energy"),
                              .last_energy = values.quantity("Last energy"),
                              .section = values},
                    .losses =
                        values.choice("Damping") == "balanced" ? Losses::balanced : Losses::none,
                    .continuation = read_steps(values),
                    .levels = values.integer("Switching levels"),
                    .recorders = read_recorders(analysis, {"extreme values", "impacts"})};
  if (!(settings.start.last_energy > settings.start.energy))
    values.reject("Last energy", "must be greater than First energy");
  settings.continuation.first_key = {.lower = settings.start.energy,
                                     .upper = settings.start.last_energy};
  return std::make_shared<NonlinearMode>(std::move(settings));
}

void NonlinearMode::check(const System &system) const {
  const ModeFamily family(system, settings_.start, settings_.losses, settings_.recorders);
  const WindowRecording recording(settings_.recorders, system);
}

PointResult NonlinearMode::compute(const System &system, LineContext &context) const {
  ModeFamily family(system, settings_.start, settings_.losses, settings_.recorders);
  const std::shared_ptr<EnergyOrbits> problem = family.problem(family.halves());
  ModeTable table(family, settings_.continuation);
  const std::unique_ptr<StepRecord> steps = context.steps({});
  BranchFollower follower(
      {Directions::forward, settings_.continuation, settings_.levels}, table,
      [&](double share) { context.note_progress(share); }, steps.get());
  const auto [first, remembered] = recorded(steps.get(), "start", [&] {
    BranchPoint point = continuation::solve(*problem, family.start(), settings_.continuation);
    return std::pair(std::move(point), problem->remembered());
  });
  problem->remember(remembered);
  follower.run(problem, family.halves(), first);
  PointResult result;
  table.add_fields(result);
  return result;
}

void NonlinearMode::run_line(std::size_t /*line*/, System &system, LineContext &context) const {
  run_single_point(context, [&] { return compute(system, context); });
}

} // namespace vibroimpact::analyses
