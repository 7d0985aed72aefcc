// Public cases of plates and shells, for tests and the verification.
#pragma once

#include "structure/mapped_mesh.h"
#include "structure/shell_examples.h"

namespace vibroimpact::examples {

/// All edges held across the plate; the tangential rotation there is held as well (hard support).
inline ShellDefinition simply_supported_plate(int elements,
                                              CellShape shape = CellShape::quadrilateral) {
  ShellDefinition shell = square_plate(elements, shape);
  hold_in_plane(shell);
  for (const char *edge : {"left", "right"})
    shell.supports.push_back({edge, {edge, {}}, {false, false, true, true, false, false}, {}});
  for (const char *edge : {"bottom", "top"})
    shell.supports.push_back({edge, {edge, {}}, {false, false, true, false, true, false}, {}});
  return shell;
}

/// NAFEMS FV22: clamped rhombus, side 10 m, 45 degrees, 1 m thick.
inline ShellDefinition clamped_rhombus(int elements, CellShape shape = CellShape::quadrilateral) {
  ShellDefinition shell = square_plate(elements, shape);
  shell.plate->second_end = {10 * std::sqrt(0.5), 10 * std::sqrt(0.5), 0};
  shell.parts[0].thickness = 1;
  hold_in_plane(shell);
  shell.supports.push_back({"clamp", {"edges", {}}, hold_all, {}});
  return shell;
}

inline constexpr std::array<bool, 6> symmetric_x = {true, false, false, false, true, true};
inline constexpr std::array<bool, 6> symmetric_y = {false, true, false, true, false, true};
inline constexpr std::array<bool, 6> symmetric_z = {false, false, true, true, true, false};
inline constexpr std::array<bool, 6> diaphragm_x = {false, true, true, false, false, false};

/// A quarter of the roof under its own weight, 90 per area. The point is the middle of the free
/// edge; its displacement along z is -0.3024.
inline ShellDefinition scordelis_lo_roof(int elements, CellShape shape = CellShape::quadrilateral) {
  ShellDefinition shell;
  shell.cylinder = structure::Cylinder{.start = {0, 0, 0},
                                       .end = {25, 0, 0},
                                       .radius = 25,
                                       .angles = {0, 40 * M_PI / 180},
                                       .zero = Vector3(0, 0, 1),
                                       .elements = {elements, elements},
                                       .shape = shape};
  shell.parts.push_back({"roof", "all", 0.25, {4.32e8, 0, 360}});
  shell.supports = {{"crown", {"left", {}}, symmetric_y, {}},
                    {"middle", {"bottom", {}}, symmetric_x, {}},
                    {"diaphragm", {"top", {}}, diaphragm_x, {}}};
  const double angle = 40 * M_PI / 180;
  shell.points.push_back(
      {"edge", {"", Vector3(0, -25 * std::sin(angle), 25 * std::cos(angle))}, 0, {0, 0, 0}});
  shell.loads.push_back(weight({0, 0, -1}));
  return shell;
}

/// An eighth of the cylinder between rigid diaphragms, pinched by two opposite unit forces. The
/// point is under the force; its displacement along z is -1.8248e-5.
inline ShellDefinition pinched_cylinder(int elements, CellShape shape = CellShape::quadrilateral) {
  ShellDefinition shell;
  shell.cylinder = structure::Cylinder{.start = {0, 0, 0},
                                       .end = {300, 0, 0},
                                       .radius = 300,
                                       .angles = {0, M_PI / 2},
                                       .zero = Vector3(0, 0, 1),
                                       .elements = {elements, elements},
                                       .shape = shape};
  shell.parts.push_back({"wall", "all", 3, {3e6, 0.3, 1}});
  shell.supports = {{"top", {"left", {}}, symmetric_y, {}},
                    {"side", {"right", {}}, symmetric_z, {}},
                    {"middle", {"bottom", {}}, symmetric_x, {}},
                    {"diaphragm", {"top", {}}, diaphragm_x, {}}};
  shell.points.push_back({"pinch", {"", Vector3(0, 0, 300)}, 0, {0, 0, 0}});
  shell.loads.push_back(force_at("pinch", {"", Vector3(0, 0, 300)}, {0, 0, -0.25}));
  return shell;
}

/// MacNeal's beam twisted by 90 degrees over its length: the elements are warped. The point is the
/// middle of its end; under a unit force along `axis` (1: within the width there, 2: across it) it
/// moves by the reference. `across` is even. On a skewed mesh the lines across the beam are slanted
/// by up to 42 degrees in the middle of its length: they are no longer straight lines of the
/// surface.
struct TwistedBeam {
  int along = 12;
  int across = 2;
  int axis = 1;
  CellShape shape = CellShape::quadrilateral;
  double thickness = 0.32; ///< or 0.0032
  bool skewed = false;
};
inline ShellDefinition twisted_beam(const TwistedBeam &beam) {
  ShellDefinition shell;
  const double slant = beam.skewed ? std::tan(42 * M_PI / 180) : 0;
  shell.mesh_content =
      mapped_mesh(beam.along, beam.across, beam.shape, [slant](double a, double b) {
        const double y = 1.1 * (b - 0.5);
        const double x = 12 * a + y * slant * std::sin(a * M_PI);
        const double angle = x / 12 * M_PI / 2;
        return Vector3(x, y * std::cos(angle), y * std::sin(angle));
      });
  shell.parts.push_back({"beam", "all", beam.thickness, {29e6, 0.22, 1}});
  shell.supports.push_back({"root", {"left", {}}, hold_all, {}});
  shell.points.push_back({"tip", {"", Vector3(12, 0, 0)}, 0, {0, 0, 0}});
  shell.loads.push_back(force_at("tip", {"", Vector3(12, 0, 0)}, Vector3::Unit(beam.axis)));
  return shell;
}
inline double twisted_beam_reference(const TwistedBeam &beam) {
  if (beam.thickness == 0.32)
    return beam.axis == 1 ? 1.754e-3 : 5.424e-3;
  return beam.axis == 1 ? 1294 : 5256;
}

/// Raasch's hook: two arcs, of 60 degrees with radius 14 and of 150 degrees with radius 46 the
/// other way round, 20 wide, 2 thick, clamped at the short arc. The point is at the end; under a
/// unit force along the width, spread over the end, it moves by 4.9352 along it. `along` is a
/// multiple of 9.
inline ShellDefinition raasch_hook(int along, int across,
                                   CellShape shape = CellShape::quadrilateral) {
  ShellDefinition shell;
  shell.mesh_content = mapped_mesh(along, across, shape, [](double a, double b) {
    constexpr double first = 60 * M_PI / 180;
    const double turned = std::min(a * 3, 1.0) * first; // a third of the elements in the short arc
    const double back = std::max(a - 1.0 / 3, 0.0) * 1.5 * 150 * M_PI / 180;
    const Vector3 bend(14 * std::sin(turned), 14 * (1 - std::cos(turned)), 20 * b);
    const Vector3 hook(46 * (std::sin(first) - std::sin(first - back)),
                       46 * (std::cos(first - back) - std::cos(first)), 0);
    return Vector3(bend + hook);
  });
  shell.parts.push_back({"hook", "all", 2, {3300, 0.35, 1}});
  shell.supports.push_back({"root", {"left", {}}, hold_all, {}});
  const double first = 60 * M_PI / 180;
  const double last = first - 150 * M_PI / 180;
  shell.points.push_back(
      {"end",
       {"", Vector3(14 * std::sin(first) + 46 * (std::sin(first) - std::sin(last)),
                    14 * (1 - std::cos(first)) + 46 * (std::cos(last) - std::cos(first)), 0)},
       0,
       {0, 0, 0}});
  for (int end = 0; end < 2; ++end) // the nodes at both corners bear half
    shell.loads.push_back(
        force_at("corner " + std::to_string(end),
                 {"", shell.points[0].at.position.value() + Vector3(0, 0, 20 * end)},
                 {0, 0, -0.5 / across}));
  shell.loads.push_back(force_at("end", {"right", {}}, {0, 0, 1.0 / across}));
  return shell;
}

/// Hyperbolic paraboloid over a unit square, clamped along x = -1/2, 1 mm thick, under 8000 times
/// its thickness per area. The point is the middle of the opposite side. With z = x^2 - y^2 the
/// lines of the mesh are lines of curvature and the elements flat; with z = 2 x y they are the
/// straight lines of the surface and the elements warped.
inline ShellDefinition hypar(int elements, bool warped,
                             CellShape shape = CellShape::quadrilateral) {
  ShellDefinition shell;
  shell.mesh_content = mapped_mesh(elements, elements, shape, [warped](double a, double b) {
    const double x = a - 0.5;
    const double y = b - 0.5;
    return Vector3(x, y, warped ? 2 * x * y : x * x - y * y);
  });
  shell.parts.push_back({"roof", "all", 1e-3, {2e11, 0.3, 8000}});
  shell.supports.push_back({"side", {"left", {}}, hold_all, {}});
  shell.points.push_back({"middle", {"", Vector3(0.5, 0, warped ? 0 : 0.25)}, 0, {0, 0, 0}});
  shell.loads.push_back(weight({0, 0, -1}));
  return shell;
}

/// A quarter of the hemisphere with a hole of 18 degrees, pulled and pushed by unit forces: nearly
/// all bending without stretching, the severest case for membrane locking. The point is where the
/// force along x acts; it moves by 0.094 along x.
inline ShellDefinition hemisphere(int elements, CellShape shape = CellShape::quadrilateral) {
  ShellDefinition shell;
  shell.mesh_content = mapped_mesh(elements, elements, shape, [](double a, double b) {
    const double around = a * M_PI / 2;
    const double up = b * 72 * M_PI / 180;
    return Vector3(10 * std::cos(up) * std::cos(around), 10 * std::cos(up) * std::sin(around),
                   10 * std::sin(up));
  });
  shell.parts.push_back({"shell", "all", 0.04, {6.825e7, 0.3, 1}});
  shell.supports = {{"y", {"left", {}}, symmetric_y, {}},
                    {"x", {"right", {}}, symmetric_x, {}},
                    {"z", {"", Vector3(10, 0, 0)}, {false, false, true, false, false, false}, {}}};
  shell.points.push_back({"pull", {"", Vector3(10, 0, 0)}, 0, {0, 0, 0}});
  shell.loads = {force_at("pull", {"", Vector3(10, 0, 0)}, {1, 0, 0}),
                 force_at("push", {"", Vector3(0, 10, 0)}, {0, -1, 0})};
  return shell;
}

inline constexpr double hemisphere_reference = 0.094;
inline constexpr double raasch_hook_reference = 4.9352;
inline constexpr double hypar_reference = -6.3941e-3; ///< z = x^2 - y^2
/// z = 2 x y: the value to which both elements converge.
inline constexpr double hypar_straight_reference = -4.9425e-2;
inline constexpr double scordelis_lo_reference = -0.3024;
inline constexpr double pinched_cylinder_reference = -1.8248e-5;
/// omega a^2 sqrt(rho t / D) of a free thin square plate with nu = 0.3: Ritz' method with products
/// of Legendre polynomials up to degree 16. Modes 4 to 6 lie 1 % below those of FV12.
inline const std::vector<double> free_plate_series = {13.4682, 19.5961, 24.2702,
                                                      34.8009, 34.8009, 61.0932};
/// [Hz]
inline const std::vector<double> free_plate_reference = {1.622, 2.360, 2.922, 4.233, 4.233, 7.416};
inline const std::vector<double> rhombus_reference = {133.95, 201.41, 265.81, 283.68, 334.45};

} // namespace vibroimpact::examples
