#include "reduction/matrix_parameters.h"

#include "reduction/body_sections.h"
#include "reduction/shell_parameters.h"

#include <filesystem>
#include <map>

namespace vibroimpact::reduction {

namespace {

using namespace sections;

structure::UnitSystem unit_system(const Values &matrices) {
  constexpr double inch = 0.0254;           // exactly [m]
  constexpr double pound = 4.4482216152605; // exactly [N]
  const std::map<std::string, structure::UnitSystem> systems = {
      {"m kg s", {}},
      {"mm t s", {.length = 1e-3, .mass = 1e3, .time = 1}},
      {"mm kg ms", {.length = 1e-3, .mass = 1, .time = 1e-3}},
      {"in lbf s", {.length = inch, .mass = pound / inch, .time = 1}}};
  return systems.at(matrices.choice("Unit system"));
}

std::string name_of(const Values &section, const std::string &key) {
  return std::filesystem::path(section.text(key)).filename().string();
}

/// The generated lines of beams and their axes have no use.
void refuse_geometry(const Values &geometry) {
  for (const char *key : {"Line", "Elements", "Orientation"})
    if (geometry.given(key))
      geometry.reject(key, "must not be set when Type = matrices");
}

} // namespace

void declare_matrices(parameters::Section &body) {
  body.subsection(
          "Matrices",
          "Stiffness, mass and damping that another program has made, in files relative to "
          "the folder of the parameter file: Matrix Market (coordinate, real, symmetric or "
          "general) or lines ROW COLUMN VALUE of one triangle, as CalculiX writes them with "
          "*FREQUENCY, SOLVER=MATRIXSTORAGE.")
      .text("Stiffness", "", "File of the stiffness matrix (CalculiX: .sti).")
      .required("Type = matrices")
      .text("Mass", "",
            "File of the mass matrix (CalculiX: .mas). Rows without mass follow statically.")
      .required("Type = matrices")
      .text("Damping", "", "File of a viscous damping matrix, instead of the keys of Modes.")
      .text("Table", "",
            "File with a line NODE.DIRECTION for each row (CalculiX: .dof), or NODE DIRECTION, "
            "with the coordinates x, y, z behind it where Geometry / Mesh is not given; directions "
            "are 1 to 6 or x, y, z, rx, ry, rz. Of several lines for one direction of a node "
            "(expanded shells and beams of CalculiX) their mean is the motion of the node.")
      .required("Type = matrices")
      .choice("Unit system", "m kg s", {"m kg s", "mm t s", "mm kg ms", "in lbf s"},
              "Of the numbers in these files and in the input deck: length, mass (or force) and "
              "time.");
}

structure::MatrixDefinition read_matrix_definition(const Values &body, const std::string &folder,
                                                   MPI_Comm communicator) {
  const Values matrices = body.subsection("Matrices");
  const Values geometry = body.subsection("Geometry");
  for (const char *key : {"Stiffness", "Mass", "Table"})
    matrices.require(key);
  refuse_geometry(geometry);
  refuse_shell_geometry(body);
  structure::MatrixDefinition definition{
      .stiffness_file = path_of(matrices, "Stiffness", folder),
      .mass_file = path_of(matrices, "Mass", folder),
      .damping_file = matrices.has("Damping") ? path_of(matrices, "Damping", folder) : "",
      .table_name = name_of(matrices, "Table"),
      .table_content = read_text(matrices, "Table", folder, communicator),
      .units = unit_system(matrices),
      .supports = read_supports(body),
      .points = read_points(body),
      .interfaces = read_interfaces(body),
      .loads = read_loads(body)};
  if (geometry.has("Mesh")) {
    definition.deck_name = name_of(geometry, "Mesh");
    definition.deck_content = read_mesh(geometry, folder, communicator);
  }
  return definition;
}

} // namespace vibroimpact::reduction
