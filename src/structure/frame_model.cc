#include "structure/frame_model.h"

#include "structure/gmsh_reader.h"

namespace vibroimpact::structure {

namespace {

void apply_support(FrameModel &model, const Support &support) {
  for (const int node : find_nodes(model.mesh, support.at, "Support", support.name))
    for (int component = 0; component < 6; ++component) {
      if (support.fixed[component])
        model.fixed[node][component] = true;
      model.spring[node][component] += support.stiffness[component];
    }
}

void apply_point(FrameModel &model, const Point &point) {
  const std::vector<int> nodes = find_nodes(model.mesh, point.at, "Point", point.name);
  if (nodes.size() != 1)
    throw DefinitionError("Point", point.name, "At",
                          "must mean exactly one node, but " + point.at.group + " has " +
                              std::to_string(nodes.size()));
  model.points.push_back({point.name, nodes[0]});
  for (int axis = 0; axis < 3; ++axis) {
    model.lumped_mass[nodes[0]][axis] += point.mass;
    model.lumped_mass[nodes[0]][3 + axis] += point.rotary_inertia[axis];
  }
}

} // namespace

double FrameModel::distributed_mass() const {
  double mass = 0;
  for (const ElementFrame &frame : frames)
    mass += properties.mass_per_length * frame.length;
  return mass;
}

double FrameModel::total_mass() const {
  double mass = distributed_mass();
  for (const auto &lumped : lumped_mass)
    mass += lumped[0];
  return mass;
}

FrameModel build_frame(const BeamDefinition &definition) {
  FrameModel model;
  model.mesh = definition.mesh_content.empty() ? generate_line(definition.line)
                                               : parse_gmsh(definition.mesh_content);
  check_mesh(model.mesh);
  model.properties = beam_properties(cross_section(definition.section), definition.material);
  for (const auto &cell : model.mesh.cells)
    model.frames.push_back(
        element_frame(model.mesh.nodes[cell[0]], model.mesh.nodes[cell[1]], definition.local_y));
  const std::size_t nodes = model.mesh.nodes.size();
  model.fixed.assign(nodes, {});
  model.spring.assign(nodes, {});
  model.lumped_mass.assign(nodes, {});
  for (const Support &support : definition.supports)
    apply_support(model, support);
  for (const Point &point : definition.points)
    apply_point(model, point);
  if (!(model.total_mass() > 0))
    throw DefinitionError("Material", "", "Density",
                          "must be greater than 0 for a body without lumped masses");
  return model;
}

} // namespace vibroimpact::structure
