#include "structure/node_rotations.h"

#include "structure/rigid_links.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace vibroimpact::structure {

namespace {

constexpr const char *no_rotations =
    " at nodes of solids, which have displacements only (a Rigid link of nodes turns as a whole)";

/// By node: whether an element turns with it.
std::vector<bool> turned_by_elements(const BodyModel &model) {
  std::vector<bool> turned(model.mesh.nodes.size(), false);
  for (const auto &element : model.elements)
    for (const int node : element->nodes())
      turned[node] = turned[node] || element->components() == 6;
  return turned;
}

bool on_a_line(const Mesh &mesh, const std::vector<int> &nodes) {
  Vector3 along = Vector3::Zero();
  for (const int node : nodes)
    if (const Vector3 arm = mesh.nodes[node] - mesh.nodes[nodes[0]]; arm.norm() > along.norm())
      along = arm;
  return std::all_of(nodes.begin(), nodes.end(), [&](int node) {
    const Vector3 arm = mesh.nodes[node] - mesh.nodes[nodes[0]];
    return arm.cross(along).norm() <= 1e-9 * along.squaredNorm();
  });
}

/// About the line through their nodes nothing would hold a rigid body.
void check_rigid_bodies(const BodyModel &model, const std::vector<RigidLink> &links,
                        const std::vector<bool> &turned) {
  for (const std::vector<int> &nodes : model.rigid) {
    const auto turns = [&](int node) { return turned[node]; };
    if (!on_a_line(model.mesh, nodes) || std::any_of(nodes.begin(), nodes.end(), turns))
      continue;
    const auto named = std::find_if(links.begin(), links.end(), [&](const RigidLink &link) {
      const auto own = rigid_bodies(model, {link}, {}, {});
      return std::binary_search(nodes.begin(), nodes.end(), own[0][0]);
    });
    throw DefinitionError("Rigid link", named->name, "",
                          "a Rigid link of nodes of solids must have three that are not on a line");
  }
}

/// Which places with rotations are asked for; `turns` by node.
class RotationCheck {
public:
  RotationCheck(const BodyModel &model, std::vector<bool> turns)
      : mesh_(model.mesh), turns_(std::move(turns)) {}

  void operator()(const Support &support) const {
    const auto springs = std::span(support.stiffness).last(3);
    if (support.names_rotations)
      refuse(support.at, "Support", support.name, "Fix", "must not name rotations");
    if (std::any_of(springs.begin(), springs.end(), [](double spring) { return spring != 0; }))
      refuse(support.at, "Support", support.name, "Rotational stiffness", "must not act");
  }
  void operator()(const Point &point) const {
    if (!point.rotary_inertia.isZero(0) || !point.products_of_inertia.isZero(0))
      refuse(point.at, "Point", point.name, "Rotary inertia", "must be 0");
    if (!point.offset.isZero(0))
      refuse(point.at, "Point", point.name, "Offset", "must be 0");
  }
  void operator()(const Load &load) const {
    if (!load.moment.isZero(0))
      refuse(load.at, "Load", load.name, "Moment", "must not act");
  }

private:
  void refuse(const Location &at, const std::string &kind, const std::string &name,
              const std::string &key, const std::string &problem) const {
    for (const int node : find_nodes(mesh_, at, kind, name))
      if (!turns_[node])
        throw DefinitionError(kind, name, key, problem + no_rotations);
  }

  const Mesh &mesh_;
  std::vector<bool> turns_;
};

} // namespace

void hold_idle_rotations(BodyModel &model, const BodyParts &parts,
                         const std::vector<RigidLink> &links) {
  std::vector<bool> turns = turned_by_elements(model);
  check_rigid_bodies(model, links, turns);
  for (const std::vector<int> &nodes : model.rigid)
    for (const int node : nodes)
      turns[node] = true;
  const RotationCheck check(model, turns);
  std::for_each(parts.supports.begin(), parts.supports.end(), check);
  std::for_each(parts.points.begin(), parts.points.end(), check);
  std::for_each(parts.loads.begin(), parts.loads.end(), check);
  for (std::size_t node = 0; node < turns.size(); ++node)
    for (std::size_t component = 3; !turns[node] && component < 6; ++component)
      model.fixed[node][component] = true;
}

} // namespace vibroimpact::structure
