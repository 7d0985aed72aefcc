#include "reduction/solid_parameters.h"

#include "reduction/body_sections.h"
#include "reduction/shell_parameters.h"

#include <algorithm>

namespace vibroimpact::reduction {

using namespace sections;
using structure::SolidDefinition;

void declare_solid_geometry(parameters::Section &geometry) {
  geometry
      .quantities(
          "Block", "", parameters::dimension::length, parameters::range::any, "",
          "A parallelepiped of hexahedra: one corner, then the ends of the three edges that "
          "start there, x, y, z -> x, y, z -> x, y, z -> x, y, z.",
          12, 12)
      .required("Type = solid, and Mesh is not given");
}

void declare_solids(parameters::Section &body) {
  parameters::Section &solid = body.named_subsection(
      "Solid", "Material of a part of a solid; without any, all of it is of the Material.");
  solid.text("On", "all", "A physical group of volumes of the mesh, or all of them.");
  declare_own_material(solid);
}

namespace {

structure::Block read_block(const Values &geometry) {
  // Matrices, their factors and the work space of the eigen-solution.
  constexpr double bytes_of_node = 60e3;
  const std::vector<int> divisions = read_divisions(geometry, 3, bytes_of_node);
  structure::Block block{.corner = vector3(geometry, "Block", 0)};
  for (std::size_t axis = 0; axis < 3; ++axis)
    block.ends[axis] = vector3(geometry, "Block", 3 + 3 * axis);
  std::copy(divisions.begin(), divisions.end(), block.elements.begin());
  return block;
}

void read_solid_geometry(const Values &geometry, const std::string &folder, MPI_Comm communicator,
                         SolidDefinition &solid) {
  for (const char *unused :
       {"Line", "Elements", "Orientation", "Plate", "Cylinder", "Radius", "Angles", "Cell shape"})
    if (geometry.given(unused))
      geometry.reject(unused, "must not be set when Type = solid");
  if (!geometry.has("Mesh")) {
    geometry.require("Block");
    solid.block = read_block(geometry);
    return;
  }
  for (const char *unused : {"Block", "Divisions"})
    if (geometry.given(unused))
      geometry.reject(unused, "must not be set when Mesh is set");
  solid.mesh_content = read_mesh(geometry, folder, communicator);
}

} // namespace

SolidDefinition read_solid_definition(const Values &body, const std::string &folder,
                                      MPI_Comm communicator) {
  SolidDefinition solid;
  read_solid_geometry(body.subsection("Geometry"), folder, communicator, solid);
  const Values material = body.subsection("Material");
  for (const std::string &name : body.instances("Solid")) {
    const Values section = body.instance("Solid", name);
    solid.parts.push_back(
        {.name = name, .on = section.text("On"), .material = own_material(section, material)});
  }
  if (solid.parts.empty())
    solid.parts.push_back({.name = "", .material = read_material(material)});
  solid.supports = read_supports(body);
  solid.points = read_points(body);
  solid.links = read_links(body);
  solid.interfaces = read_interfaces(body);
  solid.loads = read_loads(body);
  return solid;
}

} // namespace vibroimpact::reduction
