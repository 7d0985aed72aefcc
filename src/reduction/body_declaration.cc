// What a `subsection Body NAME` may hold.
#include "reduction/beam_parameters.h"
#include "reduction/body_parameters.h"
#include "reduction/body_sections.h"
#include "reduction/matrix_parameters.h"
#include "reduction/modal_parameters.h"
#include "reduction/shell_parameters.h"
#include "reduction/solid_parameters.h"

namespace vibroimpact::reduction {

namespace {

using parameters::Range;
using parameters::Section;
using sections::declare_place;
namespace dimension = parameters::dimension;
namespace range = parameters::range;

void declare_geometry(Section &body) {
  body.subsection("Geometry",
                  "The line or mesh along which a beam runs, the surfaces of a shell, or the "
                  "hexahedra of a solid.")
      .text("Mesh", "",
            "Gmsh file (version 2.2 or 4.1, ASCII or binary) with lines for a beam, triangles and "
            "quadrilaterals for a shell, hexahedra for a solid, relative to the folder of the "
            "parameter file. Instead of it: Line for a beam, Plate or Cylinder for a shell, Block "
            "for a solid. For matrices: the input deck of "
            "CalculiX or Abaqus (nodes, elements, sets of nodes), which says where the nodes are "
            "and what is seen of the body; its sets are places by their names in capitals.")
      .quantities("Line", "", dimension::length, range::any, "",
                  "Ends of a straight beam, x, y, z -> x, y, z. Either this or Mesh.", 6, 6)
      .required("Type = beam and Mesh is not given")
      // The stiffness matrix has a condition of about the fourth power: 1/eps at 10^4 elements.
      .integer("Elements", "40", Range{.lower = 1, .upper = 1e4}, "",
               "Number of equal elements along Line. Where nodes must lie elsewhere too (a "
               "Position, the "
               "ends of a Member), the parts between them have equal elements that are no longer.")
      .quantities("Orientation", "", dimension::none, range::any, "",
                  "Direction of the local y axis, the first dimension of the cross-section; only "
                  "its part normal to the beam counts. Without it: global y, or global z for "
                  "elements along y. For a Cylinder: the direction of angle zero, x or else y "
                  "without it.",
                  3, 3);
  declare_shell_geometry(body.subsection("Geometry", ""));
  declare_solid_geometry(body.subsection("Geometry", ""));
}

void declare_material(Section &body) {
  body.subsection("Material", "The linear elastic material of a beam, shell or solid.")
      .quantity("Young modulus", "", dimension::stress, range::positive, "E", "Of the material.")
      .required("Type = beam, or shell or solid with a section that has none")
      .quantity(
          "Poisson ratio", "0.3", dimension::none,
          Range{.lower = -1, .upper = 0.5, .lower_open = true}, "\\nu",
          "Counts for the torsion of beams, for shells and for solids, where it is less than 0.5.")
      .quantity("Density", "", dimension::density, range::non_negative, "\\rho",
                "0 for a massless body between lumped masses.")
      .required("Type = beam, or shell or solid with a section that has none")
      .quantity(
          "Yield stress", "", dimension::stress, range::positive, "\\sigma_y",
          "Of the whole body. Recorded von Mises stresses beyond it are reported; it changes no "
          "result.");
}

void declare_support(Section &body) {
  Section &support =
      body.named_subsection("Support", "Degrees of freedom that are held, or tied to the base.");
  declare_place(support);
  support
      .names("Fix", "",
             "Any of x, y, z (displacements), rx, ry, rz (rotations), pinned (x, y, z), all, and "
             "symmetric x, symmetric y, symmetric z (at a plane of symmetry with this normal).")
      .quantities("Stiffness", "", dimension::stiffness, range::non_negative, "k",
                  "Springs to the base along x, y, z.", 3, 3)
      .quantities("Rotational stiffness", "", dimension::rotational_stiffness, range::non_negative,
                  "k_\\theta", "Springs to the base about x, y, z.", 3, 3);
}

void declare_point(Section &body) {
  Section &point = body.named_subsection(
      "Point", "A named node: it can be touched, pushed and observed, and carry a lumped mass. "
               "Or a place that a mass of a lumped body carries.");
  declare_place(point);
  point.quantity("Mass", "0 kg", dimension::mass, range::non_negative, "m", "Lumped mass.")
      .quantities("Rotary inertia", "", dimension::rotary_inertia, range::non_negative, "J",
                  "Of the lumped mass about axes along x, y, z through its centre.", 3, 3)
      .quantities("Products of inertia", "", dimension::rotary_inertia, range::any, "",
                  "Of the lumped mass: its integrals of x y, y z and z x from its centre.", 3, 3)
      .quantities("Offset", "", dimension::length, range::any, "",
                  "From the node to the centre of the lumped mass along x, y, z: a rigid arm. The "
                  "point itself stays at the node.",
                  3, 3)
      .quantities("Arm", "0 m, 0 m, 0 m", dimension::length, range::any, "r",
                  "Of a lumped body: from the centre of the mass that At names to the point, along "
                  "x, y, z. Where the mass turns, the point moves by u + theta x r.",
                  3, 3);
  declare_modal_point(point);
}

void declare_link(Section &body) {
  body.named_subsection(
          "Rigid link",
          "Nodes of a beam, shell or solid that move together like one rigid body. It is exact: "
          "their "
          "motion is eliminated, no large stiffness stands in for it. Elements between them do not "
          "deform, but their mass counts. Links that share a node are one.")
      .names("At", "",
             "Groups of nodes: start or end of a generated line; left, right, bottom, top or edges "
             "of a plate or cylinder; faces and edges of a block; physical groups of the mesh.")
      .names("Points", "", "Names of points of the body, whose nodes come in addition.")
      .names("Members", "",
             "Names of members of a beam: each connected part of their lines is rigid by itself.");
}

void declare_interface(Section &body) {
  body.named_subsection(
          "Interface",
          "Nodes of a beam, shell or solid at which it can touch: a Contact with a Pairing makes a "
          "contact "
          "of each. They are called NAME.1, NAME.2... in the order of their coordinates (x first), "
          "or in that of Near or Grid.")
      .text("At", "all",
            "The nodes to choose from: start or end of a generated line; left, right, bottom, top "
            "or edges of a plate or cylinder; a face or edge of a block; the name of a physical "
            "group of the mesh; or all.")
      .quantities("Near", "", dimension::length, range::any, "",
                  "Coordinates, three for each position: only the nodes nearest to these. Without "
                  "Near and Grid: all nodes of At.",
                  3, std::numeric_limits<int>::max())
      .quantities("Grid", "", dimension::length, range::any, "",
                  "Two ends of a line, or a corner and the ends of the two edges from it: only the "
                  "nodes nearest to equally spaced points of the line or parallelogram.",
                  6, 9)
      .quantities("Grid points", "", dimension::none, Range{.lower = 1}, "",
                  "Points of the Grid along the line, or along the first and second edge, ends "
                  "included; a single one lies in the middle.",
                  1, 2);
}

void declare_load(Section &body) {
  Section &load = body.named_subsection(
      "Load",
      "What acts on a beam, shell or solid in its static solution, which is part of the results "
      "of every run (figures under static in the summary and in ParaView). All loads act "
      "together. It does not act in any other analysis.");
  declare_place(load, "Force or Moment is given, and Position, Near and Node are not");
  load.quantities("Force", "", dimension::force, range::any, "F", "On each node of the place.", 3,
                  3)
      .quantities("Moment", "", dimension::torque, range::any, "M", "On each node of the place.", 3,
                  3)
      .quantities("Acceleration", "", dimension::acceleration, range::any, "g",
                  "Of gravity: acts on all mass.", 3, 3)
      .quantity("Pressure", "0 Pa", dimension::stress, range::any, "p",
                "Pushes along the normal of a shell, which follows the numbering of its cells by "
                "the right-hand rule; against the outer faces of a solid.")
      .text(
          "On", "all",
          "Group of surfaces under pressure; all: every surface of a shell, every outer face of a "
          "solid.");
}

void declare_modes(Section &body) {
  body.subsection("Modes",
                  "Which normal modes of a beam, shell or solid are kept, and their damping.")
      .integer("Number", "5", Range{.lower = 1, .upper = 1e5}, "n",
               "The lowest modes. Either this or Band.")
      .quantities("Band", "", dimension::frequency, range::non_negative, "",
                  "Lower and upper frequency: all modes between them.", 2, 2)
      .choice("Damping model", "ratio", {"ratio", "rayleigh", "viscous"},
              "ratio: a fraction of critical damping for each mode; rayleigh: alpha M + beta K; "
              "viscous: external damping spread like the mass of the body.")
      .quantities("Damping ratio", "0", dimension::none, range::non_negative, "\\zeta",
                  "One for each kept mode; the last one repeats.", 1,
                  std::numeric_limits<int>::max())
      .names(
          "Attachments", "",
          "Places as POINT.x, POINT.y or POINT.z, or INTERFACE.x and so on for all its nodes: the "
          "static response to a force there, less the part of the normal modes, is kept beside "
          "them (residual attachment modes).")
      .choice("Reduction", "free interface", {"free interface", "fixed interface"},
              "free interface: normal modes of the body as it is, and residual attachment modes; "
              "fixed interface: normal modes of the body held at its Attachments, and its static "
              "shapes when one of these moves (Craig-Bampton).")
      .quantity("Attachment damping ratio", "", dimension::none, range::non_negative, "\\zeta_a",
                "Of the attachment modes, or of the highest as many modes of the fixed interface; "
                "with damping model ratio. Without it: the last Damping ratio.")
      .quantity("Rayleigh alpha", "", dimension::inverse_time, range::non_negative, "\\alpha",
                "Factor of the mass matrix.")
      .quantity("Rayleigh beta", "", dimension::time, range::non_negative, "\\beta",
                "Factor of the stiffness matrix.")
      .quantity("Viscous constant", "", dimension::damping, range::non_negative, "c",
                "External damping of the whole body, without lumped masses.")
      .required("Damping model = viscous")
      .text("Store", "",
            "File that keeps the reduced body for later runs, relative to the folder of the "
            "parameter file; computed anew when the definition of the body has changed.");
}

void declare_mass(Section &body) {
  Section &mass =
      body.named_subsection("Mass", "A mass of a lumped body; it is also a point of that name.");
  mass.quantity("Mass", "", dimension::mass, range::positive, "m", "Of the point.")
      .required("Axis names x, y or z")
      .names("Axis", "x",
             "How it moves: along any of x, y, z, and turns about axes along these, rx, ry, rz; a "
             "coordinate for each.")
      .quantity("Stiffness", "0 N/m", dimension::stiffness, range::non_negative, "k",
                "Spring to the base along each axis.")
      .quantity("Damping", "0 N s/m", dimension::damping, range::non_negative, "c",
                "Dashpot to the base along each axis.")
      .quantities("Rotary inertia", "", dimension::rotary_inertia, range::positive, "J",
                  "About an axis through the centre: one value for all, or three about x, y, z.", 1,
                  3)
      .required("Axis names rx, ry or rz")
      .quantity("Rotational stiffness", "0 N m", dimension::rotational_stiffness,
                range::non_negative, "k_\\theta", "Spring to the base about each axis [N m/rad].")
      .quantity("Rotational damping", "0 N m s", dimension::rotational_damping, range::non_negative,
                "c_\\theta", "Dashpot to the base about each axis.")
      .quantity("Damping ratio", "", dimension::none, range::non_negative, "\\zeta",
                "Instead of both dashpots: of each coordinate by itself on its spring to the base, "
                "c = 2 zeta sqrt(k m).")
      .quantities("Position", "0 m, 0 m, 0 m", dimension::length, range::any, "",
                  "Where it stands in figures.", 3, 3);
}

void declare_spin_axis(Section &body) {
  body.subsection("Spin axis",
                  "The axis about which a beam or lumped body turns at the speed that a section "
                  "Spin gives.")
      .quantities("Direction", "1, 0, 0", dimension::none, range::any, "a",
                  "Of the axis, about which a positive speed turns.", 3, 3)
      .choice("Frame", "fixed", {"fixed", "rotating"},
              "Of the displacements. fixed: shafts, whose sections and lumped masses are round and "
              "have gyroscopic moments; rotating: displacements turn with the body, which has "
              "centrifugal and Coriolis forces.")
      .quantities("Through", "0 m, 0 m, 0 m", dimension::length, range::any, "",
                  "A place of the axis, for Frame = rotating.", 3, 3)
      .quantity("Internal damping", "0 s", dimension::time, range::non_negative, "\\tau",
                "Of what turns, losses that turn with it: stress E (strain + tau strain rate) of "
                "the members, and in the springs to the base of lumped masses. In the fixed frame "
                "it drives forward whirl at speeds above the critical one.")
      .names("Members", "",
             "Members of a beam that turn; empty: all lines. In the fixed frame they lie along the "
             "axis, and those with mass have Theory = Rayleigh or Timoshenko.")
      .names("Points", "",
             "Points of a beam whose lumped mass turns, or masses of a lumped body; empty: all.");
}

void declare_rotor(Section &body) {
  body.subsection("Rotor", "An unbalanced rotor that turns at a point of another body.")
      .text("At", "", "Point that carries it, as BODY.POINT.")
      .required("Type = rotor")
      .quantity("Mass", "", dimension::mass, range::positive, "m_R",
                "Mass of the rotor, which comes on top of the carrying body.")
      .required("Type = rotor")
      .quantity("Eccentricity", "0 m", dimension::length, range::non_negative, "e",
                "Distance of the centre of mass from the axis.")
      .quantity("Inertia", "", dimension::rotary_inertia, range::positive, "J",
                "Moment of inertia about the centre of mass.")
      .required("Type = rotor")
      .quantity("Friction", "0 N m s", dimension::rotational_damping, range::non_negative, "c",
                "Resisting torque per angular speed.")
      .text("First direction", "x", "Direction of the eccentricity at angle zero.")
      .text("Second direction", "y", "Direction towards which the rotor turns from there.")
      .quantity("Initial angle", "0 rad", dimension::angle, range::any, "\\varphi_0",
                "Angle at the start.")
      .quantity("Initial speed", "0 rad/s", dimension::frequency, range::any, "\\omega_0",
                "Angular speed at the start.");
  body.subsection("Motor", "The motor of a rotor: tau M' + M = M_Z - k_M omega. Without it the "
                           "rotor turns freely.")
      .quantity("Starting torque", "", dimension::torque, range::any, "M_Z", "Torque at rest.")
      .required("there is a Motor")
      .quantity("Slope", "", dimension::rotational_damping, range::positive, "k_M",
                "Loss of torque per angular speed.")
      .required("there is a Motor")
      .quantity("Time constant", "", dimension::time, range::positive, "\\tau",
                "Electromagnetic time constant.")
      .required("there is a Motor")
      .quantity("Torque constant", "1 N m", dimension::torque, range::positive, "k_p",
                "Torque per ampere of current.")
      .quantity("Initial torque", "0 N m", dimension::torque, range::any, "M_0",
                "Torque at the start.");
}

} // namespace

void declare_body(Section &root) {
  Section &body = root.named_subsection("Body", "A deformable or lumped body with named points.");
  body.choice("Type", "beam", {"beam", "shell", "solid", "matrices", "lumped", "rotor", "modes"},
              "beam: normal modes of a frame of beams; shell: normal modes of plates and "
              "shells with their stiffeners; solid: normal modes of solids of hexahedra; matrices: "
              "normal modes of stiffness and mass matrices "
              "of another program; lumped: masses, springs, dashpots; rotor: an "
              "unbalanced rotor with its motor on a point of another body; modes: known modes, "
              "from a test, another program or the results of a run.");
  body.choice("Planar", "no", {"no", "xy", "yz", "zx"},
              "The plane in which a beam, shell or solid moves: the displacement out of it and the "
              "rotations that turn it out of the plane are held at all nodes. no: it moves in "
              "space.");
  declare_geometry(body);
  declare_beams(body);
  declare_matrices(body);
  declare_material(body);
  declare_support(body);
  declare_point(body);
  declare_link(body);
  declare_interface(body);
  declare_shells(body);
  declare_solids(body);
  declare_load(body);
  declare_modes(body);
  declare_modal_data(body);
  declare_mass(body);
  declare_rotor(body);
  declare_spin_axis(body);
}

} // namespace vibroimpact::reduction
