#include "reduction/shell_parameters.h"

#include "common/memory.h"
#include "parameters/text.h"
#include "reduction/body_sections.h"

#include <cmath>

namespace vibroimpact::reduction {

namespace {

using namespace sections;
using structure::ShellDefinition;

std::array<int, 2> read_surface_divisions(const Values &geometry) {
  // Matrices, their factors and the work space of the eigen-solution: 19 kB for each node of plates
  // of 10^4 to 4 10^4 nodes, and slowly growing.
  const std::vector<int> divisions = read_divisions(geometry, 2, 25e3);
  return {divisions[0], divisions[1]};
}

structure::CellShape read_cell_shape(const Values &geometry) {
  return geometry.choice("Cell shape") == "triangle" ? structure::CellShape::triangle
                                                     : structure::CellShape::quadrilateral;
}

void read_plate(const Values &geometry, ShellDefinition &shell) {
  shell.plate = structure::Plate{.corner = vector3(geometry, "Plate", 0),
                                 .first_end = vector3(geometry, "Plate", 3),
                                 .second_end = vector3(geometry, "Plate", 6),
                                 .elements = read_surface_divisions(geometry),
                                 .shape = read_cell_shape(geometry)};
}

void read_cylinder(const Values &geometry, ShellDefinition &shell) {
  geometry.require("Radius");
  const std::vector<double> angles = geometry.quantities("Angles");
  shell.cylinder = structure::Cylinder{.start = vector3(geometry, "Cylinder", 0),
                                       .end = vector3(geometry, "Cylinder", 3),
                                       .radius = geometry.quantity("Radius"),
                                       .angles = {angles[0], angles[1]},
                                       .zero = {},
                                       .elements = read_surface_divisions(geometry),
                                       .shape = read_cell_shape(geometry)};
  if (geometry.has("Orientation"))
    shell.cylinder->zero = vector3(geometry, "Orientation");
}

/// Keys that only some geometries use must not be given with another.
void check_geometry(const Values &geometry) {
  for (const char *unused : {"Line", "Elements", "Block"})
    if (geometry.given(unused))
      geometry.reject(unused, "must not be set when Type = shell");
  const int given =
      int{geometry.has("Mesh")} + int{geometry.has("Plate")} + int{geometry.has("Cylinder")};
  if (given == 0)
    geometry.require("Plate");
  if (given > 1)
    geometry.reject_section("only one of Mesh, Plate and Cylinder must be set");
  const auto refuse = [&](const char *key, const char *needed) {
    if (geometry.given(key) && !geometry.has(needed))
      geometry.reject(key, std::string("must not be set when ") + needed + " is not set");
  };
  for (const char *key : {"Radius", "Angles", "Orientation"})
    refuse(key, "Cylinder");
  if (geometry.has("Mesh"))
    for (const char *key : {"Divisions", "Cell shape"})
      refuse(key, "Plate");
}

void read_shell_geometry(const Values &geometry, const std::string &folder, MPI_Comm communicator,
                         ShellDefinition &shell) {
  check_geometry(geometry);
  if (geometry.has("Mesh"))
    shell.mesh_content = read_mesh(geometry, folder, communicator);
  else if (geometry.has("Plate"))
    read_plate(geometry, shell);
  else
    read_cylinder(geometry, shell);
}

/// A key of its own, or that of the body's Material.
double material_value(const Values &section, const Values &material, const char *key) {
  if (section.has(key))
    return section.quantity(key);
  return material.quantity(key);
}

} // namespace

std::vector<int> read_divisions(const Values &geometry, std::size_t directions,
                                double bytes_of_node) {
  const std::string rule =
      "must be " + std::to_string(directions) + " whole numbers from 1 to " + "1000000";
  const std::vector<double> numbers = geometry.quantities("Divisions");
  std::vector<int> divisions;
  double nodes = 1;
  for (const double number : numbers) {
    if (number != std::floor(number) || number > 1e6 || numbers.size() != directions)
      geometry.reject("Divisions", rule);
    divisions.push_back(static_cast<int>(number));
    nodes *= number + 1;
  }
  if (const std::string lack = lack_of_memory(bytes_of_node * nodes); !lack.empty())
    geometry.reject("Divisions", "must make a smaller mesh: for its " +
                                     parameters::number_text(nodes) + " nodes " + lack);
  return divisions;
}

structure::Material own_material(const Values &section, const Values &material) {
  return {material_value(section, material, "Young modulus"),
          material_value(section, material, "Poisson ratio"),
          material_value(section, material, "Density")};
}

namespace {

structure::Stiffener read_stiffener(const Values &section, const std::string &name,
                                    const Values &material) {
  section.require("On");
  structure::Stiffener stiffener{.name = name,
                                 .on = section.text("On"),
                                 .section = read_section(section),
                                 .material = own_material(section, material),
                                 .local_y = {},
                                 .offset = {}};
  if (section.has("Orientation"))
    stiffener.local_y = vector3(section, "Orientation");
  const std::vector<double> offset = section.quantities("Offset");
  stiffener.offset = {offset[0], offset[1]};
  stiffener.axial_force = section.quantity("Axial force");
  return stiffener;
}

} // namespace

void refuse_shell_geometry(const Values &body) {
  const Values geometry = body.subsection("Geometry");
  for (const char *key :
       {"Plate", "Cylinder", "Radius", "Angles", "Divisions", "Cell shape", "Block"})
    if (geometry.given(key))
      geometry.reject(key, "must not be set when Type = " + body.choice("Type"));
}

ShellDefinition read_shell_definition(const Values &body, const std::string &folder,
                                      MPI_Comm communicator) {
  ShellDefinition shell;
  read_shell_geometry(body.subsection("Geometry"), folder, communicator, shell);
  const Values material = body.subsection("Material");
  for (const std::string &name : body.instances("Shell")) {
    const Values section = body.instance("Shell", name);
    section.require("Thickness");
    shell.parts.push_back({.name = name,
                           .on = section.text("On"),
                           .thickness = section.quantity("Thickness"),
                           .material = own_material(section, material)});
  }
  if (shell.parts.empty())
    body.reject_section("at least one subsection Shell NAME must be given when Type = shell");
  for (const std::string &name : body.instances("Stiffener"))
    shell.stiffeners.push_back(read_stiffener(body.instance("Stiffener", name), name, material));
  shell.supports = read_supports(body);
  shell.points = read_points(body);
  shell.links = read_links(body);
  shell.interfaces = read_interfaces(body);
  shell.loads = read_loads(body);
  return shell;
}

} // namespace vibroimpact::reduction
