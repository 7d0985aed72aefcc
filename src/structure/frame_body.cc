#include "structure/frame_body.h"

#include "structure/gmsh_reader.h"
#include "structure/hinges.h"
#include "structure/members.h"
#include "structure/mesh_check.h"

#include <algorithm>
#include <cmath>

namespace vibroimpact::structure {

namespace {

/// The lines of no member as one.
Member own_member(const BeamDefinition &definition) {
  Member member;
  member.section = definition.section;
  member.material = definition.material;
  member.local_y = definition.local_y;
  return member;
}

std::vector<int> lines_of(const FrameLines &lines, int member) {
  std::vector<int> own;
  for (std::size_t line = 0; line < lines.members.size(); ++line)
    if (lines.members[line] == member)
      own.push_back(static_cast<int>(line));
  return own;
}

bool changes_along(const Member &member) {
  return tapered(member.section) || member.axial_force.changes();
}

/// Fractions of the member at both ends of each of its lines; only those that change along it ask.
std::vector<std::array<double, 2>> places(const Mesh &mesh, const std::vector<int> &lines,
                                          const Member &member) {
  if (!changes_along(member))
    return std::vector<std::array<double, 2>>(lines.size(), {0, 0});
  return places_on_chains(mesh, lines, member.name.empty() ? "Section" : "Member", member.name);
}

std::shared_ptr<const SectionPlaces> section_places(const SectionShape &shape, double along) {
  const SectionShape local = shape_at(shape, along);
  return std::make_shared<const SectionPlaces>(
      SectionPlaces{extreme_fibres(local), section_outline(local)});
}

std::shared_ptr<const Element> element_of(const Mesh &mesh, const Member &member, int line,
                                          const std::array<double, 2> &along, const EndPlaces &ends,
                                          const FrameLines &lines) {
  const ElementFrame &frame = lines.frames[line];
  try {
    return std::make_shared<FrameElement>(
        mesh.lines[line],
        properties_along(member.section, member.material, member.axial_force, along[0], along[1]),
        frame, offset_of(member, frame), ends, lines.releases[line]);
  } catch (const NumericalError &error) {
    throw DefinitionError("Member", member.name, "",
                          "has hinges with which its line at " +
                              coordinates(mesh.nodes[mesh.lines[line][0]]) + " " + error.what());
  }
}

void add_member(BodyModel &model, const Member &member, const std::vector<int> &own,
                const FrameLines &lines) {
  const auto along = places(model.mesh, own, member);
  const auto uniform = section_places(member.section, 0);
  EndPlaces ends{uniform, uniform};
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (tapered(member.section))
      ends = {section_places(member.section, along[i][0]),
              section_places(member.section, along[i][1])};
    model.elements[own[i]] = element_of(model.mesh, member, own[i], along[i], ends, lines);
  }
  model.add_material(member.material);
  model.prestressed = model.prestressed || member.axial_force.any();
}

/// Keys of sections and materials are those of the member, if it has one of its own.
void add_named_member(BodyModel &model, const Member &member, const std::vector<int> &own,
                      const FrameLines &lines) {
  try {
    add_member(model, member, own, lines);
  } catch (const DefinitionError &error) {
    if (error.kind() == "Section" || error.kind() == "Material")
      throw DefinitionError("Member", member.name, error.key(), error.problem());
    throw;
  }
}

ElementFrame frame_of(const Mesh &mesh, int line, const std::string &member,
                      const std::optional<Vector3> &local_y) {
  const auto &[first, second] = mesh.lines[line];
  try {
    return element_frame(mesh.nodes[first], mesh.nodes[second], local_y);
  } catch (const DefinitionError &error) {
    throw member.empty() ? error
                         : DefinitionError("Member", member, "Orientation", error.problem());
  }
}

} // namespace

Mesh frame_mesh(const BeamDefinition &definition) {
  if (!definition.mesh_content.empty())
    return parse_gmsh(definition.mesh_content);
  Line line = definition.line;
  line.places = needed_places(definition);
  return generate_line(line);
}

FrameLines frame_lines(const Mesh &mesh, const BeamDefinition &definition) {
  check_line_mesh(mesh);
  FrameLines lines{.members = members_of_lines(mesh, definition), .frames = {}, .releases = {}};
  lines.releases = releases_of_lines(mesh, definition, lines.members);
  for (std::size_t line = 0; line < mesh.lines.size(); ++line) {
    const int member = lines.members[line];
    const bool own = member >= 0 && definition.members[member].local_y;
    lines.frames.push_back(frame_of(mesh, static_cast<int>(line),
                                    own ? definition.members[member].name : "",
                                    own ? definition.members[member].local_y : definition.local_y));
  }
  return lines;
}

Vector3 offset_of(const Member &member, const ElementFrame &frame) {
  return frame.axes.transpose() * Vector3(0, member.offset[0], member.offset[1]);
}

Member member_at(const BeamDefinition &definition, int position) {
  return position < 0 ? own_member(definition)
                      : definition.members[static_cast<std::size_t>(position)];
}

std::vector<PropertiesAlong> properties_of_lines(const Mesh &mesh, const BeamDefinition &definition,
                                                 const FrameLines &lines) {
  std::vector<PropertiesAlong> properties(mesh.lines.size());
  for (int m = -1; m < static_cast<int>(definition.members.size()); ++m) {
    const std::vector<int> own = lines_of(lines, m);
    if (own.empty())
      continue;
    const Member member = member_at(definition, m);
    const auto along = places(mesh, own, member);
    for (std::size_t i = 0; i < own.size(); ++i)
      properties[own[i]] = properties_along(member.section, member.material, member.axial_force,
                                            along[i][0], along[i][1]);
  }
  return properties;
}

void add_frame_elements(BodyModel &model, const BeamDefinition &definition,
                        const FrameLines &lines) {
  model.elements.resize(model.mesh.lines.size());
  for (std::size_t m = 0; m < definition.members.size(); ++m)
    add_named_member(model, definition.members[m], lines_of(lines, static_cast<int>(m)), lines);
  if (const std::vector<int> own = lines_of(lines, -1); !own.empty())
    add_member(model, own_member(definition), own, lines);
}

void check_rigid_lines(const BodyModel &model, const BeamDefinition &definition,
                       const std::vector<int> &members) {
  const auto within = [&](const std::vector<int> &nodes, const std::array<int, 2> &line) {
    return std::binary_search(nodes.begin(), nodes.end(), line[0]) &&
           std::binary_search(nodes.begin(), nodes.end(), line[1]);
  };
  for (std::size_t line = 0; line < members.size(); ++line)
    for (const std::vector<int> &nodes : model.rigid)
      if (members[line] >= 0 && definition.members[members[line]].axial_force.any() &&
          within(nodes, model.mesh.lines[line]))
        throw DefinitionError("Member", definition.members[members[line]].name, "Axial force",
                              "must be 0 N for lines within a Rigid link, but the one at " +
                                  coordinates(model.mesh.nodes[model.mesh.lines[line][0]]) + " is");
}

} // namespace vibroimpact::structure
