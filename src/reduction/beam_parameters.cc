#include "reduction/beam_parameters.h"

#include "reduction/body_sections.h"
#include "reduction/shell_parameters.h"

#include <algorithm>

namespace vibroimpact::reduction {

namespace {

using namespace sections;
using structure::BeamDefinition;
using structure::SectionShape;

void read_geometry(const Values &geometry, const std::string &folder, MPI_Comm communicator,
                   BeamDefinition &beam) {
  if (geometry.has("Mesh") && geometry.has("Line"))
    geometry.reject("Line", "must not be set when Mesh is set");
  if (geometry.has("Mesh")) {
    if (geometry.given("Elements"))
      geometry.reject("Elements", "must not be set when Mesh is set, which has its own");
    beam.mesh_content = read_mesh(geometry, folder, communicator);
  } else {
    geometry.require("Line");
    beam.line = {vector3(geometry, "Line", 0), vector3(geometry, "Line", 3),
                 static_cast<int>(geometry.integer("Elements"))};
  }
  if (geometry.has("Orientation"))
    beam.local_y = vector3(geometry, "Orientation");
}

SectionShape read_tapered_section(const Values &section) {
  check_use(section, "Shape",
            {{"End width", {"rectangle"}},
             {"End thickness", {"rectangle"}},
             {"End diameter", {"circle", "tube"}},
             {"End wall thickness", {"tube"}}});
  SectionShape shape = read_section(section);
  shape.end_width = optional_quantity(section, "End width");
  shape.end_thickness = optional_quantity(section, "End thickness");
  shape.end_diameter = optional_quantity(section, "End diameter");
  shape.end_wall_thickness = optional_quantity(section, "End wall thickness");
  return shape;
}

/// A member that gives any key of a cross-section has one of its own.
bool has_own_section(const Values &member) {
  std::vector<std::string> keys = section_keys();
  keys.insert(keys.end(), {"End width", "End thickness", "End diameter", "End wall thickness"});
  return std::any_of(keys.begin(), keys.end(),
                     [&](const std::string &key) { return member.given(key); });
}

structure::Member read_member(const Values &section, const std::string &name, const Values &body) {
  structure::Member member{.name = name, .on = section.text("On")};
  if (section.has("Between")) {
    if (section.given("On"))
      section.reject("On", "must not be set when Between is set");
    if (body.subsection("Geometry").has("Mesh"))
      section.reject("Between", "must not be set when Mesh is set, whose groups On names");
    const std::vector<double> between = section.quantities("Between");
    member.between = {between[0], between[1]};
  }
  member.section =
      read_tapered_section(has_own_section(section) ? section : body.subsection("Section"));
  member.material = own_material(section, body.subsection("Material"));
  if (section.has("Orientation"))
    member.local_y = vector3(section, "Orientation");
  const std::vector<double> offset = section.quantities("Offset");
  member.offset = {offset[0], offset[1]};
  member.axial_force = section.quantity("Axial force");
  if (section.has("End axial force"))
    member.axial_force.end = section.quantity("End axial force");
  return member;
}

structure::Hinge read_hinge(const Values &section, const std::string &name,
                            const std::vector<std::string> &members) {
  section.require("Member");
  section.require_known("Member", section.text("Member"), members);
  section.require("Free");
  structure::Hinge hinge{.name = name, .member = section.text("Member"), .at = read_place(section)};
  for (const std::string &word : section.names("Free")) {
    const std::vector<std::string> known = {"x", "y", "z", "rx", "ry", "rz"};
    section.require_known("Free", word, known);
    hinge.free[std::find(known.begin(), known.end(), word) - known.begin()] = true;
  }
  return hinge;
}

} // namespace

BeamDefinition read_beam_definition(const Values &body, const std::string &folder,
                                    MPI_Comm communicator) {
  BeamDefinition beam;
  read_geometry(body.subsection("Geometry"), folder, communicator, beam);
  const std::vector<std::string> members = body.instances("Member");
  for (const std::string &name : members)
    beam.members.push_back(read_member(body.instance("Member", name), name, body));
  for (const std::string &name : body.instances("Hinge"))
    beam.hinges.push_back(read_hinge(body.instance("Hinge", name), name, members));
  // Where members leave no line to them, there need be neither.
  if (members.empty() || body.subsection_given("Section"))
    beam.section = read_tapered_section(body.subsection("Section"));
  if (members.empty() || body.subsection_given("Material"))
    beam.material = read_material(body.subsection("Material"));
  beam.supports = read_supports(body);
  beam.points = read_points(body);
  beam.links = read_links(body);
  beam.interfaces = read_interfaces(body);
  beam.loads = read_loads(body);
  beam.spin = read_spin_axis(body);
  return beam;
}

} // namespace vibroimpact::reduction
