#include "structure/body_model.h"

#include "structure/frame_body.h"
#include "structure/hinges.h"
#include "structure/interface_nodes.h"
#include "structure/node_rotations.h"
#include "structure/rigid_links.h"
#include "structure/shell_body.h"
#include "structure/solid_body.h"
#include "structure/spin.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::structure {

namespace {

void apply_support(BodyModel &model, const Support &support) {
  for (const int node : find_nodes(model.mesh, support.at, "Support", support.name))
    for (int component = 0; component < 6; ++component) {
      if (support.fixed[component])
        model.fixed[node][component] = true;
      model.spring[node][component] += support.stiffness[component];
    }
}

void apply_point(BodyModel &model, const Point &point) {
  const std::vector<int> nodes = find_nodes(model.mesh, point.at, "Point", point.name);
  if (nodes.size() != 1)
    throw DefinitionError("Point", point.name, "At",
                          "must mean exactly one node, but " + point.at.group + " has " +
                              std::to_string(nodes.size()));
  model.points.push_back({.name = point.name, .node = nodes[0]});
  const LumpedMass mass = lumped_mass(point);
  if (!mass.isZero(0))
    model.lumped_masses.try_emplace(nodes[0], LumpedMass::Zero()).first->second += mass;
}

void hold_plane(BodyModel &model, int normal) {
  for (std::array<bool, 6> &fixed : model.fixed)
    fixed[normal] = fixed[3 + (normal + 1) % 3] = fixed[3 + (normal + 2) % 3] = true;
}

void add_interface(BodyModel &model, const Interface &interface) {
  const std::vector<int> nodes = interface_nodes(model.mesh, interface);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    model.points.push_back({.name = interface.name + "." + std::to_string(i + 1),
                            .node = nodes[i],
                            .interface = interface.name});
}

void apply_load(BodyModel &model, const Load &load) {
  model.loaded = true;
  model.acceleration += load.acceleration;
  if (!load.at.position && load.at.group.empty())
    return;
  for (const int node : find_nodes(model.mesh, load.at, "Load", load.name))
    for (int axis = 0; axis < 3; ++axis) {
      model.load[node][axis] += load.force[axis];
      model.load[node][3 + axis] += load.moment[axis];
    }
}

template <class Definition> BodyParts parts_of(const Definition &definition) {
  return {.plane_normal = definition.plane_normal,
          .supports = definition.supports,
          .points = definition.points,
          .interfaces = definition.interfaces,
          .loads = definition.loads};
}

/// What beams, shells and solids are given alike; the elements are there already.
template <class Definition> void complete(BodyModel &model, const Definition &definition) {
  add_parts(parts_of(definition), model);
  if (!(model.total_mass() > 0))
    throw DefinitionError("Material", "", "Density",
                          "must be greater than 0 for a body without lumped masses");
}

} // namespace

// With the cross product r x as the matrix R, the displacement u - R theta and the inertia J about
// the centre of mass
//   | m 1   -m R       |
//   | m R   J - m R R  |
LumpedMass lumped_mass(const Point &point) {
  Eigen::Matrix3d arm;
  for (int axis = 0; axis < 3; ++axis)
    arm.col(axis) = point.offset.cross(Vector3::Unit(axis));
  Eigen::Matrix3d inertia = point.rotary_inertia.asDiagonal();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    inertia(i, j) = inertia(j, i) = -point.products_of_inertia[i];
  }
  LumpedMass mass;
  mass << point.mass * Eigen::Matrix3d::Identity(), -point.mass * arm, point.mass * arm,
      inertia - point.mass * arm * arm;
  return (mass + mass.transpose()) / 2;
}

void add_parts(const BodyParts &parts, BodyModel &model) {
  const std::size_t nodes = model.mesh.nodes.size();
  model.fixed.assign(nodes, {});
  model.spring.assign(nodes, {});
  model.load.assign(nodes, {});
  if (parts.plane_normal)
    hold_plane(model, *parts.plane_normal);
  for (const Support &support : parts.supports)
    apply_support(model, support);
  for (const Point &point : parts.points)
    apply_point(model, point);
  for (const Interface &interface : parts.interfaces)
    add_interface(model, interface);
  for (const Load &load : parts.loads)
    apply_load(model, load);
}

double BodyModel::distributed_mass() const {
  double mass = 0;
  for (const auto &element : elements)
    mass += element->total_mass();
  return mass;
}

double BodyModel::total_mass() const {
  double mass = distributed_mass();
  for (const auto &[node, lumped] : lumped_masses)
    mass += lumped(0, 0);
  return mass;
}

void BodyModel::add_material(const Material &material) {
  if (material.density > 0)
    wave_speed = std::max(wave_speed, std::sqrt(material.young_modulus / material.density));
}

BodyModel build_frame(const BeamDefinition &definition) {
  BodyModel model;
  model.mesh = frame_mesh(definition);
  const FrameLines lines = frame_lines(model.mesh, definition);
  add_frame_elements(model, definition, lines);
  complete(model, definition);
  std::vector<std::string> names;
  for (const Member &member : definition.members)
    names.push_back(member.name);
  model.rigid = rigid_bodies(model, definition.links, names, lines.members);
  check_hinges(model, definition, lines.frames, lines.releases);
  check_rigid_lines(model, definition, lines.members);
  if (definition.spin)
    add_spin(model, definition, lines);
  for (const Load &load : definition.loads)
    if (load.pressure != 0)
      throw DefinitionError("Load", load.name, "Pressure",
                            "needs the surfaces of a shell or solid");
  return model;
}

BodyModel build_shell(const ShellDefinition &definition) {
  BodyModel model;
  model.mesh = shell_mesh(definition);
  add_shell_elements(model, definition);
  for (const MeshPart &part : definition.parts)
    model.add_material(part.material);
  complete(model, definition);
  model.rigid = rigid_bodies(model, definition.links, {}, {});
  for (const Load &load : definition.loads)
    if (load.pressure != 0)
      add_shell_pressure(model, load);
  return model;
}

BodyModel build_solid(const SolidDefinition &definition) {
  BodyModel model;
  model.mesh = solid_mesh(definition);
  add_solid_elements(model, definition);
  for (const MeshPart &part : definition.parts)
    model.add_material(part.material);
  complete(model, definition);
  model.rigid = rigid_bodies(model, definition.links, {}, {});
  hold_idle_rotations(model, parts_of(definition), definition.links);
  for (const Load &load : definition.loads)
    if (load.pressure != 0)
      add_solid_pressure(model, load);
  keep_solids(model.mesh);
  return model;
}

} // namespace vibroimpact::structure
