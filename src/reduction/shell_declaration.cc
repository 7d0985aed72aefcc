// What the subsections of a shell body may hold.
#include "reduction/shell_parameters.h"

namespace vibroimpact::reduction {

using parameters::Range;
using parameters::Section;
namespace dimension = parameters::dimension;
namespace range = parameters::range;

void declare_section_keys(Section &section, const std::string &rectangle) {
  const auto length = [&](const char *name, const char *symbol, const char *sentence,
                          const std::string &when) {
    section.quantity(name, "", dimension::length, range::positive, symbol, sentence).required(when);
  };
  section.choice("Shape", "rectangle", {"rectangle", "circle", "tube", "given"},
                 "rectangle: Width, Thickness; circle: Diameter; tube: Diameter, Wall thickness; "
                 "given: area, second moments and torsion constant.");
  length("Width", "b", "Along the local y axis.", rectangle);
  length("Thickness", "h", "Along the local z axis.", rectangle);
  length("Diameter", "d", "Outer diameter.", "Shape = circle or tube");
  length("Wall thickness", "t", "Of a tube.", "Shape = tube");
  section.quantity("Area", "", dimension::area, range::positive, "A", "Of a given section.")
      .required("Shape = given")
      .quantity("Second moment y", "", dimension::second_moment, range::positive, "I_y",
                "Integral of z^2: bending in the local x-z plane.")
      .required("Shape = given")
      .quantity("Second moment z", "", dimension::second_moment, range::positive, "I_z",
                "Integral of y^2: bending in the local x-y plane.")
      .required("Shape = given")
      .quantity("Torsion constant", "", dimension::second_moment, range::positive, "J",
                "St Venant torsion.")
      .required("Shape = given")
      .choice("Theory", "Euler-Bernoulli", {"Euler-Bernoulli", "Rayleigh", "Timoshenko"},
              "Euler-Bernoulli: slender beams; Rayleigh: with the rotary inertia of the section in "
              "bending; Timoshenko: with shear deformation besides.")
      .quantities("Shear correction", "", dimension::none,
                  Range{.lower = 0, .upper = 1, .lower_open = true}, "\\kappa",
                  "Factor of the area for shear forces, for both local axes or along y and z; "
                  "with Theory = Timoshenko. Without it: Cowper's for the shape (a given section "
                  "needs it).",
                  1, 2);
}

std::vector<std::string> section_keys() {
  return {"Shape",           "Width",           "Thickness",
          "Diameter",        "Wall thickness",  "Area",
          "Second moment y", "Second moment z", "Torsion constant",
          "Theory",          "Shear correction"};
}

void declare_shell_geometry(Section &geometry) {
  geometry
      .quantities("Plate", "", dimension::length, range::any, "",
                  "A parallelogram: one corner, then the ends of the first and of the second edge "
                  "that start there, x, y, z -> x, y, z -> x, y, z.",
                  9, 9)
      .required("Type = shell, and Mesh and Cylinder are not given")
      .quantities("Cylinder", "", dimension::length, range::any, "",
                  "Ends of the axis of a circular cylinder, x, y, z -> x, y, z.", 6, 6)
      .quantity("Radius", "", dimension::length, range::positive, "R", "Of the cylinder.")
      .required("Cylinder is given")
      .quantities("Angles", "0 deg, 360 deg", dimension::angle, range::any, "",
                  "First and last angle about the axis of the cylinder.", 2, 2)
      .quantities("Divisions", "10, 10", dimension::none, Range{.lower = 1}, "",
                  "Numbers of elements: along the first and the second edge of a plate, around and "
                  "along a cylinder, along the three edges of a block.",
                  2, 3)
      .choice("Cell shape", "quadrilateral", {"quadrilateral", "triangle"},
              "Of the elements of a plate or cylinder.");
}

void declare_own_material(Section &section) {
  section
      .quantity("Young modulus", "", dimension::stress, range::positive, "E",
                "Without it, that of Material.")
      .quantity("Poisson ratio", "", dimension::none,
                Range{.lower = -1, .upper = 0.5, .lower_open = true}, "\\nu",
                "Without it, that of Material.")
      .quantity("Density", "", dimension::density, range::non_negative, "\\rho",
                "Without it, that of Material.");
}

void declare_shells(Section &body) {
  Section &shell = body.named_subsection("Shell", "Thickness and material of surfaces.");
  shell.text("On", "all", "A physical group of surfaces of the mesh, or all surfaces.")
      .quantity("Thickness", "", dimension::length, range::positive, "t", "Of the surfaces.")
      .required();
  declare_own_material(shell);

  Section &stiffener = body.named_subsection(
      "Stiffener", "Beams along lines of a shell, fixed to its nodes: stiffeners, frames.");
  stiffener
      .text("On", "", "A physical group of lines of the mesh, or an edge of a plate or cylinder.")
      .required()
      .quantities("Orientation", "", dimension::none, range::any, "",
                  "Direction of the local y axis of the section. Without it, the local z axis is "
                  "the normal of the shell.",
                  3, 3)
      .quantities("Offset", "0 m, 0 m", dimension::length, range::any, "",
                  "From the nodes to the centre of the section along its local y and z axes: a "
                  "rigid link.",
                  2, 2)
      .quantity("Axial force", "0 N", dimension::force, range::any, "N",
                "That acts along the beams before any motion, tension positive.");
  declare_section_keys(stiffener);
  declare_own_material(stiffener);
}

} // namespace vibroimpact::reduction
