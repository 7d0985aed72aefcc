#include "analyses/transient/transient.h"

#include "analyses/recorders/frame_recorder.h"
#include "analyses/recorders/motion_progress.h"
#include "analyses/recorders/sampler.h"
#include "analyses/recorders/window_recording.h"
#include "analyses/results/fields.h"
#include "analyses/results/stress_fields.h"
#include "common/error.h"
#include "common/memory.h"
#include "parameters/text.h"

#include <algorithm>
#include <numbers>

namespace vibroimpact::analyses {

namespace {
constexpr const char *transient_section = "Transient";

// A motion that would take years of computing is a mistake in a unit or an exponent.
void check_length(const parameters::Values &section, double duration, const System &system) {
  constexpr double most = 1e12; // steps, or periods of the highest natural frequency
  if (const double step = system.integration.maximum_step; step > 0 && duration / step > most)
    section.parameters()
        .root()
        .subsection("Integration")
        .reject("Maximum step", "must be greater than 1e-12 of the Duration in " + section.path());
  double highest = 0;
  for (const auto &body : system.model.bodies())
    highest = std::max(highest, body->omega().maxCoeff());
  if (duration * highest / (2 * std::numbers::pi) > most)
    section.reject("Duration",
                   "must be at most 1e12 periods of the highest natural frequency of the bodies, " +
                       parameters::number_text(most * 2 * std::numbers::pi / highest));
}
} // namespace

void Transient::declare(parameters::Section &analysis) {
  using namespace parameters;
  analysis
      .subsection(transient_section, "Motion from the initial conditions under the excitations.")
      .quantity("Duration", "", dimension::time, range::positive, "T", "Length of the motion.")
      .required()
      .quantity("Sampling interval", "", dimension::time, range::positive, "dt",
                "Interval of the recorded histories; empty means a thousandth of the duration.")
      .integer("Recorded pulses", "10", Range{.lower = 0, .upper = 1e6}, "",
               "Impacts of each contact whose force is recorded at every time step.")
      .integer("Listed impacts", "3", Range{.lower = 0, .upper = 1e6}, "",
               "Impacts of each contact that the summary lists; the result file holds all.")
      .integer("Frames", "0", Range{.lower = 0, .upper = 1e5}, "",
               "Pictures of the moving meshes for ParaView; 0 means none.")
      .quantity("First frame", "0 s", dimension::time, range::non_negative, "",
                "Instant of the first picture.")
      .quantity("Last frame", "", dimension::time, range::positive, "",
                "Instant of the last picture; empty means the end.")
      .integer("Stress instants", "0", Range{.lower = 0, .upper = 1e6}, "",
               "Instants from First frame to Last frame at which the stress of all elements is "
               "looked at: its envelope, and the meshes at the instant of its maximum, for "
               "ParaView; 0 means none.");
}

std::shared_ptr<const Analysis> Transient::create(const parameters::Values &analysis) {
  const parameters::Values values = analysis.subsection(transient_section);
  values.require("Duration");
  Settings settings{
      .duration = values.quantity("Duration"),
      .recorded_pulses = static_cast<std::size_t>(values.integer("Recorded pulses")),
      .listed_impacts = static_cast<std::size_t>(values.integer("Listed impacts")),
      .frames = static_cast<std::size_t>(values.integer("Frames")),
      .first_frame = values.quantity("First frame"),
      .stress_instants = static_cast<std::size_t>(values.integer("Stress instants")),
      .recorders = read_recorders(analysis, {}),
      .place = values.locate(values.has("Sampling interval") ? "Sampling interval" : "Duration"),
      .stress_place = values.locate("Stress instants"),
      .section = values};
  settings.sampling_interval = values.has("Sampling interval")
                                   ? values.quantity("Sampling interval")
                                   : settings.duration / 1000;
  if (settings.duration / settings.sampling_interval > 1e8)
    values.reject("Sampling interval", "must be at least Duration / 1e8");
  settings.last_frame =
      values.has("Last frame") ? values.quantity("Last frame") : settings.duration;
  if (std::max(settings.frames, settings.stress_instants) > 1 &&
      (settings.last_frame <= settings.first_frame || settings.last_frame > settings.duration))
    values.reject("Last frame", "must be after First frame and within Duration");
  return std::make_shared<Transient>(settings);
}

void Transient::check(const System &system) const {
  if (settings_.section)
    check_length(*settings_.section, settings_.duration, system);
  // Three numbers of each point along each axis and two of each contact, kept by the recorder, the
  // result of the point and the arrays of the file.
  const double series = 9 * static_cast<double>(system.model.point_names().size()) +
                        2 * static_cast<double>(system.contacts.size()) + 1;
  const double samples = settings_.duration / settings_.sampling_interval;
  if (const std::string lack = lack_of_memory(3 * 8 * series * samples); !lack.empty())
    throw InputError(settings_.place + "\n  for the histories of " +
                     parameters::number_text(samples) + " samples " + lack +
                     "; a longer Sampling interval takes less.");
  if (settings_.stress_instants > 0 && !has_known_stress(system.model))
    throw InputError(settings_.stress_place +
                     "\n  must be 0 when no body is a beam or shell whose cross-sections have a "
                     "known shape.");
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  trajectory.start(0, system.initial.displacement, system.initial.velocity);
  const WindowRecording recording(settings_.recorders, system);
}

/// From the first to the last frame.
std::vector<double> Transient::instants(std::size_t number) const {
  std::vector<double> instants;
  for (std::size_t i = 0; i < number; ++i)
    instants.push_back(settings_.first_frame +
                       (settings_.last_frame - settings_.first_frame) * static_cast<double>(i) /
                           static_cast<double>(std::max<std::size_t>(number - 1, 1)));
  return instants;
}

PointResult Transient::compute(const System &system, LineContext &context) const {
  motion::Trajectory trajectory(system.model, system.contacts, system.integration);
  motion::ImpactLog log(system.contacts, settings_.recorded_pulses, true);
  Sampler recorder(
      observables({.points = {},
                   .kinds = {"displacement", "velocity", "acceleration", "rotation",
                             "angular_velocity", "angular_acceleration", "elongation",
                             "elongation_rate", "elongation_acceleration", "gap", "normal_force"}},
                  system),
      equal_instants(0, settings_.duration, settings_.sampling_interval));
  FrameRecorder pictures(system, instants(settings_.frames));
  FrameRecorder stresses(system, instants(settings_.stress_instants));
  MotionProgress progress(context, 0, settings_.duration);
  WindowRecording recording(settings_.recorders, system);
  PointResult result;
  try {
    trajectory.start(0, system.initial.displacement, system.initial.velocity);
    recording.run({.start = 0, .end = settings_.duration}, trajectory,
                  {&log, &recorder, &pictures, &stresses, &progress});
    recording.add_fields({result, "recorded/", Listed::yes});
    log.end_record(trajectory.time(), trajectory.state(), trajectory.layout());
  } catch (const NumericalError &error) {
    result.status = Status::failed;
    result.reason = error.what();
  }
  recorder.add_fields(result, "time");
  add_impacts(result, system.contacts, log, settings_.listed_impacts);
  add_pulses(result, system.contacts, log);
  add_accuracy(result, trajectory.accuracy(), system.integration);
  if (result.status != Status::finished)
    return result;
  if (settings_.frames + settings_.stress_instants > 0)
    result.motion.push_back(pictures.motion(log));
  if (settings_.stress_instants > 0) {
    result.motion.push_back(stresses.motion(log));
    add_largest_stresses(result, system.model, result.motion.back());
  }
  return result;
}

void Transient::run_line(std::size_t /*line*/, System &system, LineContext &context) const {
  if (context.find({})) {
    context.skip();
    return;
  }
  context.store(compute(system, context));
}

} // namespace vibroimpact::analyses
