#include "reduction/body_parameters.h"

#include "reduction/body_file.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace vibroimpact {

namespace {

using parameters::Values;

constexpr std::array<const char *, 6> components = {"x", "y", "z", "rx", "ry", "rz"};

Vector3 vector3(const Values &section, const std::string &key, std::size_t first = 0) {
  const std::vector<double> values = section.quantities(key);
  return {values[first], values[first + 1], values[first + 2]};
}

double optional_quantity(const Values &section, const std::string &key) {
  return section.has(key) ? section.quantity(key) : 0.0;
}

/// Of the keys that only some choices of `chooser` use, the others must not be given.
struct KeyUse {
  const char *key;
  std::vector<std::string> choices;
};
void check_use(const Values &section, const std::string &chooser, const std::vector<KeyUse> &uses) {
  const std::string choice = section.choice(chooser);
  for (const KeyUse &use : uses) {
    const bool used =
        std::find(use.choices.begin(), use.choices.end(), choice) != use.choices.end();
    if (!used && section.given(use.key))
      section.reject(use.key, "is not used with " + chooser + " = " + choice);
  }
}

std::string read_mesh(const Values &geometry, const std::string &folder, MPI_Comm communicator) {
  const auto file = (std::filesystem::path(folder) / geometry.text("Mesh")).string();
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  std::string content;
  if (rank == 0)
    content = read_file(file).value_or("");
  content = broadcast(std::move(content), communicator);
  if (content.empty())
    geometry.reject("Mesh",
                    "must name a file that can be read and is not empty; there is none at " + file);
  return content;
}

void read_geometry(const Values &geometry, const std::string &folder, MPI_Comm communicator,
                   structure::BeamDefinition &beam) {
  if (geometry.has("Mesh") && geometry.has("Line"))
    geometry.reject("Line", "must not be given together with Mesh");
  if (geometry.has("Mesh")) {
    if (geometry.given("Elements"))
      geometry.reject("Elements", "must not be given together with Mesh, which has its own");
    beam.mesh_content = read_mesh(geometry, folder, communicator);
  } else if (geometry.has("Line")) {
    beam.line = {vector3(geometry, "Line", 0), vector3(geometry, "Line", 3),
                 static_cast<int>(geometry.integer("Elements"))};
  } else {
    geometry.reject_section("needs a Line or a Mesh");
  }
  if (geometry.has("Orientation"))
    beam.local_y = vector3(geometry, "Orientation");
}

structure::SectionShape read_section(const Values &section) {
  check_use(section, "Shape",
            {{"Width", {"rectangle"}},
             {"Thickness", {"rectangle"}},
             {"Diameter", {"circle", "tube"}},
             {"Wall thickness", {"tube"}},
             {"Area", {"given"}},
             {"Second moment y", {"given"}},
             {"Second moment z", {"given"}},
             {"Torsion constant", {"given"}}});
  using Kind = structure::SectionShape::Kind;
  const std::map<std::string, Kind> kinds = {{"rectangle", Kind::rectangle},
                                             {"circle", Kind::circle},
                                             {"tube", Kind::tube},
                                             {"given", Kind::given}};
  return {.kind = kinds.at(section.choice("Shape")),
          .width = optional_quantity(section, "Width"),
          .thickness = optional_quantity(section, "Thickness"),
          .diameter = optional_quantity(section, "Diameter"),
          .wall_thickness = optional_quantity(section, "Wall thickness"),
          .area = optional_quantity(section, "Area"),
          .second_moment_y = optional_quantity(section, "Second moment y"),
          .second_moment_z = optional_quantity(section, "Second moment z"),
          .torsion_constant = optional_quantity(section, "Torsion constant")};
}

structure::Material read_material(const Values &material) {
  material.require("Young modulus");
  material.require("Density");
  return {material.quantity("Young modulus"), material.quantity("Poisson ratio"),
          material.quantity("Density")};
}

structure::Location read_place(const Values &section) {
  if (section.has("At") == section.has("Position"))
    section.reject_section("needs either At or Position");
  if (section.has("Position"))
    return {"", vector3(section, "Position")};
  return {section.text("At"), std::nullopt};
}

void fix(const Values &section, const std::string &word, std::array<bool, 6> &fixed) {
  if (word == "all")
    fixed.fill(true);
  else if (word == "pinned")
    fixed[0] = fixed[1] = fixed[2] = true;
  else {
    std::vector<std::string> known(components.begin(), components.end());
    known.insert(known.end(), {"pinned", "all"});
    section.require_known("Fix", word, known);
    fixed[std::find(components.begin(), components.end(), word) - components.begin()] = true;
  }
}

structure::Support read_support(const Values &section, const std::string &name) {
  structure::Support support{.name = name, .at = read_place(section)};
  for (const std::string &word : section.names("Fix"))
    fix(section, word, support.fixed);
  for (int axis = 0; axis < 3; ++axis) {
    if (section.has("Stiffness"))
      support.stiffness[axis] = section.quantities("Stiffness")[axis];
    if (section.has("Rotational stiffness"))
      support.stiffness[3 + axis] = section.quantities("Rotational stiffness")[axis];
  }
  if (!section.has("Fix") && !section.has("Stiffness") && !section.has("Rotational stiffness"))
    section.reject_section("holds nothing: give Fix, Stiffness or Rotational stiffness");
  return support;
}

structure::Point read_point(const Values &section, const std::string &name) {
  structure::Point point{.name = name, .at = read_place(section), .mass = section.quantity("Mass")};
  if (section.has("Rotary inertia"))
    point.rotary_inertia = vector3(section, "Rotary inertia");
  return point;
}

modes::Selection read_selection(const Values &section) {
  modes::Selection selection;
  selection.number = static_cast<int>(section.integer("Number"));
  if (!section.has("Band"))
    return selection;
  if (section.given("Number"))
    section.reject("Number", "must not be given together with Band");
  const std::vector<double> band = section.quantities("Band");
  if (!(band[1] > band[0]))
    section.reject("Band", "must be a lower and a greater upper frequency");
  selection.band = {band[0], band[1]};
  return selection;
}

Damping read_damping(const Values &section) {
  check_use(section, "Damping model",
            {{"Damping ratio", {"ratio"}},
             {"Rayleigh alpha", {"rayleigh"}},
             {"Rayleigh beta", {"rayleigh"}},
             {"Viscous constant", {"viscous"}}});
  Damping damping;
  damping.ratios = section.quantities("Damping ratio");
  const std::string model = section.choice("Damping model");
  if (model == "rayleigh") {
    damping.model = Damping::Model::rayleigh;
    damping.alpha = optional_quantity(section, "Rayleigh alpha");
    damping.beta = optional_quantity(section, "Rayleigh beta");
  } else if (model == "viscous") {
    section.require("Viscous constant");
    damping.model = Damping::Model::viscous;
    damping.viscous_constant = section.quantity("Viscous constant");
  }
  return damping;
}

std::vector<int> read_axes(const Values &section) {
  std::vector<int> axes;
  for (const std::string &name : section.names("Axis")) {
    section.require_known("Axis", name, {"x", "y", "z"});
    const int axis = name[0] - 'x';
    if (std::find(axes.begin(), axes.end(), axis) != axes.end())
      section.reject("Axis", "each of x, y, z at most once");
    axes.push_back(axis);
  }
  if (axes.empty())
    section.reject("Axis", "at least one of x, y, z");
  return axes;
}

LumpedMass read_mass(const Values &section, const std::string &name) {
  section.require("Mass");
  return {.name = name,
          .mass = section.quantity("Mass"),
          .axes = read_axes(section),
          .stiffness = section.quantity("Stiffness"),
          .damping = section.quantity("Damping"),
          .position = vector3(section, "Position")};
}

// A body of this type uses none of the sections `fixed` and `named`.
void refuse(const Values &body, const std::vector<const char *> &fixed,
            const std::vector<const char *> &named) {
  const auto reject = [&](const char *unused) {
    body.reject("Type", "= " + body.choice("Type") + " has no use for a subsection " + unused);
  };
  for (const char *unused : fixed)
    if (body.subsection_given(unused))
      reject(unused);
  for (const char *unused : named)
    if (!body.instances(unused).empty())
      reject(unused);
}

void read_beam(const Values &body, const std::string &folder, MPI_Comm communicator,
               BodyDefinition &definition) {
  if (!body.instances("Mass").empty())
    body.reject("Type", "= beam has no use for a subsection Mass (a Point can carry a mass)");
  refuse(body, {"Rotor", "Motor"}, {});
  read_geometry(body.subsection("Geometry"), folder, communicator, definition.beam);
  definition.beam.section = read_section(body.subsection("Section"));
  definition.beam.material = read_material(body.subsection("Material"));
  for (const std::string &name : body.instances("Support"))
    definition.beam.supports.push_back(read_support(body.instance("Support", name), name));
  for (const std::string &name : body.instances("Point"))
    definition.beam.points.push_back(read_point(body.instance("Point", name), name));
  definition.selection = read_selection(body.subsection("Modes"));
  definition.damping = read_damping(body.subsection("Modes"));
}

void read_rotor(const Values &body, BodyDefinition &definition) {
  refuse(body, {"Geometry", "Section", "Material", "Modes"}, {"Support", "Point", "Mass"});
  const Values rotor = body.subsection("Rotor");
  rotor.require("Mass");
  rotor.require("Inertia");
  definition.rotor = {.inertia = rotor.quantity("Inertia"), .friction = rotor.quantity("Friction")};
}

void read_lumped(const Values &body, BodyDefinition &definition) {
  refuse(body, {"Geometry", "Section", "Material", "Modes", "Rotor", "Motor"},
         {"Support", "Point"});
  for (const std::string &name : body.instances("Mass"))
    definition.masses.push_back(read_mass(body.instance("Mass", name), name));
}

} // namespace

BodyDefinition read_body(const Values &body, const std::string &name, const std::string &folder,
                         MPI_Comm communicator) {
  BodyDefinition definition;
  definition.name = name;
  if (body.choice("Type") == "lumped") {
    definition.type = BodyDefinition::Type::lumped;
    read_lumped(body, definition);
  } else if (body.choice("Type") == "rotor") {
    definition.type = BodyDefinition::Type::rotor;
    read_rotor(body, definition);
  } else {
    read_beam(body, folder, communicator, definition);
  }
  return definition;
}

} // namespace vibroimpact
