#include "structure/shell_body.h"

#include "structure/cell_parts.h"
#include "structure/director_kinematics.h"
#include "structure/frame_element.h"
#include "structure/gmsh_reader.h"
#include "structure/mesh_check.h"
#include "structure/shell_element.h"
#include "structure/shell_mesh.h"
#include "structure/surface_normals.h"

#include <set>

namespace vibroimpact::structure {

namespace {

std::vector<int> stiffener_lines(const Mesh &mesh, const Stiffener &stiffener) {
  return find_cells(mesh.line_groups, stiffener.on, mesh.lines.size(), "Stiffener", stiffener.name);
}

std::vector<int> all_stiffener_lines(const Mesh &mesh, const ShellDefinition &definition) {
  std::set<int> lines;
  for (const Stiffener &stiffener : definition.stiffeners)
    for (const int line : stiffener_lines(mesh, stiffener))
      lines.insert(line);
  return {lines.begin(), lines.end()};
}

/// Sums of the normals of the surfaces around each node.
std::vector<Vector3> node_normals(const Mesh &mesh) {
  std::vector<Vector3> normals(mesh.nodes.size(), Vector3::Zero());
  for (const Cell &surface : mesh.cells)
    for (int i = 0; i < surface.size; ++i) {
      const int here = surface.corners[i];
      const int next = surface.corners[(i + 1) % surface.size];
      const int last = surface.corners[(i + surface.size - 1) % surface.size];
      normals[here] +=
          (mesh.nodes[next] - mesh.nodes[here]).cross(mesh.nodes[last] - mesh.nodes[here]);
    }
  return normals;
}

ElementFrame stiffener_frame(const Mesh &mesh, const std::array<int, 2> &line,
                             const std::vector<Vector3> &normals, const Stiffener &stiffener) {
  const Vector3 &first = mesh.nodes[line[0]];
  const Vector3 &second = mesh.nodes[line[1]];
  if (stiffener.local_y)
    return element_frame(first, second, stiffener.local_y);
  const Vector3 normal = normals[line[0]] + normals[line[1]];
  return element_frame(first, second, normal.cross(second - first));
}

void add_stiffener(BodyModel &model, const Stiffener &stiffener,
                   const std::vector<Vector3> &normals) {
  const PropertiesAlong properties =
      properties_along(stiffener.section, stiffener.material, stiffener.axial_force, 0, 0);
  const auto places = std::make_shared<const SectionPlaces>(
      SectionPlaces{extreme_fibres(stiffener.section), section_outline(stiffener.section)});
  for (const int number : stiffener_lines(model.mesh, stiffener)) {
    const auto &line = model.mesh.lines[number];
    const ElementFrame frame = stiffener_frame(model.mesh, line, normals, stiffener);
    const Vector3 offset =
        frame.axes.transpose() * Vector3(0, stiffener.offset[0], stiffener.offset[1]);
    model.elements.push_back(
        std::make_shared<FrameElement>(line, properties, frame, offset, EndPlaces{places, places}));
  }
  model.prestressed = model.prestressed || stiffener.axial_force != 0;
}

} // namespace

Mesh shell_mesh(const ShellDefinition &definition) {
  if (definition.plate)
    return generate_plate(*definition.plate);
  if (definition.cylinder)
    return generate_cylinder(*definition.cylinder);
  return parse_gmsh(definition.mesh_content);
}

void add_shell_elements(BodyModel &model, const ShellDefinition &definition) {
  const std::vector<int> beams = all_stiffener_lines(model.mesh, definition);
  check_surface_mesh(model.mesh, beams);
  const std::vector<int> parts = parts_of_cells(model.mesh, definition.parts, 2, "Shell");
  const std::vector<NodeVectors> around = surface_normals(model.mesh);
  std::vector<double> thickness;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const MeshPart &part = definition.parts[parts[i]];
    thickness.push_back(part.thickness);
    model.elements.push_back(element_on(model.mesh, model.mesh.cells[i], around[i], part));
  }
  model.locking = find_locking(model.mesh, around, thickness);
  const std::vector<Vector3> normals = node_normals(model.mesh);
  for (const Stiffener &stiffener : definition.stiffeners)
    try {
      add_stiffener(model, stiffener, normals);
    } catch (const DefinitionError &error) { // of the beam's own sections, which are keys here
      throw DefinitionError("Stiffener", stiffener.name, error.key(), error.problem());
    }
  // Lines that carry no beam only say where the groups are.
  std::vector<std::array<int, 2>> lines;
  for (const int beam : beams)
    lines.push_back(model.mesh.lines[beam]);
  model.mesh.lines = std::move(lines);
  model.mesh.line_groups.clear();
}

void add_shell_pressure(BodyModel &model, const Load &load) {
  const std::vector<int> surfaces =
      find_cells(model.mesh.cell_groups, load.on, model.mesh.cells.size(), "Load", load.name);
  check_orientation(model.mesh, surfaces, "Load", load.name, "Pressure");
  for (const int number : surfaces) {
    const auto &shell = dynamic_cast<const ShellElement &>(*model.elements[number]);
    const std::vector<Vector3> areas = shell.pressure_areas();
    for (std::size_t i = 0; i < areas.size(); ++i)
      for (int axis = 0; axis < 3; ++axis)
        model.load[shell.nodes()[i]][axis] += load.pressure * areas[i][axis];
  }
}

} // namespace vibroimpact::structure
