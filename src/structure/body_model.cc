#include "structure/body_model.h"

#include "structure/frame_element.h"
#include "structure/gmsh_reader.h"
#include "structure/interface_nodes.h"
#include "structure/mesh_check.h"
#include "structure/shell_body.h"

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
  for (int axis = 0; axis < 3; ++axis) {
    model.lumped_mass[nodes[0]][axis] += point.mass;
    model.lumped_mass[nodes[0]][3 + axis] += point.rotary_inertia[axis];
  }
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

/// What beams and shells are given alike; the elements are there already.
template <class Definition> void complete(BodyModel &model, const Definition &definition) {
  const std::size_t nodes = model.mesh.nodes.size();
  model.fixed.assign(nodes, {});
  model.spring.assign(nodes, {});
  model.lumped_mass.assign(nodes, {});
  model.load.assign(nodes, {});
  for (const Support &support : definition.supports)
    apply_support(model, support);
  for (const Point &point : definition.points)
    apply_point(model, point);
  for (const Interface &interface : definition.interfaces)
    add_interface(model, interface);
  for (const Load &load : definition.loads)
    apply_load(model, load);
  if (!(model.total_mass() > 0))
    throw DefinitionError("Material", "", "Density",
                          "must be greater than 0 for a body without lumped masses");
}

double wave_speed(const Material &material) {
  return material.density > 0 ? std::sqrt(material.young_modulus / material.density) : 0;
}

} // namespace

double BodyModel::distributed_mass() const {
  double mass = 0;
  for (const auto &element : elements)
    mass += element->total_mass();
  return mass;
}

double BodyModel::total_mass() const {
  double mass = distributed_mass();
  for (const auto &lumped : lumped_mass)
    mass += lumped[0];
  return mass;
}

BodyModel build_frame(const BeamDefinition &definition) {
  BodyModel model;
  model.mesh = definition.mesh_content.empty() ? generate_line(definition.line)
                                               : parse_gmsh(definition.mesh_content);
  check_line_mesh(model.mesh);
  const BeamProperties properties =
      beam_properties(cross_section(definition.section), definition.material);
  const auto places = std::make_shared<const SectionPlaces>(
      SectionPlaces{extreme_fibres(definition.section), section_outline(definition.section)});
  for (const auto &line : model.mesh.lines)
    model.elements.push_back(std::make_shared<FrameElement>(
        line, properties,
        element_frame(model.mesh.nodes[line[0]], model.mesh.nodes[line[1]], definition.local_y),
        Vector3::Zero(), places));
  model.wave_speed = wave_speed(definition.material);
  complete(model, definition);
  for (const Load &load : definition.loads)
    if (load.pressure != 0)
      throw DefinitionError("Load", load.name, "Pressure", "needs the surfaces of a shell");
  return model;
}

BodyModel build_shell(const ShellDefinition &definition) {
  BodyModel model;
  model.mesh = shell_mesh(definition);
  add_shell_elements(model, definition);
  for (const ShellPart &part : definition.parts)
    model.wave_speed = std::max(model.wave_speed, wave_speed(part.material));
  complete(model, definition);
  for (const Load &load : definition.loads)
    if (load.pressure != 0)
      add_pressure(model, load);
  return model;
}

} // namespace vibroimpact::structure
