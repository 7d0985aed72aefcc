#include "output/contact_fields.h"

#include <algorithm>

namespace vibroimpact::output {

namespace {

constexpr float open = 1;
constexpr float acting = 2;

Eigen::Matrix<float, 6, 1> fields_at(const ContactTrace &trace, const TouchedNode &at,
                                     std::size_t instant) {
  Eigen::Matrix<float, 6, 1> fields;
  fields.head<3>() = (trace.force[instant] * at.push).cast<float>();
  fields[3] = static_cast<float>(trace.gap[instant]);
  fields[4] = static_cast<float>(trace.peak_force[instant]);
  fields[5] = trace.force[instant] == 0 ? open : acting;
  return fields;
}

} // namespace

bool touches_mesh(const Motion &motion) {
  return std::any_of(motion.contacts.begin(), motion.contacts.end(),
                     [](const ContactTrace &trace) { return !trace.nodes.empty(); });
}

ContactFields contact_fields(const Motion &motion, std::size_t body, Index nodes,
                             std::size_t instant) {
  ContactFields fields;
  if (!touches_mesh(motion))
    return fields;
  fields.setZero(6, nodes);
  for (const ContactTrace &trace : motion.contacts)
    for (const TouchedNode &at : trace.nodes) {
      if (at.body != body)
        continue;
      auto column = fields.col(at.node);
      const Eigen::Matrix<float, 6, 1> own = fields_at(trace, at, instant);
      const bool first = column[5] == 0;
      column.head<3>() += own.head<3>();
      column[3] = first ? own[3] : std::min(column[3], own[3]);
      column.tail<2>() = column.tail<2>().cwiseMax(own.tail<2>());
    }
  return fields;
}

// With n from the node to the stop, gap = (displacement of the stop - displacement of the node) n.
std::vector<StopFace> stop_faces(const std::vector<reduction::ReducedBody> &bodies,
                                 const Motion &motion, const std::vector<Vector> &node_motion,
                                 std::size_t instant) {
  std::vector<StopFace> faces;
  for (const ContactTrace &trace : motion.contacts) {
    if (trace.nodes.size() != 1)
      continue;
    const TouchedNode &at = trace.nodes.front();
    const Vector3 normal = -at.push;
    const Vector3 moved = node_motion[at.body].segment<3>(Index{6} * at.node);
    faces.push_back({.place = bodies[at.body].recovery.nodes.col(at.node),
                     .normal = normal,
                     .displacement = (moved.dot(normal) + trace.gap[instant]) * normal,
                     .contact = fields_at(trace, at, instant)});
  }
  return faces;
}

} // namespace vibroimpact::output
