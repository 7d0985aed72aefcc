#include "analyses/recorders/frame_recorder.h"

#include "analyses/recorders/sampler.h"

#include <algorithm>

namespace vibroimpact::analyses {

using motion::Bernstein;
using motion::StepView;

namespace {

double position(const StepView &view, double instant) {
  return (instant - view.start()) / view.length();
}

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
