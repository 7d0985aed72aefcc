#include "analyses/motion_recorder.h"

#include "analyses/fields.h"
#include "analyses/system.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::analyses {

using motion::Bernstein;
using motion::StepView;

namespace {

// Instants of the list that lie in the step; its start belongs to it only at the very beginning.
std::size_t end_of_step(const std::vector<double> &instants, std::size_t next, double end) {
  while (next < instants.size() && instants[next] <= end)
    ++next;
  return next;
}

double position(const StepView &view, double instant) {
  return (instant - view.start()) / view.length();
}

} // namespace

std::vector<double> equal_instants(double first, double last, double interval) {
  const auto count = static_cast<std::size_t>(std::floor((last - first) / interval * (1 + 1e-12)));
  std::vector<double> instants;
  for (std::size_t i = 0; i <= count; ++i)
    instants.push_back(std::min(first + static_cast<double>(i) * interval, last));
  return instants;
}

MotionRecorder::MotionRecorder(const System &system, std::vector<double> instants)
    : contacts_(system.contacts), channels_(observed_channels(system.model)),
      instants_(std::move(instants)), series_(channels_.size()),
      contact_series_(system.contacts.size()) {}

void MotionRecorder::sample(const StepView &view, std::size_t first, std::size_t last) {
  for (std::size_t k = 0; k < channels_.size(); ++k) {
    const Bernstein displacement = view.displacement(channels_[k].relative);
    const Bernstein rate = displacement.derivative();
    const Bernstein acceleration = view.acceleration(channels_[k].absolute);
    for (std::size_t i = first; i < last; ++i) {
      const double tau = position(view, instants_[i]);
      series_[k].displacement.push_back(displacement(tau));
      series_[k].velocity.push_back(rate(tau) / view.length());
      series_[k].acceleration.push_back(acceleration(tau));
    }
  }
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const motion::ContactCurves curves = view.contact_curves(c);
    for (std::size_t i = first; i < last; ++i) {
      const double tau = position(view, instants_[i]);
      contact_series_[c].gap.push_back(curves.gap(tau));
      contact_series_[c].force.push_back(view.force(c, curves, tau));
    }
  }
}

void MotionRecorder::step(const StepView &view) {
  const std::size_t last = end_of_step(instants_, next_, view.end());
  if (last > next_)
    sample(view, next_, last);
  next_ = last;
}

void MotionRecorder::add_fields(const FieldWriter &result) const {
  const std::vector<double> recorded(instants_.begin(),
                                     instants_.begin() + static_cast<std::ptrdiff_t>(next_));
  result.series("time", "time", recorded, "s", "time");
  for (std::size_t k = 0; k < channels_.size(); ++k) {
    const std::string base = "point/" + channels_[k].point + "/";
    const std::string axis(1, channels_[k].axis);
    const Series &series = series_[k];
    result.series(base + "displacement_" + axis, "time", series.displacement, "m",
                  "displacement relative to the base along " + axis);
    result.series(base + "velocity_" + axis, "time", series.velocity, "m/s",
                  "velocity relative to the base along " + axis);
    result.series(base + "acceleration_" + axis, "time", series.acceleration, "m/s^2",
                  "absolute acceleration along " + axis);
  }
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    const std::string base = "contact/" + contacts_.pairs()[c].name + "/";
    result.series(base + "gap", "time", contact_series_[c].gap, "m", "gap, > 0 open");
    result.series(base + "normal_force", "time", contact_series_[c].force, "N",
                  "normal force, > 0 pushes apart");
  }
}

namespace {

/// The sides of a contact on meshes; the force pushes the first against the normal.
std::vector<TouchedNode> touched_nodes(const contact::ContactPair &pair,
                                       const model::Model &model) {
  std::vector<TouchedNode> nodes;
  const auto add = [&](const std::string &side, const Vector3 &push) {
    model::PointReference reference;
    if (!model.find_point(side, reference))
      return;
    const int node = model.bodies()[reference.body]->points[reference.point].node;
    if (node >= 0)
      nodes.push_back({.body = reference.body, .node = node, .push = push});
  };
  add(pair.side_a, -pair.normal);
  add(pair.side_b, pair.normal);
  return nodes;
}

} // namespace

FrameRecorder::FrameRecorder(const System &system, std::vector<double> instants)
    : model_(system.model), instants_(std::move(instants)) {
  const auto frames = static_cast<Index>(instants_.size());
  for (const auto &body : model_.bodies()) {
    motion_.coordinates.emplace_back(Matrix::Zero(frames, body->size()));
    motion_.velocities.emplace_back(Matrix::Zero(frames, body->size()));
    motion_.base_displacement.emplace_back(Matrix::Zero(frames, 3));
    motion_.base_velocity.emplace_back(Matrix::Zero(frames, 3));
  }
  if (!instants_.empty())
    for (const contact::ContactPair &pair : system.contacts.pairs())
      motion_.contacts.emplace_back().nodes = touched_nodes(pair, model_);
}

void FrameRecorder::sample_contacts(const StepView &view, std::size_t last) {
  for (std::size_t c = 0; c < motion_.contacts.size() && last > next_; ++c) {
    const motion::ContactCurves curves = view.contact_curves(c);
    for (std::size_t i = next_; i < last; ++i) {
      const double tau = position(view, instants_[i]);
      motion_.contacts[c].gap.push_back(curves.gap(tau));
      motion_.contacts[c].force.push_back(view.force(c, curves, tau));
    }
  }
}

Motion FrameRecorder::motion(const motion::ImpactLog &log) const {
  Motion motion = motion_;
  for (std::size_t c = 0; c < motion.contacts.size(); ++c) {
    ContactTrace &trace = motion.contacts[c];
    double peak = 0;
    for (std::size_t i = 0; i < motion.time.size(); ++i) {
      for (const motion::Impact &impact : log.impacts(c))
        if (impact.peak_time <= motion.time[i])
          peak = std::max(peak, impact.peak_force);
      peak = std::max(peak, trace.force[i]);
      trace.peak_force.push_back(peak);
    }
  }
  return motion;
}

void FrameRecorder::sample_coordinates(const StepView &view, std::size_t last) {
  for (std::size_t b = 0; b < model_.bodies().size() && last > next_; ++b)
    for (Index j = 0; j < model_.bodies()[b]->size(); ++j) {
      const Bernstein coordinate = view.coordinate(model_.offset(b) + j);
      const Bernstein rate = coordinate.derivative();
      for (std::size_t i = next_; i < last; ++i) {
        const double tau = position(view, instants_[i]);
        motion_.coordinates[b](static_cast<Index>(i), j) = coordinate(tau);
        motion_.velocities[b](static_cast<Index>(i), j) = rate(tau) / view.length();
      }
    }
}

void FrameRecorder::step(const StepView &view) {
  const std::size_t last = end_of_step(instants_, next_, view.end());
  sample_coordinates(view, last);
  sample_contacts(view, last);
  for (std::size_t i = next_; i < last; ++i) {
    motion_.time.push_back(instants_[i]);
    const auto row = static_cast<Index>(i);
    for (std::size_t b = 0; b < model_.bodies().size(); ++b) {
      motion_.base_displacement[b].row(row) = model_.base_displacement(b, instants_[i]).transpose();
      motion_.base_velocity[b].row(row) = model_.base_velocity(b, instants_[i]).transpose();
    }
  }
  next_ = last;
}

} // namespace vibroimpact::analyses
