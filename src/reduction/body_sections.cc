#include "reduction/body_sections.h"

#include "reduction/body_file.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>

namespace vibroimpact::reduction::sections {

namespace {

constexpr std::array<const char *, 6> components = {"x", "y", "z", "rx", "ry", "rz"};

void fix(const Values &section, const std::string &word, structure::Support &support) {
  std::array<bool, 6> &fixed = support.fixed;
  if (word == "all")
    fixed.fill(true);
  else if (word == "pinned")
    fixed[0] = fixed[1] = fixed[2] = true;
  else if (word.rfind("symmetric ", 0) == 0 && word.size() == 11 && word[10] >= 'x' &&
           word[10] <= 'z') {
    const int normal = word[10] - 'x'; // of the plane of symmetry
    fixed[normal] = true;
    fixed[3 + (normal + 1) % 3] = fixed[3 + (normal + 2) % 3] = true;
  } else {
    std::vector<std::string> known(components.begin(), components.end());
    known.insert(known.end(), {"pinned", "all", "symmetric x", "symmetric y", "symmetric z"});
    section.require_known("Fix", word, known);
    const auto component =
        std::find(components.begin(), components.end(), word) - components.begin();
    fixed[component] = true;
    support.names_rotations = support.names_rotations || component >= 3;
  }
}

} // namespace

Vector3 vector3(const Values &section, const std::string &key, std::size_t first) {
  const std::vector<double> values = section.quantities(key);
  return {values[first], values[first + 1], values[first + 2]};
}

double optional_quantity(const Values &section, const std::string &key) {
  return section.has(key) ? section.quantity(key) : 0.0;
}

namespace {

bool is_used(const KeyUse &use, const std::string &choice) {
  return std::find(use.choices.begin(), use.choices.end(), choice) != use.choices.end();
}

} // namespace

void check_use(const Values &section, const std::string &chooser, const std::vector<KeyUse> &uses) {
  const std::string choice = section.choice(chooser);
  for (const KeyUse &use : uses)
    if (!is_used(use, choice) && section.given(use.key))
      section.reject(use.key, "must not be set when " + chooser + " = " + choice);
}

void declare_place(parameters::Section &section, const char *when) {
  section
      .text(
          "At", "",
          "start or end of a generated line; left, right, bottom, top or edges of a plate or "
          "cylinder; left, right, bottom, top, back or front of a block (ends of its edges), or "
          "two "
          "of these in that order for an edge, as left bottom; the name of a physical group of the "
          "mesh; or all nodes. One of At, "
          "Position, Near and Node.")
      .required(when)
      .quantities("Position", "", parameters::dimension::length, parameters::range::any, "",
                  "Coordinates of a node. On a generated line of a beam a node is placed there.", 3,
                  3)
      .quantities("Near", "", parameters::dimension::length, parameters::range::any, "",
                  "Coordinates; the node nearest to them is meant.", 3, 3)
      .integer("Node", "", parameters::Range{.lower = 1, .upper = 2147483647}, "",
               "Number of a node, for Type = matrices.");
}

structure::Location read_place(const Values &section) {
  const int given = int{section.has("At")} + int{section.has("Position")} +
                    int{section.has("Near")} + int{section.has("Node")};
  if (given == 0)
    section.require("At");
  if (given > 1)
    section.reject_section("only one of At, Position, Near and Node must be set");
  if (section.has("Position"))
    return {"", vector3(section, "Position")};
  if (section.has("Near"))
    return {"", vector3(section, "Near"), true};
  if (section.has("Node"))
    return {.group = "", .position = {}, .number = static_cast<int>(section.integer("Node"))};
  return {section.text("At"), std::nullopt};
}

std::optional<int> read_plane(const Values &body) {
  const std::string plane = body.choice("Planar");
  if (plane == "no")
    return std::nullopt;
  return (plane[1] - 'x' + 1) % 3;
}

std::string path_of(const Values &section, const std::string &key, const std::string &folder) {
  return (std::filesystem::path(folder) / section.text(key)).string();
}

std::string read_text(const Values &section, const std::string &key, const std::string &folder,
                      MPI_Comm communicator) {
  const std::string file = path_of(section, key, folder);
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  std::string content;
  if (rank == 0)
    content = read_file(file).value_or("");
  content = broadcast(std::move(content), communicator);
  if (content.empty())
    section.reject(key,
                   "must name a file that can be read and is not empty; there is none at " + file);
  return content;
}

std::string read_mesh(const Values &geometry, const std::string &folder, MPI_Comm communicator) {
  return read_text(geometry, "Mesh", folder, communicator);
}

structure::SectionShape read_section(const Values &section) {
  const std::vector<KeyUse> dimensions = {{"Width", {"rectangle"}},
                                          {"Thickness", {"rectangle"}},
                                          {"Diameter", {"circle", "tube"}},
                                          {"Wall thickness", {"tube"}},
                                          {"Area", {"given"}},
                                          {"Second moment y", {"given"}},
                                          {"Second moment z", {"given"}},
                                          {"Torsion constant", {"given"}}};
  check_use(section, "Shape", dimensions);
  for (const KeyUse &dimension : dimensions)
    if (is_used(dimension, section.choice("Shape")))
      section.require(dimension.key);
  check_use(section, "Theory", {{"Shear correction", {"Timoshenko"}}});
  using Kind = structure::SectionShape::Kind;
  const std::map<std::string, Kind> kinds = {{"rectangle", Kind::rectangle},
                                             {"circle", Kind::circle},
                                             {"tube", Kind::tube},
                                             {"given", Kind::given}};
  structure::SectionShape shape{.kind = kinds.at(section.choice("Shape")),
                                .width = optional_quantity(section, "Width"),
                                .thickness = optional_quantity(section, "Thickness"),
                                .diameter = optional_quantity(section, "Diameter"),
                                .wall_thickness = optional_quantity(section, "Wall thickness"),
                                .area = optional_quantity(section, "Area"),
                                .second_moment_y = optional_quantity(section, "Second moment y"),
                                .second_moment_z = optional_quantity(section, "Second moment z"),
                                .torsion_constant = optional_quantity(section, "Torsion constant")};
  if (section.choice("Theory") == "Timoshenko")
    shape.theory = structure::BeamTheory::timoshenko;
  else if (section.choice("Theory") == "Rayleigh")
    shape.theory = structure::BeamTheory::rayleigh;
  if (section.has("Shear correction")) {
    const std::vector<double> factors = section.quantities("Shear correction");
    shape.shear_correction = {factors.front(), factors.back()};
  }
  return shape;
}

structure::Material read_material(const Values &material) {
  material.require("Young modulus");
  material.require("Density");
  return {material.quantity("Young modulus"), material.quantity("Poisson ratio"),
          material.quantity("Density")};
}

structure::Support read_support(const Values &section, const std::string &name) {
  structure::Support support{.name = name, .at = read_place(section)};
  for (const std::string &word : section.names("Fix"))
    fix(section, word, support);
  for (int axis = 0; axis < 3; ++axis) {
    if (section.has("Stiffness"))
      support.stiffness[axis] = section.quantities("Stiffness")[axis];
    if (section.has("Rotational stiffness"))
      support.stiffness[3 + axis] = section.quantities("Rotational stiffness")[axis];
  }
  if (!section.has("Fix") && !section.has("Stiffness") && !section.has("Rotational stiffness"))
    section.reject_section("Fix, Stiffness or Rotational stiffness must be set");
  return support;
}

namespace {

/// No body has a negative moment of inertia about any axis.
void check_inertia(const Values &section, const structure::Point &point) {
  Eigen::Matrix3d inertia = point.rotary_inertia.asDiagonal();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    inertia(i, j) = inertia(j, i) = -point.products_of_inertia[i];
  }
  const Vector3 principal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia).eigenvalues();
  if (principal[0] < -1e-12 * principal[2])
    section.reject(
        "Products of inertia",
        "must be small enough against Rotary inertia that no principal moment of inertia "
        "is negative");
}

} // namespace

structure::Point read_point(const Values &section, const std::string &name) {
  if (section.given("Arm"))
    section.reject("Arm", "must not be set when the body is not lumped");
  structure::Point point{.name = name, .at = read_place(section), .mass = section.quantity("Mass")};
  if (section.has("Rotary inertia"))
    point.rotary_inertia = vector3(section, "Rotary inertia");
  if (section.has("Products of inertia")) {
    point.products_of_inertia = vector3(section, "Products of inertia");
    check_inertia(section, point);
  }
  if (section.has("Offset")) {
    if (point.mass == 0)
      section.reject("Offset", "must not be set when Mass is 0 kg");
    point.offset = vector3(section, "Offset");
  }
  return point;
}

namespace {

std::vector<Vector3> grid_positions(const Values &section) {
  const std::vector<double> counts = section.quantities("Grid points");
  const std::size_t numbers = section.quantities("Grid").size();
  const bool plane = numbers == 9;
  if (numbers != 6 && !plane)
    section.reject("Grid", "must be the coordinates of two or of three places");
  if (counts.size() != (plane ? 2U : 1U))
    section.reject("Grid points", "must be one whole number for a line, two for a parallelogram");
  for (const double count : counts)
    if (count != std::floor(count) || count > 1e4)
      section.reject("Grid points", "must be whole numbers from 1 to 10000");
  const Vector3 corner = vector3(section, "Grid", 0);
  const Vector3 first = vector3(section, "Grid", 3) - corner;
  Vector3 second = Vector3::Zero();
  if (plane)
    second = vector3(section, "Grid", 6) - corner;
  const auto along = [](int i, double count) { return count > 1 ? i / (count - 1) : 0.5; };
  std::vector<Vector3> positions;
  for (int j = 0; j < (plane ? counts[1] : 1); ++j)
    for (int i = 0; i < counts[0]; ++i)
      positions.emplace_back(corner + along(i, counts[0]) * first +
                             (plane ? along(j, counts[1]) : 0) * second);
  return positions;
}

} // namespace

structure::Interface read_interface(const Values &section, const std::string &name) {
  structure::Interface interface {
    .name = name, .group = section.text("At"), .near = {}
  };
  if (section.has("Near") && section.has("Grid"))
    section.reject("Grid", "must not be set when Near is set");
  if (section.has("Grid") != section.has("Grid points"))
    section.reject_section("Grid and Grid points must both be set, or none of them");
  if (section.has("Grid")) {
    interface.near = grid_positions(section);
    interface.near_key = "Grid";
  }
  if (!section.has("Near"))
    return interface;
  const std::size_t numbers = section.quantities("Near").size();
  if (numbers % 3 != 0)
    section.reject("Near", "must be three coordinates for each position");
  for (std::size_t first = 0; first < numbers; first += 3)
    interface.near.push_back(vector3(section, "Near", first));
  return interface;
}

structure::Load read_load(const Values &section, const std::string &name) {
  structure::Load load{.name = name, .at = {}};
  const bool nodal = section.has("Force") || section.has("Moment");
  const bool placed =
      section.has("At") || section.has("Position") || section.has("Near") || section.has("Node");
  if (nodal)
    load.at = read_place(section);
  else if (placed)
    section.reject_section("Force or Moment must be set when At, Position, Near or Node is set");
  if (section.has("Force"))
    load.force = vector3(section, "Force");
  if (section.has("Moment"))
    load.moment = vector3(section, "Moment");
  if (section.has("Acceleration"))
    load.acceleration = vector3(section, "Acceleration");
  load.pressure = section.quantity("Pressure");
  load.on = section.text("On");
  if (!nodal && !section.has("Acceleration") && load.pressure == 0)
    section.reject_section("Force, Moment, Acceleration or Pressure must be set");
  return load;
}

std::vector<structure::Support> read_supports(const Values &body) {
  std::vector<structure::Support> supports;
  for (const std::string &name : body.instances("Support"))
    supports.push_back(read_support(body.instance("Support", name), name));
  return supports;
}

std::vector<structure::Point> read_points(const Values &body) {
  std::vector<structure::Point> points;
  for (const std::string &name : body.instances("Point"))
    points.push_back(read_point(body.instance("Point", name), name));
  return points;
}

std::optional<structure::SpinAxis> read_spin_axis(const Values &body) {
  if (!body.subsection_given("Spin axis"))
    return std::nullopt;
  const Values section = body.subsection("Spin axis");
  const Vector3 direction = vector3(section, "Direction");
  if (!(direction.norm() > 0))
    section.reject("Direction", "must not be zero");
  const bool rotating = section.choice("Frame") == "rotating";
  if (!rotating && section.given("Through"))
    section.reject("Through", "must not be set when Frame = fixed");
  return structure::SpinAxis{.direction = direction.normalized(),
                             .members = section.names("Members"),
                             .points = section.names("Points"),
                             .rotating_frame = rotating,
                             .through = vector3(section, "Through"),
                             .internal_damping = section.quantity("Internal damping")};
}

std::vector<structure::RigidLink> read_links(const Values &body) {
  const std::vector<std::string> points = body.instances("Point");
  const std::vector<std::string> members = body.instances("Member");
  std::vector<structure::RigidLink> links;
  for (const std::string &name : body.instances("Rigid link")) {
    const Values section = body.instance("Rigid link", name);
    structure::RigidLink link{.name = name,
                              .groups = section.names("At"),
                              .points = section.names("Points"),
                              .members = section.names("Members")};
    for (const std::string &point : link.points)
      section.require_known("Points", point, points);
    for (const std::string &member : link.members)
      section.require_known("Members", member, members);
    links.push_back(std::move(link));
  }
  return links;
}

std::vector<structure::Interface> read_interfaces(const Values &body) {
  const std::vector<std::string> points = body.instances("Point");
  std::vector<structure::Interface> interfaces;
  for (const std::string &name : body.instances("Interface")) {
    const Values section = body.instance("Interface", name);
    for (const std::string &point : points)
      if (point == name || point.starts_with(name + "."))
        section.reject_section("an Interface must not share its name with Point " + point +
                               ", as its own points are called " + name + ".1, " + name + ".2...");
    interfaces.push_back(read_interface(section, name));
  }
  return interfaces;
}

std::vector<structure::Load> read_loads(const Values &body) {
  std::vector<structure::Load> loads;
  for (const std::string &name : body.instances("Load"))
    loads.push_back(read_load(body.instance("Load", name), name));
  return loads;
}

} // namespace vibroimpact::reduction::sections
