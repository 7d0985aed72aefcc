// What the subsections of a beam body may hold.
#include "reduction/beam_parameters.h"
#include "reduction/body_sections.h"
#include "reduction/shell_parameters.h"

namespace vibroimpact::reduction {

namespace {

using parameters::Range;
using parameters::Section;
namespace dimension = parameters::dimension;
namespace range = parameters::range;

void declare_taper(Section &section) {
  const auto length = [&](const char *name, const char *of) {
    section.quantity(name, "", dimension::length, range::positive, "",
                     std::string("At the end of a tapered beam; ") + of +
                         " changes linearly from the start. Without it: as at the start.");
  };
  length("End width", "Width");
  length("End thickness", "Thickness");
  length("End diameter", "Diameter");
  length("End wall thickness", "Wall thickness");
}

void declare_member(Section &body) {
  Section &member = body.named_subsection(
      "Member",
      "Lines of a beam body with a section, material, orientation, offset or axial force "
      "of their own; without keys of a section, that of Section. Lines of no Member have Section "
      "and Material.");
  member
      .text("On", "all",
            "A physical group of lines of the mesh, or all lines. A tapered member runs in the "
            "direction of its lines; a group may hold several that share no node.")
      .quantities("Between", "", dimension::length, range::non_negative, "",
                  "Instead of On: part of the generated Line, two distances from its start. Nodes "
                  "are placed at both.",
                  2, 2);
  declare_section_keys(member, "Shape = rectangle and any key of a section is given");
  declare_taper(member);
  declare_own_material(member);
  member
      .quantities("Orientation", "", dimension::none, range::any, "",
                  "Direction of the local y axis. Without it, that of Geometry.", 3, 3)
      .quantities("Offset", "0 m, 0 m", dimension::length, range::any, "",
                  "From the nodes to the axis along its local y and z axes: rigid arms.", 2, 2)
      .quantity("Axial force", "0 N", dimension::force, range::any, "N",
                "That acts along the member before any motion, tension positive: it changes the "
                "frequencies (geometric stiffness). Compression stays below the buckling load.")
      .quantity("End axial force", "", dimension::force, range::any, "N_1",
                "At the end of the member; it changes linearly from Axial force at its start, as "
                "under weight. Without it: the same along the member.");
}

void declare_hinge(Section &body) {
  Section &hinge = body.named_subsection(
      "Hinge", "Ends of a member that do not follow all motions of their nodes.");
  hinge.text("Member", "", "Name of the member whose lines end there.").required();
  sections::declare_place(hinge);
  hinge
      .names("Free", "",
             "Motions of the end that the node does not share, along and about the local axes of "
             "the member: any of x, y, z, rx, ry, rz.")
      .required();
}

} // namespace

void declare_beams(Section &body) {
  Section &section = body.subsection("Section", "The cross-section of a beam.");
  declare_section_keys(section);
  declare_taper(section);
  declare_member(body);
  declare_hinge(body);
}

} // namespace vibroimpact::reduction
