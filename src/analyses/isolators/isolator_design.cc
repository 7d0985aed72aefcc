#include "analyses/isolators/isolator_design.h"

#include "analyses/design/design_keys.h"
#include "analyses/isolators/isolator_results.h"
#include "analyses/run/single_point.h"
#include "common/error.h"

#include <cmath>

namespace vibroimpact::analyses {

using parameters::Values;

namespace {

constexpr const char *isolator_design_section = "Isolator design";
constexpr const char *first_key = "First unfolding parameters";
constexpr const char *second_key = "Second unfolding parameters";

std::vector<UnfoldingParameters> read_listed(const Values &section) {
  const std::vector<double> first = section.quantities(first_key);
  const std::vector<double> second = section.quantities(second_key);
  if (first.size() != second.size())
    section.reject(second_key, "must have " + std::to_string(first.size()) +
                                   " values, as many as " + std::string(first_key));
  std::vector<UnfoldingParameters> listed;
  for (std::size_t i = 0; i < first.size(); ++i)
    listed.push_back({.first = first[i], .second = second[i]});
  return listed;
}

std::vector<StopToJudge> stops_to_judge(const IsolatorDesign::Settings &settings,
                                        const StopConditions &conditions,
                                        const StopCorners &corners) {
  std::vector<StopToJudge> stops = {{StopKind::resonance_and_jump, corners.resonance_and_jump},
                                    {StopKind::linear_and_resonance, corners.linear_and_resonance},
                                    {StopKind::linear_and_jump, corners.linear_and_jump}};
  const auto add = [&](StopKind kind, const UnfoldingParameters &at) {
    stops.push_back({kind, stop_of(at, conditions.damping, conditions.unfolding_ratio)});
  };
  const double rho = conditions.damping.rho();
  add(StopKind::region_one, example_of(Region::one, rho));
  add(StopKind::region_two, example_of(Region::two, rho));
  add(StopKind::region_three, example_of(Region::three, rho));
  add(StopKind::region_four, example_of(Region::four, rho));
  for (const UnfoldingParameters &at : settings.listed)
    add(StopKind::listed, at);
  std::erase_if(stops, [](const StopToJudge &stop) {
    return !(stop.choice.stiffness > 0 && std::isfinite(stop.choice.force));
  });
  return stops;
}

void declare_conditions(parameters::Section &section) {
  using namespace parameters;
  section
      .quantity("Working frequency", "", dimension::frequency, range::positive, "\\omega_w",
                "Frequency at which the isolator works, above its natural frequency; there the "
                "stop must not be reached.")
      .required()
      .quantity("Transmissibility", "", dimension::none,
                Range{.lower = 0, .upper = 1, .lower_open = true, .upper_open = true}, "T",
                "Wanted at the working frequency: the least frequency ratio for it is given; empty "
                "when none is wanted.")
      .quantity("Allowed displacement", "", dimension::length, range::positive, "X",
                "Amplitude that the resonance may have.")
      .required()
      .choice("Prefer", "least stiffness", {"least stiffness", "largest clearance"},
              "Which corner of the set of possible stops is chosen.")
      .choice("Jump limit", "hysteresis set", {"hysteresis set", "averaged response"},
              "What says where a jump begins: the hysteresis set of the expanded equation, which "
              "is on the safe side, or the averaged equation itself.")
      .quantity("Margin", "0", dimension::none, Range{.lower = 0, .upper = 10}, "",
                "By which part each condition on force and stiffness is to be more than met.");
}

} // namespace

void IsolatorDesign::declare(parameters::Section &analysis) {
  using namespace parameters;
  Section &section = analysis.subsection(
      isolator_design_section,
      "Stiffness and clearance of the two damped stops of an isolator, so that its "
      "resonance is bounded and does not jump.");
  declare_conditions(section);
  section
      .quantity("Unfolding frequency ratio", "1", dimension::none, range::positive, "\\lambda",
                "Excitation over natural frequency in the first unfolding parameter, which the "
                "hysteresis set needs beforehand.")
      .quantities(first_key, "", dimension::none, range::positive, "\\alpha_1",
                  "Of further stops to judge.", 0, 10000)
      .quantities(second_key, "", dimension::none, range::any, "\\alpha_2",
                  "Of the same stops, each below the bifurcation set B2.", 0, 10000)
      .integer("Points", "200", Range{.lower = 2, .upper = 2000}, "", "Of each curve.")
      .text("Excitation", "", "The force; empty when there is only one excitation.");
  IsolatorBranches::declare(section);
}

bool IsolatorDesign::evaluates(const Values &analysis) {
  return analysis.subsection(isolator_design_section).has("Repeat");
}

std::shared_ptr<const Analysis> IsolatorDesign::create(const Values &analysis) {
  const Values section = analysis.subsection(isolator_design_section);
  section.require("Working frequency");
  section.require("Allowed displacement");
  const IsolatorBranches branches(section);
  if (!branches.evaluated().empty())
    refuse_selections(analysis, branches.evaluated());
  Settings settings{
      .working_frequency = section.quantity("Working frequency"),
      .allowed_displacement = section.quantity("Allowed displacement"),
      .unfolding_ratio = section.quantity("Unfolding frequency ratio"),
      .margin = section.quantity("Margin"),
      .preference = section.choice("Prefer") == "least stiffness" ? Preference::least_stiffness
                                                                  : Preference::largest_clearance,
      .jump_limit = section.choice("Jump limit") == "hysteresis set" ? JumpLimit::hysteresis_set
                                                                     : JumpLimit::averaged_response,
      .listed = read_listed(section),
      .points = static_cast<std::size_t>(section.integer("Points")),
      .excitation = section.text("Excitation"),
      .branches = branches,
      .section = section};
  if (section.has("Transmissibility"))
    settings.transmissibility = section.quantity("Transmissibility");
  return std::make_shared<IsolatorDesign>(std::move(settings));
}

StopConditions IsolatorDesign::conditions(const IsolatorSystem &isolator) const {
  return {.damping = isolator.damping_ratios(),
          .unfolding_ratio = settings_.unfolding_ratio,
          .working_ratio = settings_.working_frequency / isolator.natural_frequency(),
          .allowed = settings_.allowed_displacement * isolator.stiffness / isolator.force,
          .margin = settings_.margin,
          .jump_limit = settings_.jump_limit};
}

void IsolatorDesign::check(const System &system) const {
  const IsolatorSystem isolator = read_isolator(system, settings_.excitation);
  if (!(settings_.working_frequency > isolator.natural_frequency()))
    settings_.section->reject("Working frequency",
                              "must be greater than the natural frequency of " +
                                  std::to_string(isolator.natural_frequency()) + " rad/s.");
  const double rho = isolator.damping_ratios().rho();
  for (const UnfoldingParameters &at : settings_.listed)
    if (region_of(at, rho) == Region::none)
      settings_.section->reject(second_key, "must be less than (rho alpha_1/2)^2, which is " +
                                                std::to_string(set_b2(at.first, rho)) +
                                                " at alpha_1 = " + std::to_string(at.first) +
                                                ": above it there is no force.");
}

void IsolatorDesign::check_built(const SystemSource &build) const {
  settings_.branches.check(build, settings_.excitation);
}

PointResult IsolatorDesign::compute(const System &system, LineContext &context) const {
  const IsolatorSystem isolator = read_isolator(system, settings_.excitation);
  const StopConditions limits = conditions(isolator);
  const StopCorners corners = corners_of(limits);
  PointResult result;
  add_linear_step(result, isolator, limits, settings_.transmissibility);
  add_plane(result, limits, settings_.points);
  add_limits(result, limits, corners, isolator, settings_.points);
  std::vector<StopToJudge> stops = stops_to_judge(settings_, limits, corners);
  try {
    const StopChoice chosen = preferred_stop(limits, corners, settings_.preference);
    stops.insert(stops.begin(), {StopKind::chosen, chosen});
  } catch (const NumericalError &error) {
    result.status = Status::failed;
    result.reason = error.what();
  }
  std::vector<PointResult> judged;
  for (const StopToJudge &stop : stops) {
    const double done = static_cast<double>(judged.size()) / static_cast<double>(stops.size());
    judged.push_back(judge_by_averaging(stop, isolator, limits, settings_.points));
    context.note_progress(done);
    if (!evaluated().empty())
      add_exact(judged.back(),
                settings_.branches.follow(stop.choice, isolator, context.outcomes(),
                                          [&](double) { context.note_progress(done); }),
                isolator.clearance_of(stop.choice));
  }
  add_judged(result, judged);
  return result;
}

void IsolatorDesign::run_line(std::size_t /*line*/, System &system, LineContext &context) const {
  run_single_point(context, [&] { return compute(system, context); });
}

} // namespace vibroimpact::analyses
