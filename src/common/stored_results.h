// What the parts of a result consist of (bytes.h).
#pragma once

#include "common/bytes.h"
#include "common/result_sink.h"

namespace vibroimpact {

void members(auto &visit, As<Label> auto &label) {
  std::string name = label.name(), unit = label.unit(), description = label.description();
  std::vector<std::string> dimensions = label.dimensions();
  visit(name, unit, description, dimensions);
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(label)>>)
    label = Label(name, unit, description, dimensions);
}
void members(auto &visit, As<Axis> auto &axis) {
  visit(axis.name, axis.values, axis.labels, axis.unit, axis.description);
}
void members(auto &visit, As<AnalysisHeader> auto &header) {
  visit(header.name, header.type, header.axes, header.grid);
}
void members(auto &visit, As<TouchedNode> auto &touched) {
  visit(touched.body, touched.node, touched.push);
}
void members(auto &visit, As<ContactTrace> auto &trace) {
  visit(trace.nodes, trace.gap, trace.force, trace.peak_force);
}
void members(auto &visit, As<Motion> auto &motion) {
  visit(motion.time, motion.coordinates, motion.base_displacement, motion.velocities,
        motion.base_velocity, motion.contacts);
}

} // namespace vibroimpact
